#include "media/pcap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace cgw::media {
namespace {

constexpr std::uint32_t link_type_can = 227;
constexpr std::uint32_t link_type_mask = 0xFFFF;  // the upper half of the field says other things
constexpr std::uint16_t major_version = 2;
constexpr std::uint16_t minor_version = 4;
constexpr std::uint32_t longest_record = 262'144;
constexpr std::uint64_t microseconds = 1'000'000;

// A record: identifier and flags, always big-endian, then length, FD flags, two reserved bytes, data.
constexpr std::size_t data_offset = 8;
constexpr std::size_t length_at = 4;
constexpr std::size_t fd_flags_at = 5;
constexpr std::uint8_t fd_flag = 0x04;
constexpr std::uint32_t extended_flag = 0x8000'0000;
constexpr std::uint32_t remote_flag = 0x4000'0000;
constexpr std::uint32_t error_flag = 0x2000'0000;
constexpr std::uint32_t extended_mask = 0x1FFF'FFFF;
constexpr std::uint32_t standard_mask = 0x7FF;

constexpr std::uint32_t pcapng_magic = 0x0A0D'0D0A;  // the same in both byte orders

struct Kind {
    std::uint32_t magic;  // read as little-endian
    PcapKind kind;
};

constexpr std::array kinds = {
    Kind{0xA1B2'C3D4, {false, 1'000'000}},
    Kind{0xD4C3'B2A1, {true, 1'000'000}},
    Kind{0xA1B2'3C4D, {false, 1'000'000'000}},
    Kind{0x4D3C'B2A1, {true, 1'000'000'000}},
};

std::uint8_t byte(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint8_t>(bytes[at]);
}

std::uint32_t number(std::string_view bytes, std::size_t at, bool big_endian) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i) {
        value = value << 8 | byte(bytes, at + (big_endian ? i : sizeof value - 1 - i));
    }
    return value;
}

const PcapKind* find_kind(std::string_view content) {
    for (const Kind& kind : kinds) {
        if (content.size() >= sizeof kind.magic && number(content, 0, false) == kind.magic) {
            return &kind.kind;
        }
    }
    return nullptr;
}

bool is_pcapng(std::string_view content) {
    return content.size() >= sizeof pcapng_magic && number(content, 0, false) == pcapng_magic;
}

// What is wrong with the file's header; empty: nothing.
std::string header_fault(std::string_view content, const PcapKind* kind) {
    if (is_pcapng(content)) {
        return "this is a pcapng file; save it as pcap (editcap -F pcap)";
    }
    if (kind == nullptr) {
        return "this is no pcap file";
    }
    if (content.size() < pcap_header_size) {
        return "the file is cut off in its header";
    }
    const std::uint32_t link_type = number(content, pcap_header_size - 4, kind->big_endian) & link_type_mask;
    if (link_type != link_type_can) {
        return fmt::format("link type {} is not CAN; CAN is {}", link_type, link_type_can);
    }
    return {};
}

// Takes the record at the front of `content`. What is wrong with it; empty: nothing.
std::string_view take_record(std::string_view& content, const PcapKind& kind, Log& log) {
    if (content.size() < pcap_record_header_size) {
        return "the file is cut off";
    }
    const PcapRecordHeader header = read_pcap_record_header(content, kind);
    content.remove_prefix(pcap_record_header_size);
    if (!header.size_possible) {
        return "its length is not possible";
    }
    if (header.size > content.size()) {
        return "the file is cut off";
    }
    if (!header.time_possible) {
        return "its time is not possible";
    }
    LoggedFrame logged;
    const PcapRecord record = read_pcap_frame(content.substr(0, header.size), logged.frame);
    content.remove_prefix(header.size);
    if (record == PcapRecord::wrong) {
        return "it holds no CAN frame";
    }
    if (record == PcapRecord::passed_over) {
        ++log.passed_over;
        return {};
    }
    logged.time_us = header.time_us;
    logged.interface_name = pcap_interface;
    log.frames.push_back(std::move(logged));
    return {};
}

