// Frames for people: a line each, in 80 columns.
#include <fmt/format.h>

#include <vector>

#include "base/canopen_text.hpp"
#include "base/text_cells.hpp"
#include "base/wrap.hpp"
#include "signals/codec.hpp"
#include "signals/layout.hpp"
#include "traffic/render_parts.hpp"

namespace cgw::traffic {
namespace {

constexpr std::size_t columns = 80;
constexpr std::uint64_t microseconds = 1'000'000;

std::string time_of(const Told& told) {
    if (!told.has_time) {
        return "-";
    }
    const std::uint64_t time = told.logged.time_us;
    const bool before = time < told.start_us;
    const std::uint64_t distance = before ? told.start_us - time : time - told.start_us;
    return fmt::format("{}{}.{:06}", before ? "-" : "", distance / microseconds, distance % microseconds);
}

std::string identifier_of(const frame::Frame& frame) {
    return frame.extended ? fmt::format("{:08X}h", frame.id) : base::identifier_text(frame.id);
}

std::string place_of(const signals::Signal& signal) {
    const unsigned byte = signal.first_bit / 8;
    return signal.is_bit() ? fmt::format("{}.{}", byte, signal.first_bit % 8)
                           : fmt::format("{}..{}", byte, byte + 1);
}

// What the raw number is, where that is something else.
std::string shown_text(const signals::Signal& signal, std::int32_t raw) {
    const bool same = signal.is_bit() && signal.values.empty();
    return same ? "" : " -> " + signals::value_text(signal, raw);
}

void add_wrapped(std::string& text, std::string head, const std::string& line) {
    for (const std::string& part : base::wrap(base::one_line(line), columns - head.size())) {
        text += head + part;
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
        head.assign(head.size(), ' ');
    }
}

void add_missing(std::string& text, const signals::Signal& signal, const std::string& what) {
    add_wrapped(text, fmt::format("{:<6} ", place_of(signal)),
                what + ": not in the frame, which is too short");
}

}  // namespace

std::string text_frame(const Told& told) {
    std::string text;
    add_wrapped(text,
                fmt::format("{:>12}  {:>4}  {:<6}  ", time_of(told), identifier_of(told.logged.frame),
                            told.meaning.name),
                told.meaning.text);
    return text;
}

std::string explain_frame(const frame::Frame& frame, const Meaning& meaning) {
    const std::span<const std::uint8_t> data(frame.data.data(), frame.remote ? 0U : frame.length);
    const signals::Frame* const pdo = meaning.owner.frame;
    std::string text;
    add_wrapped(text, fmt::format("{}  {}  ", identifier_of(frame), meaning.name), meaning.text);
    if (pdo == nullptr || frame.remote) {
        return text;
    }
    std::vector<const signals::Signal*> missing_flags;  // too many to be told one by one
    for (const signals::Signal& signal : pdo->signals) {
        if (!signals::reaches(signal, data)) {
            if (signal.is_error_flag()) {
                missing_flags.push_back(&signal);
            } else {
                add_missing(text, signal, signals::meaning_of(signal));
            }
            continue;
        }
        const std::int32_t raw = signals::raw_value(signal, data);
        if (signal.is_error_flag() && raw == 0) {
            continue;
        }
        add_wrapped(
            text, fmt::format("{:<6} ", place_of(signal)),
            fmt::format("{}: {}{}{}", signals::meaning_of(signal), raw, shown_text(signal, raw),
                        signals::in_range(signal, raw) ? "" : ", beyond " + signals::range_text(signal)));
    }
    if (!missing_flags.empty()) {
        const signals::Signal& first = *missing_flags.front();
        const std::size_t more = missing_flags.size() - 1;
        add_missing(
            text, first,
            signals::meaning_of(first) + (more == 0 ? "" : fmt::format(" and {} flags after it", more)));
    }
    return text;
}

}  // namespace cgw::traffic
