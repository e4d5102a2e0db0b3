// Repairs of how something is written: it means the same afterwards.
#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "eds/words.hpp"
#include "eds_check/context.hpp"
#include "eds_check/repairs.hpp"

namespace cgw::eds_check {
namespace {

constexpr std::size_t longest_shown = 60;

std::string shown(std::string_view text) {
    return base::printable(text.substr(0, longest_shown));
}

Repair replaced(const Context& context, const Span& span, std::string text) {
    std::string what = fmt::format("{} becomes {}", shown(context.document.view(span)), shown(text));
    return {std::move(what), {{Change::Kind::replace, span, std::move(text)}}};
}

Repair removed(const Span& span, std::string what) {
    return {std::move(what), {{Change::Kind::replace, span, ""}}};
}

// A literal without what CiA 306 does not know: a second prefix, a suffix, a plus sign.
std::string plain_literal(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const auto has_prefix = [](std::string_view rest) {
        return rest.size() > 1 && rest[0] == '0' && base::lower(rest[1]) == 'x';
    };
    while (has_prefix(text) && has_prefix(text.substr(2))) {
        text.remove_prefix(2);
    }
    while (text.size() > 1 && (base::lower(text.back()) == 'u' || base::lower(text.back()) == 'l')) {
        text.remove_suffix(1);
    }
    return std::string(text);
}

// The text is a number of CiA 306, of that value.
bool is_plainly(std::string_view text, const eds::Number& number) {
    const eds::Number other = eds::parse_number(text);
    return other.reading == eds::Number::Reading::number && !other.loose && !other.misplaced &&
           other.magnitude == number.magnitude && other.negative == number.negative &&
           other.node_id_relative == number.node_id_relative;
}

}  // namespace

std::optional<Repair> remove_byte_order_mark(const Context& context, const Span&) {
    const Span mark{0, 0, context.document.lines().front().begin};
    return removed(mark, "the byte order mark is taken away");
}

std::optional<Repair> mend_comment_mark(const Context& context, const Span& place) {
    const eds::Line& line = context.document.lines()[place.line];
    return Repair{"the comment begins with ; in the first column",
                  {{Change::Kind::replace, {place.line, line.begin, place.begin + 1}, ";"}}};
}

std::optional<Repair> remove_blanks(const Context&, const Span& place) {
    return removed(place, "the blanks are taken away");
}

std::optional<Repair> mend_spelling(const Context& context, const Span& place) {
    if (context.document.lines()[place.line].kind == eds::LineKind::section) {
        const eds::SectionName name = eds::parse_section_name(context.document.view(place));
        return replaced(context, place, std::string(eds::standard_name(name.kind)));
    }
    const std::string_view key = context.document.view(place);
    for (const eds::MisspeltKey& row : eds::misspelt_device_keys) {
        if (row.written.size() == key.size() && base::equal_ignoring_case(row.written, key)) {
            return replaced(context, place, std::string(row.meant));
        }
    }
    return std::nullopt;
}

std::optional<Repair> mend_section_name(const Context& context, const Span& place) {
    const std::string_view name = context.document.view(place);
    const eds::SectionName parsed = eds::parse_section_name(name);
    if (const std::string_view standard = eds::standard_name(parsed.kind); !standard.empty()) {
        return replaced(context, place, std::string(standard));
    }
    std::string right(name);
    const std::string lower = base::lowered(name);
    const std::size_t sub = lower.rfind("sub");
    if (parsed.kind != eds::SectionKind::sub_object || sub == std::string::npos) {
        return std::nullopt;
    }
    right.replace(sub, 3, "sub");
    if (right.size() == sub + 5 && right[sub + 3] == '0') {
        right.erase(sub + 3, 1);
    }
    return replaced(context, place, std::move(right));
}

std::optional<Repair> mend_key_case(const Context& context, const Span& place) {
    const KeyRow* const row = context.model.key_row(place.line);
    if (row == nullptr) {
        return std::nullopt;
    }
    const std::string_view key = context.document.view(place);
    return replaced(context, place, fmt::format("{}{}", row->name, key.substr(row->name.size())));
}

std::optional<Repair> mend_number_form(const Context& context, const Span& place) {
    const std::string_view text = context.document.view(place);
    const eds::Number number = eds::parse_number(text);
    const std::string plain = plain_literal(text);
    if (number.reading == eds::Number::Reading::number && is_plainly(plain, number)) {
        return replaced(context, place, plain);
    }
    std::string octets(text);
    std::erase(octets, ' ');
    if (number.reading == eds::Number::Reading::none && base::consists_of(octets, base::hexadecimal_digits)) {
        return replaced(context, place, octets);
    }
    return std::nullopt;
}

std::optional<Repair> mend_formula(const Context& context, const Span& place) {
    const std::string_view text = context.document.view(place);
    const eds::Number number = eds::parse_number(text);
    const std::size_t plus = text.find('+');
    if (number.reading != eds::Number::Reading::number || plus == std::string_view::npos) {
        const bool alone = number.reading == eds::Number::Reading::number && number.node_id_relative;
        return alone ? std::optional(replaced(context, place, "$NODEID")) : std::nullopt;
    }
    // The number as it is typed, where there is one only.
    const std::string_view first = base::trimmed(text.substr(0, plus));
    const std::string_view second = base::trimmed(text.substr(plus + 1));
    const std::string typed =
        fmt::format("$NODEID+{}", plain_literal(first.starts_with('$') ? second : first));
    return replaced(context, place,
                    is_plainly(typed, number) ? typed : fmt::format("$NODEID+0x{:X}", number.magnitude));
}

std::optional<Repair> remove_leading_zeros(const Context& context, const Span& place) {
    return replaced(context, place,
                    fmt::format("{}", eds::parse_number(context.document.view(place)).magnitude));
}

std::optional<Repair> lower_access(const Context& context, const Span& place) {
    return replaced(context, place, base::lowered(context.document.view(place)));
}

}  // namespace cgw::eds_check
