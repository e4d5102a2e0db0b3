#include "media/log_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace cgw::media {
namespace {

constexpr std::size_t piece_size = std::size_t{64} << 10;

auto cannot_read(const std::string& path) {
    return base::failure(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
}

}  // namespace

base::Result<LogFile> LogFile::open(const std::string& path) {
    Descriptor file(path == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) {
        return cannot_read(path);
    }
    return LogFile(path, std::move(file));
}

base::Result<void> LogFile::feed(LogReader& reader) {
    piece_.resize(piece_size);
    ssize_t count = -1;
    do {
        count = ::read(file_.get(), piece_.data(), piece_.size());
    } while (count < 0 && errno == EINTR);
    if (count < 0) {
        return cannot_read(path_);
    }
    if (count == 0) {
        reader.finish();
    } else {
        reader.feed(std::string_view(piece_).substr(0, static_cast<std::size_t>(count)));
    }
    return {};
}

}  // namespace cgw::media
