#include "media/candump_screen.hpp"

#include <charconv>
#include <chrono>

#include "base/ascii.hpp"

namespace cgw::media {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::uint64_t microseconds = 1'000'000;
constexpr std::size_t standard_digits = 3;
constexpr std::size_t extended_digits = 8;
constexpr std::uint32_t error_flag = 0x2000'0000;
constexpr std::uint32_t highest_standard = 0x7FF;
constexpr std::uint32_t highest_extended = 0x1FFF'FFFF;

// The word at the front of `text`, which loses it and the blanks behind it; "" at the end.
std::string_view take_word(std::string_view& text) {
    const std::size_t length = std::min(text.find_first_of(blanks), text.size());
    const std::string_view word = text.substr(0, length);
    text = base::trimmed(text.substr(length), blanks);
    return word;
}

template <typename Number>
bool parse(std::string_view text, int base, Number& number) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number, base);
    return error == std::errc{} && stop == end && !text.empty();
}

// "08:17:32"
bool parse_clock(std::string_view text, std::uint64_t& seconds) {
    unsigned hours = 0;
    unsigned minutes = 0;
    unsigned rest = 0;
    if (text.size() != 8 || text[2] != ':' || text[5] != ':' || !parse(text.substr(0, 2), 10, hours) ||
        !parse(text.substr(3, 2), 10, minutes) || !parse(text.substr(6, 2), 10, rest) || hours > 23 ||
        minutes > 59 || rest > 60) {
        return false;
    }
    seconds = hours * 3600 + minutes * 60 + rest;
    return true;
}

// "2015-07-10"; years before 1970 are none of a bus.
bool parse_date(std::string_view text, std::uint64_t& seconds) {
    int year = 0;
    unsigned month = 0;
    unsigned day = 0;
    if (text.size() != 10 || text[4] != '-' || text[7] != '-' || !parse(text.substr(0, 4), 10, year) ||
        !parse(text.substr(5, 2), 10, month) || !parse(text.substr(8, 2), 10, day)) {
        return false;
    }
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                           std::chrono::day(day)};
    if (!date.ok() || year < 1970) {
        return false;
    }
    constexpr std::uint64_t day_seconds = 86'400;
    seconds =
        static_cast<std::uint64_t>(std::chrono::sys_days(date).time_since_epoch().count()) * day_seconds;
    return true;
}

// What stands in the brackets: seconds or a date with a clock, and a fraction.
bool parse_time(std::string_view text, std::uint64_t& time_us) {
    const std::size_t point = text.rfind('.');
    if (point == std::string_view::npos) {
        return false;
    }
    const std::optional<std::uint64_t> fraction_us = candump_fraction_us(text.substr(point + 1));
    if (!fraction_us) {
        return false;
    }
    text = text.substr(0, point);
    std::uint64_t seconds = 0;
    if (const std::size_t blank = text.find(' '); blank != std::string_view::npos) {
        std::uint64_t days = 0;
        if (!parse_date(text.substr(0, blank), days) || !parse_clock(text.substr(blank + 1), seconds)) {
            return false;
        }
        seconds += days;
    } else if (!parse(text, 10, seconds) || seconds > ~std::uint64_t{0} / microseconds - 1) {
        return false;
    }
    time_us = seconds * microseconds + *fraction_us;
    return true;
}

// "RX - -" or "TX B E" in front of the identifier.
void skip_direction(std::string_view& text) {
    std::string_view rest = text;
    const std::string_view direction = take_word(rest);
    if (direction != "RX" && direction != "TX") {
        return;
    }
    if (take_word(rest).size() == 1 && take_word(rest).size() == 1) {
        text = rest;
    }
}

bool parse_identifier(std::string_view word, frame::Frame& frame, bool& error) {
    frame.extended = word.size() == extended_digits;
    if ((!frame.extended && word.size() != standard_digits) || !parse(word, 16, frame.id)) {
        return false;
    }
    error = frame.extended && (frame.id & ~highest_extended) == error_flag;
    return error || frame.id <= (frame.extended ? highest_extended : highest_standard);
}

// The bytes behind the length, or that it is a remote frame. Whatever ASCII column follows is left alone.
bool parse_contents(std::string_view text, frame::Frame& frame) {
    if (text.starts_with("remote request")) {
        frame.remote = true;
        return true;
    }
    for (std::size_t i = 0; i < frame.length; ++i) {
        const std::string_view word = take_word(text);
        if (word.size() != 2 || !parse(word, 16, frame.data[i])) {
            return false;
        }
    }
    return text.empty() || text.front() == '\'' || text == "ERRORFRAME" || text.starts_with("ERRORFRAME ");
}

bool is_fd_length(std::string_view word) {
    unsigned length = 0;
    return word.size() == 4 && word.front() == '[' && word.back() == ']' &&
           parse(word.substr(1, 2), 10, length) && length <= 64;
}

}  // namespace

ScreenLine read_screen_line(std::string_view text) {
    ScreenLine result;
    text = base::trimmed(text, "\r \t");
    if (text.starts_with('(')) {
        const std::size_t end = text.find(')');
        if (end == std::string_view::npos ||
            !parse_time(text.substr(1, end - 1), result.line.logged.time_us)) {
            return result;
        }
        result.has_time = true;
        text = base::trimmed(text.substr(end + 1), blanks);
    }
    result.line.logged.interface_name = take_word(text);
    skip_direction(text);
    bool error = false;
    frame::Frame& frame = result.line.logged.frame;
    if (!parse_identifier(take_word(text), frame, error)) {
        return result;
    }
    const std::string_view length = take_word(text);
    if (is_fd_length(length)) {
        result.line.kind = LineKind::passed_over;
        return result;
    }
    if (length.size() != 3 || length.front() != '[' || length.back() != ']' ||
        !parse(length.substr(1, 1), 10, frame.length) || frame.length > frame.data.size() ||
        !parse_contents(text, frame)) {
        return result;
    }
    result.line.kind = error ? LineKind::passed_over : LineKind::frame;
    return result;
}

}  // namespace cgw::media
