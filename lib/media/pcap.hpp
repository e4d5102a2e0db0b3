// Frames as a pcap file of link type 227 (LINKTYPE_CAN_SOCKETCAN), which Wireshark and tcpdump read and
// write. Times are microseconds since 1970, or since the start of a simulation. The format has no names of
// interfaces.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "media/logged_frame.hpp"

namespace cgw::media {

// The interface of every frame that is read.
inline constexpr std::string_view pcap_interface = "can0";

// `content` begins as a pcap file does, in either byte order, with times in microseconds or nanoseconds; also
// when it is a pcapng file, which read_pcap() refuses with advice.
bool is_pcap(std::string_view content);

// Nanoseconds are cut to microseconds. Error frames and CAN FD frames are passed over. Another link type, a
// file that is cut off and one that contradicts itself are failures that begin with `name`.
base::Result<Log> read_pcap(std::string_view content, const std::string& name);

// The parts of a file that read_pcap() reads, for one that is read piece by piece.
struct PcapKind {
    bool big_endian = false;
    std::uint32_t ticks = 1'000'000;  // of a second
};
inline constexpr std::size_t pcap_header_size = 24;
inline constexpr std::size_t pcap_record_header_size = 16;

// `content` begins with the file's header. The failure says what is wrong, without a name.
base::Result<PcapKind> read_pcap_header(std::string_view content);

struct PcapRecordHeader {
    std::uint64_t time_us = 0;
    std::uint32_t size = 0;     // bytes that follow the header
    bool size_possible = true;  // false: there is no telling where the next record begins
    bool time_possible = true;
};
// `bytes` holds pcap_record_header_size of them.
PcapRecordHeader read_pcap_record_header(std::string_view bytes, const PcapKind& kind);

enum class PcapRecord : std::uint8_t {
    frame,
    passed_over,  // an error frame or a CAN FD frame
    wrong,        // no CAN frame
};
// `record` is what follows a record's header.
PcapRecord read_pcap_frame(std::string_view record, frame::Frame& frame);

// The parts of a file that write_pcap() makes, for one that grows: first the header, then records. Seconds
// beyond the format's 32 bits begin again.
void append_pcap_header(base::Bytes& bytes);
void append_pcap_record(base::Bytes& bytes, const LoggedFrame& logged);

// Little-endian, microseconds. Fails on a time after the year 2106, for which the format has no room.
base::Result<base::Bytes> write_pcap(std::span<const LoggedFrame> frames);

}  // namespace cgw::media
