#include "media/log.hpp"

#include <array>

#include "base/ascii.hpp"
#include "media/candump.hpp"
#include "media/pcap.hpp"

namespace cgw::media {
namespace {

struct Ending {
    std::string_view text;
    LogFormat format;
};

constexpr std::array endings = {
    Ending{".log", LogFormat::candump},
    Ending{".pcap", LogFormat::pcap},
    Ending{".cap", LogFormat::pcap},
};

base::Bytes write_candump(std::span<const LoggedFrame> frames) {
    base::Bytes content;
    for (const LoggedFrame& logged : frames) {
        const std::string line = candump_line(logged);
        content.insert(content.end(), line.begin(), line.end());
        content.push_back('\n');
    }
    return content;
}

}  // namespace

std::optional<LogFormat> log_format_of(std::string_view file_name) {
    const std::string name = base::lowered(file_name);
    for (const Ending& ending : endings) {
        if (name.ends_with(ending.text)) {
            return ending.format;
        }
    }
    return std::nullopt;
}

base::Result<Log> read_log(std::string_view content, const std::string& name) {
    return is_pcap(content) ? read_pcap(content, name) : read_candump(content, name);
}

base::Result<base::Bytes> write_log(LogFormat format, std::span<const LoggedFrame> frames) {
    return format == LogFormat::pcap ? write_pcap(frames) : base::Result<base::Bytes>(write_candump(frames));
}

}  // namespace cgw::media
