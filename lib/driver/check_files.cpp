#include "driver/check_files.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace cgw::driver {
namespace {

struct Outcome {
    std::optional<CheckedFile> file;
    std::exception_ptr failure;
};

Outcome outcome_of(const std::string& path) {
    try {
        return {check_file_or_catalogue(path), nullptr};
    } catch (...) {
        return {std::nullopt, std::current_exception()};
    }
}

// Workers take the next path each; results wait in `done_` until it is their turn. A worker that is too far
// ahead of the taker waits, so that a slow first file does not pile up all others.
class Queue {
  public:
    Queue(std::span<const std::string> paths, unsigned threads) : paths_(paths), ahead_(threads * 4ULL) {
        workers_.reserve(threads);
        for (unsigned i = 0; i < threads; ++i) {
            workers_.emplace_back([this] { work(); });
        }
    }
    Queue(const Queue&) = delete;
    Queue& operator=(const Queue&) = delete;

    ~Queue() {
        {
            const std::lock_guard lock(mutex_);
            next_ = paths_.size();  // nothing left to begin
            taken_ = paths_.size();
        }
        room_.notify_all();
        for (std::thread& worker : workers_) {
            worker.join();
        }
    }

    // The result for the next path.
    Outcome take() {
        std::unique_lock lock(mutex_);
        ready_.wait(lock, [this] { return done_.contains(taken_); });
        Outcome outcome = std::move(done_.extract(taken_).mapped());
        ++taken_;
        lock.unlock();
        room_.notify_all();
        return outcome;
    }

  private:
    void work() {
        std::unique_lock lock(mutex_);
        while (true) {
            room_.wait(lock, [this] { return next_ >= paths_.size() || next_ < taken_ + ahead_; });
            if (next_ >= paths_.size()) {
                return;
            }
            const std::size_t index = next_++;
            lock.unlock();
            Outcome outcome = outcome_of(paths_[index]);
            lock.lock();
            done_.emplace(index, std::move(outcome));
            ready_.notify_one();
        }
    }

    std::span<const std::string> paths_;
    std::size_t ahead_;
    std::mutex mutex_;
    std::condition_variable ready_;  // a result came
    std::condition_variable room_;   // a result was taken, or the end came
    std::size_t next_ = 0;           // path to begin
    std::size_t taken_ = 0;          // results taken
    std::map<std::size_t, Outcome> done_;
    std::vector<std::thread> workers_;
};

}  // namespace

void check_files(std::span<const std::string> paths, unsigned threads,
                 const std::function<void(CheckedFile&&)>& take) {
    if (threads <= 1 || paths.size() <= 1) {
        for (const std::string& path : paths) {
            take(check_file_or_catalogue(path));
        }
        return;
    }
    Queue queue(paths, static_cast<unsigned>(std::min<std::size_t>(threads, paths.size())));
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Outcome outcome = queue.take();
        if (outcome.failure) {
            std::rethrow_exception(outcome.failure);
        }
        take(std::move(*outcome.file));
    }
}

}  // namespace cgw::driver
