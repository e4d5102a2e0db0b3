// A log that grows while frames come, for runs without an end. Only whole records stand in memory, and only
// until the next flush.
#pragma once

#include <cstdint>
#include <string>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "media/descriptor.hpp"
#include "media/log.hpp"

namespace cgw::media {

class LogStream {
  public:
    // Bytes that may wait for a file that takes nothing (disk full), some 80,000 frames.
    static constexpr std::size_t most_waiting = std::size_t{4} << 20;

    // Creates the file or empties it. The failure begins "cannot write FILE: ".
    static base::Result<LogStream> open(const std::string& path, LogFormat format);

    // Frames beyond most_waiting are not recorded, but counted.
    void record(const LoggedFrame& logged);

    // Writes what waits. After a failure what is left still waits; the file goes on where it stopped.
    base::Result<void> flush();

    const std::string& path() const { return path_; }
    std::uint64_t frames() const { return frames_; }    // recorded
    std::uint64_t dropped() const { return dropped_; }  // not recorded
    bool waiting() const { return !waiting_.empty(); }

  private:
    LogStream(std::string path, LogFormat format, Descriptor file)
        : path_(std::move(path)), format_(format), file_(std::move(file)) {}

    std::string path_;
    LogFormat format_;
    Descriptor file_;
    base::Bytes waiting_;
    std::uint64_t frames_ = 0;
    std::uint64_t dropped_ = 0;
};

}  // namespace cgw::media
