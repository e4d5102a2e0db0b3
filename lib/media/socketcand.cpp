#include "media/socketcand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/ascii.hpp"

namespace cgw::media {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::uint64_t microseconds = 1'000'000;
constexpr std::size_t extended_digits = 8;
constexpr std::uint32_t maximum_standard_id = 0x7FF;
constexpr std::uint32_t maximum_extended_id = 0x1FFF'FFFF;
constexpr std::size_t longest_text = 160;  // of a message; leaves room within MessageStream::longest
constexpr std::size_t longest_bus_name = 16;
constexpr std::string_view lost_text = " frames lost, this client is too slow";

// The whole of `text` as a number of at most `digits` digits.
template <typename Number>
bool parse_number(std::string_view text, int base, std::size_t digits, Number& number) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number, base);
    return !text.empty() && text.size() <= digits && error == std::errc{} && stop == end;
}

// socketcand tells 29-bit identifiers by their eight digits. python-can writes no leading zeros: what cannot
// be an 11-bit identifier is taken as a 29-bit one, too.
bool parse_id(std::string_view word, frame::Frame& frame) {
    if (!parse_number(word, 16, extended_digits, frame.id) || frame.id > maximum_extended_id) {
        return false;
    }
    frame.extended = word.size() == extended_digits || frame.id > maximum_standard_id;
    return true;
}

bool parse_length(std::string_view word, frame::Frame& frame) {
    return parse_number(word, 10, 1, frame.length) && frame.length <= frame.data.size();
}

base::Result<frame::Frame> parse_head(std::string_view& words) {
    frame::Frame frame;
    const std::string_view id = next_word(words);
    if (!parse_id(id, frame)) {
        return base::failure(fmt::format("no identifier of a frame: '{}'", id));
    }
    const std::string_view length = next_word(words);
    if (!parse_length(length, frame)) {
        return base::failure(fmt::format("no length 0..8: '{}'", length));
    }
    return frame;
}

// Adds the bytes of one word, "1A22" or "A"; false when it has none or they are too many.
bool add_bytes(std::string_view word, frame::Frame& frame) {
    const std::size_t step = word.size() == 1 ? 1 : 2;
    if (word.size() % step != 0) {
        return false;
    }
    for (; !word.empty(); word.remove_prefix(step)) {
        if (frame.length >= frame.data.size() ||
            !parse_number(word.substr(0, step), 16, step, frame.data[frame.length])) {
            return false;
        }
        ++frame.length;
    }
    return true;
}

std::string id_text(const frame::Frame& frame) {
    return frame.extended ? fmt::format("{:08X}", frame.id) : fmt::format("{:03X}", frame.id);
}

bool parse_id_and_time(std::string_view& words, frame::Frame& frame) {
    const std::string_view id = next_word(words);
    const std::string_view time = next_word(words);
    return parse_id(id, frame) && base::consists_of(time, "0123456789.");
}

}  // namespace

void MessageStream::append(std::string_view bytes) {
    buffer_.erase(0, at_);
    at_ = 0;
    buffer_ += bytes;
}

MessageStream::Item MessageStream::next(std::string_view& text) {
    for (; at_ < buffer_.size(); ++at_) {
        const char character = buffer_[at_];
        if (character == '<') {
            return message(text);
        }
        if (blanks.find(character) == std::string_view::npos && !in_junk_) {
            in_junk_ = true;
            return Item::junk;
        }
    }
    return Item::none;
}

MessageStream::Item MessageStream::message(std::string_view& text) {
    in_junk_ = false;
    const std::string_view rest = std::string_view(buffer_).substr(at_);
    const std::size_t end = rest.find('>');
    if (std::min(end, rest.size()) >= longest) {
        return Item::too_long;
    }
    if (end == std::string_view::npos) {
        return Item::none;
    }
    text = base::trimmed(rest.substr(1, end - 1), blanks);
    at_ += end + 1;
    return Item::message;
}

