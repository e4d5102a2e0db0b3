#include "media/slcan_line.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/ascii.hpp"

namespace cgw::media {
namespace {

constexpr char line_end = '\r';
constexpr char line_feed = '\n';
constexpr char bell = '\a';

// More than the 30 of T, 8 digits, length, 16 digits, 4 of time: a line that is cut there is no frame.
constexpr std::size_t longest_line = 32;
constexpr std::size_t time_digits = 4;
constexpr std::uint32_t maximum_standard_id = 0x7FF;
constexpr std::uint32_t maximum_extended_id = 0x1FFF'FFFF;

struct Kind {
    char letter;
    bool extended;
    bool remote;
    std::size_t id_digits;
    std::uint32_t maximum_id;
};

constexpr std::array kinds = {
    Kind{'t', false, false, 3, maximum_standard_id},
    Kind{'T', true, false, 8, maximum_extended_id},
    Kind{'r', false, true, 3, maximum_standard_id},
    Kind{'R', true, true, 8, maximum_extended_id},
};

struct BitRate {
    unsigned kbit;
    std::string_view command;
};

constexpr std::array bit_rates = {
    BitRate{10, "S0"},  BitRate{20, "S1"},  BitRate{50, "S2"},  BitRate{100, "S3"},  BitRate{125, "S4"},
    BitRate{250, "S5"}, BitRate{500, "S6"}, BitRate{800, "S7"}, BitRate{1000, "S8"},
};

const Kind* find_kind(std::string_view line) {
    for (const Kind& kind : kinds) {
        if (!line.empty() && line.front() == kind.letter) {
            return &kind;
        }
    }
    return nullptr;
}

const Kind& kind_of(const frame::Frame& frame) {
    return kinds[(frame.extended ? 1U : 0U) + (frame.remote ? 2U : 0U)];
}

// Takes `digits` hexadecimal digits from the front of `text`.
template <typename Number>
bool take_number(std::string_view& text, std::size_t digits, Number& number) {
    if (text.size() < digits) {
        return false;
    }
    const char* const end = text.data() + digits;
    const auto [stop, error] = std::from_chars(text.data(), end, number, 16);
    text.remove_prefix(digits);
    return error == std::errc{} && stop == end;
}

bool is_time(std::string_view text) {
    return text.size() == time_digits && base::consists_of(text, base::hexadecimal_digits);
}

}  // namespace

std::string slcan_line(const frame::Frame& frame) {
    const Kind& kind = kind_of(frame);
    std::string line = fmt::format("{}{:0{}X}{}", kind.letter, frame.id, kind.id_digits, frame.length);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        line += fmt::format("{:02X}", frame.data[i]);
    }
    return line + line_end;
}

std::optional<frame::Frame> parse_slcan_line(std::string_view line) {
    const Kind* const kind = find_kind(line);
    if (kind == nullptr) {
        return std::nullopt;
    }
    line.remove_prefix(1);
    frame::Frame frame;
    frame.extended = kind->extended;
    frame.remote = kind->remote;
    if (!take_number(line, kind->id_digits, frame.id) || frame.id > kind->maximum_id ||
        !take_number(line, 1, frame.length) || frame.length > frame.data.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        if (!take_number(line, 2, frame.data[i])) {
            return std::nullopt;
        }
    }
    return line.empty() || is_time(line) ? std::optional(frame) : std::nullopt;
}

std::optional<std::string_view> slcan_bit_rate_command(unsigned kbit) {
    for (const BitRate& rate : bit_rates) {
        if (rate.kbit == kbit) {
            return rate.command;
        }
    }
    return std::nullopt;
}

std::optional<SlcanEvent> SlcanReader::take(char character) {
    if (character == bell) {
        clear();
        return SlcanEvent{SlcanAnswer::refused, {}};
    }
    if (character == line_end) {
        const std::optional<SlcanEvent> event = read_line();
        clear();
        return event;
    }
    if (character == line_feed) {
        return std::nullopt;  // some adapters end their lines with both
    }
    if (line_.size() < longest_line) {
        line_ += character;
    }
    return std::nullopt;
}

std::optional<SlcanEvent> SlcanReader::read_line() const {
    if (line_.empty() || line_ == "z" || line_ == "Z") {
        return SlcanEvent{SlcanAnswer::accepted, {}};
    }
    if (find_kind(line_) == nullptr) {
        return std::nullopt;
    }
    const std::optional<frame::Frame> frame = parse_slcan_line(line_);
    return frame ? SlcanEvent{SlcanAnswer::frame, *frame} : SlcanEvent{SlcanAnswer::damaged, {}};
}

}  // namespace cgw::media
