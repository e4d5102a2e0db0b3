#include "inspect/field_value.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "facts/gateway.hpp"

namespace cgw::inspect {
namespace {

double load_f64(std::span<const std::uint8_t> bytes, std::size_t at) {
    const std::uint64_t high = load(bytes, at + 4, 4);
    return std::bit_cast<double>(load(bytes, at, 4) | (high << 32));
}

// As the kind of field has it; text and bytes are no numbers.
std::string number_text(const Field& field, std::uint32_t number) {
    switch (field.shown) {
        case Shown::hexadecimal:
        case Shown::mapping:
            return fmt::format("0x{:0{}X}", number, 2 * size_of(field.type));
        case Shown::identifier:
            return base::identifier_text(number);
        case Shown::object_index:
            return base::object_text(number);
        default:
            return fmt::format("{}", number);
    }
}

std::string mapping_text(std::uint32_t mapping) {
    if (mapping == 0) {
        return "unused";
    }
    const std::uint32_t index = mapping >> 16;
    const std::string object =
        index == facts::object::unsigned16_dummy ? "dummy" : base::object_text(index, (mapping >> 8) & 0xFFU);
    return fmt::format("{}, {} bits", object, mapping & 0xFFU);
}

std::string named(const Field& field, std::uint32_t number) {
    std::string names;
    const auto add = [&](const NamedValue& value) {
        names += (names.empty() || value.name.empty() ? "" : ", ") + std::string(value.name);
    };
    for (const NamedValue& value : field.values) {
        if (value.value == (number & field.values_mask)) {
            add(value);
        }
    }
    for (const NamedValue& bit : field.bits) {
        if ((number & bit.value) != 0) {
            add(bit);
        }
    }
    return names;
}

// "401 / 427": the first record of the section takes the first.
std::string_view source_of(const Field& field, std::size_t record) {
    const std::size_t slash = field.source.find(" / ");
    if (slash == std::string_view::npos) {
        return field.source;
    }
    return record == 0 ? field.source.substr(0, slash) : field.source.substr(slash + 3);
}

// The parameter of this very element: "411" is the second of 410..415; "" where a list tells no more than the
// table does.
std::string parameter_of(const Field& field, std::size_t element, std::size_t record) {
    const std::string_view source = source_of(field, record);
    const std::size_t dots = source.find("..");
    if (dots == std::string_view::npos) {
        return std::string(source);
    }
    const auto first = base::parse_integer(source.substr(0, dots));
    const auto last = base::parse_integer(source.substr(dots + 2));
    const bool one_each = first && last && *last - *first + 1 == static_cast<std::int64_t>(field.count);
    return one_each ? fmt::format("{}", *first + static_cast<std::int64_t>(element)) : "";
}

std::string what_it_is(const Field& field, std::size_t element, std::size_t record) {
    std::string text(element < field.elements.size() ? field.elements[element] : field.meaning);
    std::erase(text, '`');
    const std::string parameter = parameter_of(field, element, record);
    return parameter.empty() ? text : fmt::format("{} ({})", text, parameter);
}

std::string meaning_of(const Outline& outline, const Field& field, std::size_t element, std::size_t record,
                       std::uint32_t number) {
    if (field.shown == Shown::reserved) {
        return "";
    }
    if (field.shown == Shown::mapping) {
        return mapping_text(number);
    }
    if (field.shown == Shown::parameter && number == 0 && !field.range) {
        return "none";
    }
    if (field.shown == Shown::microseconds && number != 0) {
        return base::milliseconds_text(number);
    }
    if (std::string name = field.shown == Shown::parameter
                               ? label_name(outline, static_cast<std::uint16_t>(number))
                               : named(field, number);
        !name.empty()) {
        return name;
    }
    return what_it_is(field, element, record);
}

bool is_named(const Field& field, std::uint32_t number) {
    std::uint32_t other_bits = number & ~field.values_mask;
    for (const NamedValue& bit : field.bits) {
        other_bits &= ~bit.value;
    }
    const auto holds = [&](const NamedValue& value) { return value.value == (number & field.values_mask); };
    return other_bits == 0 && std::any_of(field.values.begin(), field.values.end(), holds);
}

std::string wrong_with(const Outline& outline, const Field& field, std::uint32_t number) {
    if (field.shown == Shown::reserved) {
        return outline.known_minor && number != 0 ? "reserved: must be 0" : "";
    }
    const bool outside = field.range && (number < field.range->minimum || number > field.range->maximum);
    const bool unnamed = !field.values.empty() && !is_named(field, number);
    if (outside && field.is_flag()) {
        return "must be 0 or 1";
    }
    if (outside && field.shown == Shown::object_index) {
        return fmt::format("must be at least {}", base::object_text(field.range->minimum));
    }
    return outside || unnamed ? fmt::format("must be {}", values_text(field)) : "";
}

bool all_zero(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
        if (byte != 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string element_name(const Field& field, std::size_t element) {
    return field.count == 1 ? std::string(field.name) : fmt::format("{}[{}]", field.name, element);
}

std::string quoted(std::span<const std::uint8_t> text) {
    return "\"" + base::printable(std::string(text.begin(), text.end())) + "\"";
}

Item item_of(const Outline& outline, const Field& field, std::size_t element, std::size_t record,
             std::size_t at) {
    Item item;
    item.offset = at;
    item.type = field.type;
    if (field.type == Type::bytes || field.type == Type::text) {
        item.size = field.count;
        item.name = field.name;
        const auto content = outline.bytes.subspan(at, item.size);
        item.value = field.type == Type::text ? quoted(content) : "";
        item.meaning = field.shown == Shown::reserved ? "" : what_it_is(field, 0, record);
        const bool used = field.shown == Shown::reserved && outline.known_minor && !all_zero(content);
        item.wrong = used ? "reserved: must be 0" : "";
        return item;
    }
    item.size = size_of(field.type);
    item.name = element_name(field, element);
    if (field.type == Type::f64) {
        item.value = fmt::format("{}", load_f64(outline.bytes, at));
        item.meaning = what_it_is(field, element, record);
        return item;
    }
    const std::uint32_t number = load(outline.bytes, at, item.size);
    item.value = number_text(field, number);
    if (field.shown == Shown::word &&
        load(outline.bytes, at - field.offset + image::signal::is_signed, 1) != 0) {
        item.value = fmt::format("{}", static_cast<std::int16_t>(number));
    }
    item.meaning = meaning_of(outline, field, element, record, number);
    item.wrong = wrong_with(outline, field, number);
    return item;
}

}  // namespace cgw::inspect