void MessageStream::clear() {
    buffer_.clear();
    at_ = 0;
    in_junk_ = false;
}

std::string_view next_word(std::string_view& text) {
    text = base::trimmed(text, blanks);
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text = base::trimmed(text.substr(word.size()), blanks);
    return word;
}

std::string message_of(std::string_view words) {
    std::string text(words.substr(0, longest_text));
    for (char& character : text) {
        if (character < ' ' || character > '~' || character == '<' || character == '>') {
            character = '?';
        }
    }
    return "< " + text + " >";
}

std::string error_message(std::string_view text) {
    return message_of(fmt::format("error {}", text));
}

std::string send_message(const frame::Frame& frame) {
    std::string text =
        fmt::format("< {} {} {} ", frame.remote ? "sendrtr" : "send", id_text(frame), frame.length);
    if (!frame.remote) {
        for (std::size_t i = 0; i < frame.length; ++i) {
            fmt::format_to(std::back_inserter(text), "{:02X} ", frame.data[i]);
        }
    }
    return text + '>';
}

base::Result<frame::Frame> parse_send(std::string_view words) {
    base::Result<frame::Frame> frame = parse_head(words);
    if (!frame) {
        return frame;
    }
    for (std::size_t i = 0; i < frame->length; ++i) {
        const std::string_view word = next_word(words);
        if (!parse_number(word, 16, 2, frame->data[i])) {
            return base::failure(
                fmt::format("byte {} of {} is missing or wrong: '{}'", i + 1, frame->length, word));
        }
    }
    if (!next_word(words).empty()) {
        return base::failure(fmt::format("more follows than {} bytes of data", frame->length));
    }
    return frame;
}

base::Result<frame::Frame> parse_sendrtr(std::string_view words) {
    base::Result<frame::Frame> frame = parse_head(words);
    if (frame && !next_word(words).empty()) {
        return base::failure("a remote frame has no data");
    }
    if (frame) {
        frame->remote = true;
    }
    return frame;
}

std::string frame_message(const frame::Frame& frame, std::uint64_t time_us) {
    std::string text = fmt::format("\n< {} {} {}.{:06} ", frame.remote ? "rtr" : "frame", id_text(frame),
                                   time_us / microseconds, time_us % microseconds);
    if (frame.remote) {
        fmt::format_to(std::back_inserter(text), "{}", frame.length);
    } else {
        for (std::size_t i = 0; i < frame.length; ++i) {
            fmt::format_to(std::back_inserter(text), "{:02X}", frame.data[i]);
        }
    }
    return text + " >";
}

std::optional<frame::Frame> parse_frame(std::string_view words) {
    frame::Frame frame;
    if (!parse_id_and_time(words, frame)) {
        return std::nullopt;
    }
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
        if (!add_bytes(word, frame)) {
            return std::nullopt;
        }
    }
    return frame;
}

std::optional<frame::Frame> parse_rtr(std::string_view words) {
    frame::Frame frame;
    frame.remote = true;
    if (!parse_id_and_time(words, frame) || !parse_length(next_word(words), frame) ||
        !next_word(words).empty()) {
        return std::nullopt;
    }
    return frame;
}

std::string lost_message(std::uint64_t frames) {
    return "\n" + error_message(fmt::format("{}{}", frames, lost_text));
}

std::optional<std::uint64_t> parse_lost(std::string_view words) {
    std::uint64_t frames = 0;
    if (!words.ends_with(lost_text)) {
        return std::nullopt;
    }
    words.remove_suffix(lost_text.size());
    return parse_number(words, 10, 20, frames) ? std::optional(frames) : std::nullopt;
}

bool is_bus_name(std::string_view name) {
    return !name.empty() && name.size() <= longest_bus_name &&
           std::all_of(name.begin(), name.end(), [](char c) {
               return base::is_letter_or_digit(c) || c == '.' || c == '_' || c == '-';
           });
}

}  // namespace cgw::media
