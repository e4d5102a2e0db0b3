// A log in a file or a pipe, for LogReader: the next piece each time it is hungry.
#pragma once

#include <string>

#include "base/result.hpp"
#include "media/descriptor.hpp"
#include "media/log_reader.hpp"

namespace cgw::media {

class LogFile {
  public:
    // "-" is standard input. The failure begins "cannot read FILE: ".
    static base::Result<LogFile> open(const std::string& path);

    // Feeds one piece, or finishes at the end of the file.
    base::Result<void> feed(LogReader& reader);

  private:
    LogFile(std::string path, Descriptor file) : path_(std::move(path)), file_(std::move(file)) {}

    std::string path_;
    Descriptor file_;
    std::string piece_;
};

}  // namespace cgw::media
