#include <fmt/format.h>

#include "inspect/fields.hpp"

namespace cgw::inspect {
namespace {

struct TypeRow {
    Type type;
    std::size_t size;
    std::string_view name;
};

constexpr TypeRow types[] = {
    {Type::u8, 1, "u8"},   {Type::u16, 2, "u16"},     {Type::u32, 4, "u32"},
    {Type::f64, 8, "f64"}, {Type::bytes, 1, "bytes"}, {Type::text, 1, "text"},
};

const TypeRow& row_of(Type type) {
    return types[static_cast<std::size_t>(type)];
}

bool is_bytes(Type type) {
    return type == Type::bytes || type == Type::text;
}

void add_part(std::string& line, std::string_view part) {
    line += line.empty() || part.empty() ? "" : "; ";
    line += part;
}

std::string range_text(const Field& field) {
    if (field.range->maximum == 0xFFFF'FFFF) {
        return fmt::format("at least {}", field.range->minimum);
    }
    return field.range->minimum == field.range->maximum
               ? fmt::format("{}", field.range->minimum)
               : fmt::format("{}..{}", field.range->minimum, field.range->maximum);
}

std::string listed(std::span<const NamedValue> values) {
    std::string all;
    for (const NamedValue& value : values) {
        const bool last = &value == &values.back();
        const std::string_view before = all.empty() ? "" : last && value.name.empty() ? " or " : ", ";
        all += fmt::format("{}{}{}{}", before, value.value, value.name.empty() ? "" : " ", value.name);
    }
    return all;
}

}  // namespace

std::size_t size_of(Type type) {
    return row_of(type).size;
}

std::string_view name_of(Type type) {
    return row_of(type).name;
}

std::string values_text(const Field& field) {
    // A range of indices is told in hexadecimal by the note, a flag by its meaning.
    const bool told = field.shown == Shown::object_index || field.is_flag();
    if (field.range && !told) {
        return range_text(field);
    }
    return listed(field.values) + (field.bits.empty() ? "" : "; " + listed(field.bits));
}

std::string full_text(const Field& field) {
    std::string line(field.meaning);
    add_part(line, values_text(field));
    add_part(line, field.note);
    if (!field.source.empty()) {
        line += fmt::format(" ({})", field.source);
    }
    return line;
}

std::string type_text(const Field& field) {
    if (is_bytes(field.type)) {
        return fmt::format("{} bytes", field.count);
    }
    return field.count == 1 ? std::string(name_of(field.type))
                            : fmt::format("{} × {}", field.count, name_of(field.type));
}

}  // namespace cgw::inspect