void put16(base::Bytes& bytes, std::uint16_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

void put32(base::Bytes& bytes, std::uint32_t value) {
    put16(bytes, static_cast<std::uint16_t>(value));
    put16(bytes, static_cast<std::uint16_t>(value >> 16));
}

void put32_big_endian(base::Bytes& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

void put_frame(base::Bytes& bytes, const frame::Frame& frame) {
    const std::size_t data = frame.remote ? 0 : frame.length;
    const auto size = static_cast<std::uint32_t>(data_offset + data);
    put32(bytes, size);  // stored, and on the bus
    put32(bytes, size);
    put32_big_endian(bytes,
                     frame.id | (frame.extended ? extended_flag : 0) | (frame.remote ? remote_flag : 0));
    bytes.push_back(frame.length);
    bytes.insert(bytes.end(), data_offset - length_at - 1, 0);
    bytes.insert(bytes.end(), frame.data.begin(), frame.data.begin() + static_cast<std::ptrdiff_t>(data));
}

}  // namespace

bool is_pcap(std::string_view content) {
    return find_kind(content) != nullptr || is_pcapng(content);
}

base::Result<PcapKind> read_pcap_header(std::string_view content) {
    const PcapKind* const kind = find_kind(content);
    if (std::string fault = header_fault(content, kind); !fault.empty()) {
        return base::failure(std::move(fault));
    }
    return *kind;
}

PcapRecordHeader read_pcap_record_header(std::string_view bytes, const PcapKind& kind) {
    const std::uint32_t seconds = number(bytes, 0, kind.big_endian);
    const std::uint32_t ticks = number(bytes, 4, kind.big_endian);
    const std::uint32_t size = number(bytes, 8, kind.big_endian);
    return {.time_us = seconds * microseconds + ticks / (kind.ticks / microseconds),
            .size = size,
            .size_possible = size <= longest_record,
            .time_possible = ticks < kind.ticks};
}

PcapRecord read_pcap_frame(std::string_view record, frame::Frame& frame) {
    if (record.size() < data_offset) {
        return PcapRecord::wrong;
    }
    const std::uint32_t id = number(record, 0, true);
    const std::size_t length = byte(record, length_at);
    if ((id & error_flag) != 0 || (byte(record, fd_flags_at) & fd_flag) != 0 || length > frame.data.size()) {
        return PcapRecord::passed_over;
    }
    frame.extended = (id & extended_flag) != 0;
    frame.remote = (id & remote_flag) != 0;
    frame.id = id & extended_mask;
    frame.length = static_cast<std::uint8_t>(length);
    if (!frame.extended && frame.id > standard_mask) {
        return PcapRecord::wrong;
    }
    if (frame.remote) {
        return PcapRecord::frame;
    }
    if (record.size() < data_offset + length) {
        return PcapRecord::wrong;
    }
    std::transform(record.begin() + data_offset,
                   record.begin() + static_cast<std::ptrdiff_t>(data_offset + length), frame.data.begin(),
                   [](char c) { return static_cast<std::uint8_t>(c); });
    return PcapRecord::frame;
}

base::Result<Log> read_pcap(std::string_view content, const std::string& name) {
    const base::Result<PcapKind> kind = read_pcap_header(content);
    if (!kind) {
        return base::failure(fmt::format("{}: {}", name, kind.error().message));
    }
    content.remove_prefix(pcap_header_size);
    Log log;
    for (std::size_t count = 1; !content.empty(); ++count) {
        if (const std::string_view fault = take_record(content, *kind, log); !fault.empty()) {
            return base::failure(fmt::format("{}: record {}: {}", name, count, fault));
        }
    }
    return log;
}

void append_pcap_header(base::Bytes& bytes) {
    put32(bytes, kinds.front().magic);
    put16(bytes, major_version);
    put16(bytes, minor_version);
    put32(bytes, 0);  // time zone and accuracy, which nobody fills
    put32(bytes, 0);
    put32(bytes, longest_record);
    put32(bytes, link_type_can);
}

void append_pcap_record(base::Bytes& bytes, const LoggedFrame& logged) {
    put32(bytes, static_cast<std::uint32_t>(logged.time_us / microseconds));
    put32(bytes, static_cast<std::uint32_t>(logged.time_us % microseconds));
    put_frame(bytes, logged.frame);
}

base::Result<base::Bytes> write_pcap(std::span<const LoggedFrame> frames) {
    base::Bytes bytes;
    append_pcap_header(bytes);
    for (const LoggedFrame& logged : frames) {
        if (logged.time_us / microseconds > std::numeric_limits<std::uint32_t>::max()) {
            return base::failure("a pcap file has no times after the year 2106");
        }
        append_pcap_record(bytes, logged);
    }
    return bytes;
}

}  // namespace cgw::media
