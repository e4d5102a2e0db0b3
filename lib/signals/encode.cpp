#include "signals/encode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tl/expected.hpp>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/frames.hpp"
#include "dictionary/ascii.hpp"
#include "signals/find.hpp"
#include "signals/layout.hpp"

namespace cgw::signals {
namespace {

namespace rules = diagnostic::rules;

constexpr std::string_view raw_word = "raw";

// What is wrong with one assignment, so far as to make a finding of it.
struct Fault {
    const diagnostic::Rule* rule = nullptr;
    std::string message{};
    std::string help{};
};

using Read = tl::expected<std::int32_t, Fault>;

tl::unexpected<Fault> fault(const diagnostic::Rule& rule, std::string message, std::string help = {}) {
    return tl::unexpected<Fault>(Fault{&rule, std::move(message), std::move(help)});
}

bool is_hexadecimal(std::string_view text) {
    return text.starts_with("0x") || text.starts_with("0X");
}

std::optional<std::int64_t> whole_number(std::string_view text) {
    return is_hexadecimal(text) ? base::parse_integer(text.substr(2), 16) : base::parse_integer(text);
}

// Length of the decimal number at the front of `text`; an exponent only where digits follow.
std::size_t number_length(std::string_view text) {
    std::size_t length = text.find_first_not_of("+-0123456789.");
    length = std::min(length, text.size());
    if (length < text.size() && base::lower(text[length]) == 'e') {
        const std::size_t digits = text.find_first_not_of("+-", length + 1);
        if (digits != std::string_view::npos && digits <= length + 2 && base::is_digit(text[digits])) {
            length = std::min(text.find_first_not_of(base::digits, digits), text.size());
        }
    }
    return length;
}

bool is_unit(const Signal& signal, std::string_view unit) {
    const std::string wanted = base::lowered(unit);
    return wanted == base::lowered(signal.unit) || wanted == base::lowered(dictionary::to_ascii(signal.unit));
}

std::string way_to_write(const Signal& signal) {
    if (signal.is_bit()) {
        return signal.values.empty() ? "write 0 or 1" : "write on or off";
    }
    return signal.scaled ? fmt::format("write a number of {}, or a raw one as 0x1F40 raw",
                                       signal.unit.empty() ? "its scale" : signal.unit)
                         : "write a whole number as 8000 or 0x1F40";
}

Read read_raw(const Signal& signal, std::string_view text) {
    const std::optional<std::int64_t> number = whole_number(text);
    if (!number) {
        return fault(rules::signal_value, fmt::format("`{}` is no whole number", text), way_to_write(signal));
    }
    if (!can_carry(signal, *number)) {
        return fault(rules::signal_range,
                     fmt::format("{} cannot be {}: it has {} bit{}{}", meaning_of(signal), text, signal.width,
                                 signal.is_bit() ? "" : "s", signal.is_signed ? " with a sign" : ""));
    }
    return static_cast<std::int32_t>(*number);
}

Read read_physical(const Signal& signal, std::string_view text) {
    const std::size_t length = number_length(text);
    const std::string_view unit = base::trimmed(text.substr(length));
    const std::optional<double> number = base::parse_real(text.substr(0, length));
    if (!number) {
        return fault(rules::signal_value, fmt::format("`{}` is no value of {}", text, meaning_of(signal)),
                     way_to_write(signal));
    }
    if (!unit.empty() && !is_unit(signal, unit)) {
        return fault(rules::signal_value,
                     signal.unit.empty()
                         ? fmt::format("{} has no unit, but `{}` has", meaning_of(signal), text)
                         : fmt::format("{} is in {}, not in `{}`", meaning_of(signal), signal.unit, unit),
                     way_to_write(signal));
    }
    const std::optional<std::int32_t> raw = raw_of(signal, *number);
    if (!raw) {
        return fault(rules::signal_range, fmt::format("{} cannot be {}: its range is {}", meaning_of(signal),
                                                      text, range_text(signal)));
    }
    return *raw;
}

Read read_value(const Signal& signal, std::string_view text) {
    if (text.size() > raw_word.size() &&
        base::equal_ignoring_case(text.substr(text.size() - raw_word.size()), raw_word)) {
        return read_raw(signal, base::trimmed(text.substr(0, text.size() - raw_word.size())));
    }
    for (const NamedValue& value : signal.values) {
        if (base::equal_ignoring_case(value.text, text)) {
            return value.raw;
        }
    }
    if (!signal.scaled && whole_number(text)) {
        return read_raw(signal, text);
    }
    if (is_hexadecimal(text)) {
        return fault(rules::signal_value,
                     fmt::format("`{}` may be a raw number or one of {}", text,
                                 signal.unit.empty() ? "the signal's scale" : signal.unit),
                     fmt::format("write {} raw, or a decimal number", text));
    }
    if (signal.is_bit() || !signal.scaled) {
        return fault(rules::signal_value, fmt::format("`{}` is no value of {}", text, meaning_of(signal)),
                     way_to_write(signal));
    }
    return read_physical(signal, text);
}

Fault unknown_signal(const Frame& frame, std::string_view name, bool ambiguous) {
    if (ambiguous) {
        return {&rules::signal_unknown, fmt::format("{} has several signals called `{}`", frame.name, name),
                "use the names that cgw pdo shows"};
    }
    const std::string nearest = nearest_signal(frame, name);
    return {&rules::signal_unknown, fmt::format("{} has no signal `{}`", frame.name, name),
            nearest.empty() ? "cgw pdo shows what it has" : fmt::format("did you mean {}?", nearest)};
}

tl::expected<Given, Fault> read_assignment(const Frame& frame, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        return fault(rules::signal_value, "this is no NAME=VALUE", "write a value as Setp1Ext=50%");
    }
    const std::string_view name = base::trimmed(assignment.substr(0, equals));
    const std::string_view value = base::trimmed(assignment.substr(equals + 1));
    const FoundSignal found = find_signal(frame, name);
    if (found.signal == nullptr) {
        return tl::unexpected<Fault>(unknown_signal(frame, name, found.ambiguous));
    }
    const Read raw = read_value(*found.signal, value);
    if (!raw) {
        return tl::unexpected<Fault>(raw.error());
    }
    return Given{found.signal, std::string(value), *raw};
}

}  // namespace

