// What a run leaves behind: the log of both buses, and the permanent error memory. Both are written about
// once a second; what cannot be written is said once, tried again, and does not stop the gateway.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "media/log_stream.hpp"
#include "runtime/error_memory.hpp"
#include "runtime/events.hpp"

namespace cgw::runtime {

// Names of the two sides in logs.
std::string_view interface_name(Side side);  // "can1", "can2"

class Keeper {
  public:
    // `complain` gets lines for people.
    Keeper(std::optional<media::LogStream> log, std::optional<ErrorMemory> memory,
           std::function<void(std::string_view)> complain)
        : log_(std::move(log)), memory_(std::move(memory)), complain_(std::move(complain)) {}

    bool has_work() const { return log_ || memory_; }
    const std::optional<ErrorMemory>& memory() const { return memory_; }
    const std::optional<media::LogStream>& log() const { return log_; }

    // `wall_time` in microseconds since 1970.
    void record(Side side, const frame::Frame& frame, std::uint64_t wall_time);
    void write(const Sentinels& sentinels);

    // After the last write(): everything is in its file.
    bool complete() const { return !failed_memory_ && log_complete(); }
    bool log_complete() const {
        return !failed_log_ && (!log_ || (log_->dropped() == 0 && !log_->waiting()));
    }

  private:
    void follow(const base::Result<void>& result, std::string_view what, bool& failed);

    std::optional<media::LogStream> log_;
    std::optional<ErrorMemory> memory_;
    std::function<void(std::string_view)> complain_;
    bool failed_log_ = false;
    bool failed_memory_ = false;
};

}  // namespace cgw::runtime
