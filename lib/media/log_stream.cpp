#include "media/log_stream.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "media/candump.hpp"
#include "media/pcap.hpp"

namespace cgw::media {
namespace {

auto cannot_write(const std::string& path) {
    return base::failure(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
}

}  // namespace

base::Result<LogStream> LogStream::open(const std::string& path, LogFormat format) {
    // A pipe nobody reads must not stop the program that writes the log.
    constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_CLOEXEC;
    constexpr mode_t mode = 0666;  // umask narrows it
    Descriptor file(::open(path.c_str(), flags, mode));
    if (!file) {
        return cannot_write(path);
    }
    LogStream stream(path, format, std::move(file));
    if (format == LogFormat::pcap) {
        append_pcap_header(stream.waiting_);
    }
    return stream;
}

void LogStream::record(const LoggedFrame& logged) {
    if (waiting_.size() >= most_waiting) {
        ++dropped_;
        return;
    }
    if (format_ == LogFormat::pcap) {
        append_pcap_record(waiting_, logged);
    } else {
        const std::string line = candump_line(logged);
        waiting_.insert(waiting_.end(), line.begin(), line.end());
        waiting_.push_back('\n');
    }
    ++frames_;
}

base::Result<void> LogStream::flush() {
    std::size_t written = 0;
    bool fine = true;
    while (fine && written < waiting_.size()) {
        const ssize_t count = ::write(file_.get(), waiting_.data() + written, waiting_.size() - written);
        fine = count >= 0 || errno == EINTR;
        written += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    const int error = errno;
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(written));
    if (fine || error == EAGAIN) {
        return {};
    }
    errno = error;
    return cannot_write(path_);
}

}  // namespace cgw::media