const Frame* demand_frame(const std::vector<Frame>& frames, std::string_view name,
                          diagnostic::Findings& findings) {
    const Frame* const frame = find_frame(frames, name);
    if (frame == nullptr) {
        std::vector<std::string_view> names;
        names.reserve(frames.size());
        for (const Frame& active : frames) {
            names.push_back(active.name);
        }
        findings.report(
            {&rules::frame_unknown,
             "the plant has no active PDO of this name or identifier",
             {std::string(name), {}},
             {},
             names.empty() ? "none is active" : fmt::format("active are {}", fmt::join(names, ", "))});
    }
    return frame;
}

Encoded encode(const Frame& frame, std::span<const std::string> assignments, diagnostic::Findings& findings) {
    Encoded encoded{.frame = &frame, .data = rest_data(frame)};
    for (const std::string& assignment : assignments) {
        tl::expected<Given, Fault> given = read_assignment(frame, assignment);
        if (given && std::any_of(encoded.given.begin(), encoded.given.end(),
                                 [&](const Given& other) { return other.signal == given->signal; })) {
            given =
                fault(rules::signal_twice, fmt::format("{} has a value already", meaning_of(*given->signal)));
        }
        if (!given) {
            findings.report({given.error().rule,
                             std::move(given.error().message),
                             {assignment, {}},
                             {},
                             std::move(given.error().help)});
            continue;
        }
        put_raw(*given->signal, encoded.data, given->raw);
        encoded.given.push_back(std::move(*given));
    }
    std::sort(encoded.given.begin(), encoded.given.end(),
              [](const Given& a, const Given& b) { return a.signal->first_bit < b.signal->first_bit; });
    return encoded;
}

std::string cansend_text(const Frame& frame, const Data& data) {
    std::string text = fmt::format("{:03X}#", frame.identifier);
    for (unsigned byte = 0; byte < frame.length; ++byte) {
        text += fmt::format("{:02X}", data[byte]);
    }
    return text;
}

}  // namespace cgw::signals
