#include "media/candump.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/ascii.hpp"

namespace cgw::media {
namespace {

constexpr std::uint64_t microseconds = 1'000'000;
constexpr std::size_t standard_digits = 3;
constexpr std::size_t extended_digits = 8;
constexpr std::uint32_t maximum_standard_id = 0x7FF;
constexpr std::uint32_t maximum_extended_id = 0x1FFF'FFFF;
constexpr std::uint32_t error_frame = 0x2000'0000;

// The whole of `text` as an unsigned number.
template <typename Number>
bool parse(std::string_view text, int base, Number& number) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number, base);
    return error == std::errc{} && stop == end && !text.empty();
}

// Cuts `text` at the first `separator`; what follows it stays in `text`.
std::optional<std::string_view> cut(std::string_view& text, char separator) {
    const std::size_t at = text.find(separator);
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view head = text.substr(0, at);
    text.remove_prefix(at + 1);
    return head;
}

bool parse_time(std::string_view text, std::uint64_t& time_us) {
    const std::optional<std::string_view> seconds_text = cut(text, '.');
    std::uint64_t seconds = 0;
    const std::optional<std::uint64_t> fraction_us = candump_fraction_us(text);
    if (!seconds_text || !parse(*seconds_text, 10, seconds) || !fraction_us ||
        seconds > ~std::uint64_t{0} / microseconds - 1) {
        return false;
    }
    time_us = seconds * microseconds + *fraction_us;
    return true;
}

bool parse_id(std::string_view text, frame::Frame& frame) {
    frame.extended = text.size() == extended_digits;
    const std::uint32_t maximum = frame.extended ? maximum_extended_id : maximum_standard_id;
    return (frame.extended || text.size() == standard_digits) && parse(text, 16, frame.id) &&
           frame.id <= maximum;
}

bool parse_data(std::string_view text, frame::Frame& frame) {
    if (!text.empty() && text.front() == 'R') {
        frame.remote = true;
        text.remove_prefix(1);
        return text.empty() || (text.size() == 1 && parse(text, 10, frame.length) && frame.length <= 8);
    }
    if (text.size() % 2 != 0 || text.size() > 2 * frame.data.size()) {
        return false;
    }
    frame.length = static_cast<std::uint8_t>(text.size() / 2);
    for (std::size_t i = 0; i < frame.length; ++i) {
        if (!parse(text.substr(2 * i, 2), 16, frame.data[i])) {
            return false;
        }
    }
    return true;
}

// What stands before the identifier; the identifier and what follows it stay in `line`.
bool parse_front(std::string_view& line, LoggedFrame& logged) {
    if (line.empty() || line.front() != '(') {
        return false;
    }
    line.remove_prefix(1);
    const std::optional<std::string_view> time = cut(line, ')');
    if (!time || !parse_time(*time, logged.time_us) || line.empty() || line.front() != ' ') {
        return false;
    }
    line.remove_prefix(1);
    const std::optional<std::string_view> interface_name = cut(line, ' ');
    if (!interface_name || interface_name->empty()) {
        return false;
    }
    logged.interface_name = *interface_name;
    return true;
}

bool is_error_frame(std::string_view id, std::string_view data) {
    std::uint32_t number = 0;
    frame::Frame ignored;
    return id.size() == extended_digits && parse(id, 16, number) &&
           (number & ~maximum_extended_id) == error_frame && parse_data(data, ignored);
}

// 123##1AABB: a digit of flags, then up to 64 data bytes.
bool is_fd_frame(std::string_view id, std::string_view data) {
    constexpr std::size_t longest = 2 + 2 * 64;
    frame::Frame ignored;
    return parse_id(id, ignored) && data.size() >= 2 && data.size() <= longest && data.size() % 2 == 0 &&
           data.front() == '#' && base::consists_of(data.substr(1), base::hexadecimal_digits);
}

bool is_to_pass_over(std::string_view line) {
    LoggedFrame ignored;
    if (!parse_front(line, ignored)) {
        return false;
    }
    const std::optional<std::string_view> id = cut(line, '#');
    return id && (is_error_frame(*id, line) || is_fd_frame(*id, line));
}

std::string_view without_direction(std::string_view line) {
    return line.ends_with(" R") || line.ends_with(" T") ? line.substr(0, line.size() - 2) : line;
}

}  // namespace

std::string candump_line(const LoggedFrame& logged) {
    const frame::Frame& frame = logged.frame;
    std::string line = fmt::format("({:010}.{:06}) {} {:0{}X}#", logged.time_us / microseconds,
                                   logged.time_us % microseconds, logged.interface_name, frame.id,
                                   frame.extended ? extended_digits : standard_digits);
    if (frame.remote) {
        line += frame.length == 0 ? "R" : fmt::format("R{}", frame.length);
        return line;
    }
    for (std::size_t i = 0; i < frame.length; ++i) {
        line += fmt::format("{:02X}", frame.data[i]);
    }
    return line;
}

std::optional<std::uint64_t> candump_fraction_us(std::string_view digits) {
    constexpr std::size_t of_microseconds = 6;
    constexpr std::size_t of_nanoseconds = 9;
    std::uint64_t fraction = 0;
    if ((digits.size() != of_microseconds && digits.size() != of_nanoseconds) ||
        !parse(digits, 10, fraction)) {
        return std::nullopt;
    }
    return digits.size() == of_nanoseconds ? fraction / 1000 : fraction;
}

std::optional<LoggedFrame> parse_candump_line(std::string_view line) {
    LoggedFrame logged;
    if (!parse_front(line, logged)) {
        return std::nullopt;
    }
    const std::optional<std::string_view> id = cut(line, '#');
    if (!id || !parse_id(*id, logged.frame) || !parse_data(line, logged.frame)) {
        return std::nullopt;
    }
    return logged;
}

ReadLine read_candump_line(std::string_view line) {
    line = without_direction(base::trimmed(line, "\r \t"));
    if (line.empty()) {
        return {LineKind::blank};
    }
    if (std::optional<LoggedFrame> logged = parse_candump_line(line); logged) {
        return {LineKind::frame, std::move(*logged)};
    }
    return {is_to_pass_over(line) ? LineKind::passed_over : LineKind::wrong};
}

base::Result<Log> read_candump(std::string_view text, const std::string& name) {
    Log log;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        ReadLine line = read_candump_line(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.kind == LineKind::wrong) {
            return base::failure(
                fmt::format("{}:{}: this is no frame as candump -L writes it", name, number));
        }
        if (line.kind == LineKind::frame) {
            log.frames.push_back(std::move(line.logged));
        }
        log.passed_over += line.kind == LineKind::passed_over ? 1 : 0;
    }
    return log;
}

void CandumpLog::record(const frame::Frame& frame, std::uint64_t time_us) {
    const std::string line = candump_line({time_us, interface_name_, frame});
    content_.insert(content_.end(), line.begin(), line.end());
    content_.push_back('\n');
    ++frames_;
}

}  // namespace cgw::media
