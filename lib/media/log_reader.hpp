// A log of any size, read piece by piece in constant memory: candump -L, what candump shows on a screen,
// pcap. What is no frame is told and read over; nothing ends the reading but the end, and a pcap file that
// does not say where its next record begins.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "media/logged_frame.hpp"
#include "media/pcap.hpp"

namespace cgw::media {

class LogReader {
  public:
    static constexpr std::size_t longest_line = 4096;  // bytes

    enum class Kind : std::uint8_t {
        frame,
        passed_over,  // an error frame or a CAN FD frame
        blank,        // a line without anything
        fault,        // no frame: `fault` says why
        hungry,       // feed() more, or finish()
        end,
    };

    struct Item {
        Kind kind = Kind::hungry;
        std::uint64_t number = 0;  // line, or record of a pcap file; from 1; 0: the file as a whole
        LoggedFrame logged{};      // of a frame
        bool has_time = true;      // false: time_us is 0
        std::string fault{};       // a clause for people
    };

    // Bytes of the file, as many as one likes.
    void feed(std::string_view bytes);
    // There are no more.
    void finish() { finished_ = true; }

    // What comes next. Kind and format of the file are found from its first bytes.
    const Item& next();

    // Numbers are lines; false: records of a pcap file. Known from the first item on.
    bool has_lines() const { return format_ != Format::pcap; }

  private:
    enum class Format : std::uint8_t { unknown, text, pcap };

    std::string_view rest() const { return std::string_view(buffer_).substr(at_); }
    void find_format();
    void next_line();
    void read_line(std::string_view line);
    void next_record();
    void set_fault(std::string text);
    void give_up(std::string text);

    std::string buffer_;
    std::size_t at_ = 0;
    bool finished_ = false;
    bool given_up_ = false;
    Format format_ = Format::unknown;
    PcapKind kind_{};
    std::uint64_t number_ = 0;
    bool in_long_line_ = false;
    Item item_;
};

}  // namespace cgw::media
