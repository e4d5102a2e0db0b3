// Reads a log of either kind and writes the other, or the same: convert_log FROM TO. The format of TO follows
// from its name. For tests with other programs' files.
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "base/files.hpp"
#include "media/log.hpp"

namespace {

using namespace cgw;

base::Result<void> convert(const std::string& from, const std::string& to) {
    const auto format = media::log_format_of(to);
    if (!format) {
        return base::failure(fmt::format("{}: neither .log nor .pcap", to));
    }
    const auto content = base::read_file(from, media::largest_log);
    if (!content) {
        return tl::unexpected(content.error());
    }
    const auto log = media::read_log(*content, from);
    if (!log) {
        return tl::unexpected(log.error());
    }
    const auto bytes = media::write_log(*format, log->frames);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    return base::write_file(to, *bytes);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        fmt::print(stderr, "usage: convert_log FROM TO\n");
        return 2;
    }
    const base::Result<void> converted = convert(arguments[1], arguments[2]);
    if (!converted) {
        fmt::print(stderr, "{}\n", converted.error().message);
        return 1;
    }
    return 0;
}
