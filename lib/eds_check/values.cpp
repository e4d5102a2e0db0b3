// Values of variables: how their numbers are written, limits, what may be mapped.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "base/ascii.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds/value_text.hpp"
#include "eds_check/context.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using dictionary::TypeKind;
using dictionary::TypeRow;
using dictionary::Value;
using dictionary::Variable;
using object::Access;

constexpr std::array value_keys{ObjectKey::default_value, ObjectKey::parameter_value, ObjectKey::low_limit,
                                ObjectKey::high_limit};

double real_of(const Value& value, const TypeRow& type) {
    constexpr unsigned single = 32;
    return type.bits == single ? double{std::bit_cast<float>(static_cast<std::uint32_t>(value.number))}
                               : std::bit_cast<double>(value.number);
}

// Order of two values of the type; nothing where they have none: other kinds, or one follows the node number.
std::optional<bool> is_below(const Value& a, const Value& b, const TypeRow& type) {
    if (a.node_id_relative || b.node_id_relative) {
        return std::nullopt;
    }
    if (type.kind == TypeKind::real) {
        return real_of(a, type) < real_of(b, type);
    }
    if (type.kind == TypeKind::natural || type.kind == TypeKind::boolean) {
        return a.number < b.number;
    }
    if (type.kind == TypeKind::integer) {
        const std::uint64_t sign = std::uint64_t{1} << (type.bits - 1);
        return (a.number ^ sign) < (b.number ^ sign);
    }
    return std::nullopt;
}

bool has_crossed_limits(const Variable& variable) {
    return variable.low_limit && variable.high_limit &&
           is_below(*variable.high_limit, *variable.low_limit, dictionary::row_of(variable.type))
               .value_or(false);
}

// The value is one of `variable`, which has a limit on that side, and lies beyond it.
bool is_beyond(const Variable& variable, const Value& value) {
    const TypeRow& type = dictionary::row_of(variable.type);
    const bool below = variable.low_limit && is_below(value, *variable.low_limit, type).value_or(false);
    return below || (variable.high_limit && is_below(*variable.high_limit, value, type).value_or(false));
}

std::uint64_t mask_of(unsigned bits) {
    return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

// What a value that follows the node number comes to for one node.
Value of_node(const Value& value, std::uint8_t node_id, const TypeRow& type) {
    return {value.resolve(node_id) & mask_of(type.bits)};
}

// Beyond what the type holds. A number whose sign bit is set is a negative one.
bool overflows(const Value& value, std::uint8_t node_id, const TypeRow& type) {
    const std::uint64_t highest = mask_of(type.kind == TypeKind::integer ? type.bits - 1 : type.bits);
    return value.number <= highest && node_id > highest - value.number;
}

// Sub-indices of objects that are those of the device, whatever its node number.
struct DeviceRow {
    std::uint16_t first;
    std::uint16_t last;
    std::uint8_t first_sub_index;
    std::uint8_t last_sub_index;
};
constexpr std::uint8_t any = 0xFF;
constexpr std::uint8_t transmission_type = 2;
constexpr std::array device_values{DeviceRow{0x1000, 0x1001, 0, 0},
                                   DeviceRow{0x1018, 0x1018, 0, any},
                                   DeviceRow{0x1400, 0x15FF, transmission_type, transmission_type},
                                   DeviceRow{0x1600, 0x17FF, 0, any},
                                   DeviceRow{0x1800, 0x19FF, transmission_type, transmission_type},
                                   DeviceRow{0x1A00, 0x1BFF, 0, any}};

bool is_of_device(const Part& part) {
    return (part.is_sub_object && part.sub_index == 0) ||
           std::any_of(device_values.begin(), device_values.end(), [&](const DeviceRow& row) {
               return part.index >= row.first && part.index <= row.last &&
                      part.sub_index >= row.first_sub_index && part.sub_index <= row.last_sub_index;
           });
}

// The number that begins with 0 without being hexadecimal, also in $NODEID+number; nothing for other texts.
std::optional<Span> octal_in(const Context& context, std::uint32_t line) {
    Span span = context.document.value_span(line);
    const std::string_view text = context.document.view(span);
    if (const std::size_t plus = text.rfind('+'); plus != std::string_view::npos && text.starts_with('$')) {
        span.begin += static_cast<std::uint32_t>(text.find_first_not_of(" \t", plus + 1));
    }
    const std::string_view number = context.document.view(span);
    const bool octal = number.size() > 1 && number.front() == '0' && base::consists_of(number, "01234567");
    return octal ? std::optional(span) : std::nullopt;
}

// A number stands there, and no text or octets, which may begin with 0.
bool holds_number(const Context& context, std::uint32_t section, const KeyRow& row) {
    const eds::SectionName& name = context.sheet.sections.name(section);
    if (row.holds != Holds::value || row.tail != Tail::none) {
        return row.holds == Holds::number;
    }
    const Group* const group = context.model.find(name);
    const dictionary::Object* const object = group != nullptr ? group->object : nullptr;
    const Variable* const variable = object != nullptr  ? object->find(name.sub_index)
                                     : group != nullptr ? group->own_variable()
                                                        : nullptr;
    const TypeKind kind = variable != nullptr ? dictionary::row_of(variable->type).kind : TypeKind::structure;
    return dictionary::is_numeric(kind) && kind != TypeKind::real;
}

// Calls `take(span, text)` for each number that begins with 0 without being hexadecimal.
template <typename Take>
void for_each_octal(const Context& context, Take take) {
    for_each_entry(context, [&](std::uint32_t section, std::uint32_t line) {
        const KeyRow* const row = context.model.key_row(line);
        const auto span = row != nullptr ? octal_in(context, line) : std::nullopt;
        if (span && holds_number(context, section, *row)) {
            take(*span, context.document.view(*span));
        }
    });
}

std::uint64_t as_decimal(std::string_view text) {
    return eds::parse_number(text.substr(std::min(text.find_first_not_of('0'), text.size() - 1))).magnitude;
}

// Nodes for which a value is tried: the known one, else the first and the last.
std::vector<std::uint8_t> nodes_of(const Context& context) {
    constexpr std::uint8_t highest_node = 127;
    const auto known = context.node_id();
    return known ? std::vector<std::uint8_t>{*known} : std::vector<std::uint8_t>{1, highest_node};
}

// What is wrong with the value of a variable; "" when nothing is.
std::string out_of_limits(const Context& context, const Variable& variable, const Value& value) {
    const TypeRow& type = dictionary::row_of(variable.type);
    if (!value.node_id_relative) {
        return is_beyond(variable, value) ? "lies outside its limits" : "";
    }
    for (const std::uint8_t node : nodes_of(context)) {
        if (overflows(value, node, type)) {
            return fmt::format("is too large for {} with node id {}", type.name, node);
        }
        if (is_beyond(variable, of_node(value, node, type))) {
            return fmt::format("lies outside its limits with node id {}", node);
        }
    }
    return "";
}

void check_flags(const Context& context) {
    constexpr std::uint64_t known = 3;
    for_each_part(context, [&](const Group&, const Part& part) {
        const std::uint32_t line = part.lines[ObjectKey::flags];
        const auto flags = context.number(line);
        if (flags && *flags > known && *flags <= eds::highest_u32) {
            context.reading.report(rules::eds_value_limits, context.document.value_span(line),
                                   fmt::format("ObjFlags of {} is 0x{:X}; only bits 0 and 1 have a meaning",
                                               context.label(part), *flags));
        }
    });
}

}  // namespace

void check_octal_numbers(const Context& context) {
    for_each_octal(context, [&](const Span& span, std::string_view text) {
        const std::uint64_t octal = eds::parse_number(text).magnitude;
        if (as_decimal(text) != octal) {
            context.reading.report(
                rules::eds_octal, span,
                fmt::format("{} begins with 0: it is octal, and means {}", text.substr(0, 30), octal),
                fmt::format("write {} or 0x{:X}", octal, octal));
        }
    });
}

void check_leading_zeros(const Context& context) {
    for_each_octal(context, [&](const Span& span, std::string_view text) {
        const std::uint64_t octal = eds::parse_number(text).magnitude;
        if (as_decimal(text) == octal) {
            context.reading.report(rules::eds_leading_zero, span,
                                   fmt::format("{} begins with 0, as octal numbers do", text.substr(0, 30)),
                                   fmt::format("write {}", octal));
        }
    });
}

void check_limits(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        if (part.variable == nullptr || !has_crossed_limits(*part.variable)) {
            return;
        }
        context.reading.report(
            rules::eds_limits, context.document.value_span(part.lines[ObjectKey::low_limit]),
            fmt::format("LowLimit of {} is above its HighLimit", context.label(part)), "",
            {{context.reading.location(context.document.value_span(part.lines[ObjectKey::high_limit])),
              "the HighLimit"}});
    });
}

void check_values_in_limits(const Context& context) {
    check_flags(context);
    for_each_part(context, [&](const Group&, const Part& part) {
        const Variable* const variable = part.variable;
        if (variable == nullptr || has_crossed_limits(*variable)) {
            return;
        }
        for (const auto& [key, name, value] :
             {std::tuple(ObjectKey::default_value, "DefaultValue",
                         variable->no_default ? nullptr : &variable->default_value),
              std::tuple(ObjectKey::parameter_value, "ParameterValue",
                         variable->parameter_value ? &*variable->parameter_value : nullptr)}) {
            const std::string what = value != nullptr && context.stated(part.lines[key])
                                         ? out_of_limits(context, *variable, *value)
                                         : "";
            if (!what.empty()) {
                context.reading.report(rules::eds_value_limits, context.document.value_span(part.lines[key]),
                                       fmt::format("{} of {} {}", name, context.label(part), what));
            }
        }
    });
}

void check_formula_places(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        if (part.variable == nullptr || !is_of_device(part)) {
            return;
        }
        const auto judge = [&](ObjectKey key, bool follows) {
            if (follows && context.stated(part.lines[key])) {
                context.reading.report(
                    rules::eds_formula_place, context.document.value_span(part.lines[key]),
                    fmt::format("{}, and the value of {} is the same for every node",
                                context.reading.quoted_value(part.lines[key]), context.label(part)));
            }
        };
        judge(ObjectKey::default_value, part.variable->default_value.node_id_relative);
        judge(ObjectKey::parameter_value,
              part.variable->parameter_value && part.variable->parameter_value->node_id_relative);
    });
}

void check_signed_values(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        if (part.variable == nullptr || dictionary::row_of(part.variable->type).kind != TypeKind::integer) {
            return;
        }
        const unsigned bits = dictionary::row_of(part.variable->type).bits;
        for (const ObjectKey key : value_keys) {
            const auto number = context.number(part.lines[key]);
            const std::uint64_t sign = std::uint64_t{1} << (bits - 1);
            if (!number || (*number & sign) == 0 || (bits < 64 && *number >> bits != 0)) {
                continue;
            }
            const std::string_view text = context.document.value(part.lines[key]);
            context.reading.report(rules::eds_signed_value, context.document.value_span(part.lines[key]),
                                   fmt::format("{} stands for a negative number of {}", text.substr(0, 30),
                                               dictionary::row_of(part.variable->type).name),
                                   fmt::format("write -{}", (~*number + 1) & (sign | (sign - 1))));
        }
    });
}

void check_mappable_access(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        if (part.variable != nullptr && part.variable->pdo_mapping && part.variable->access == Access::rw) {
            context.reading.report(
                rules::eds_mappable_rw, context.document.value_span(part.lines[ObjectKey::access_type]),
                fmt::format("{} can be mapped, and rw does not say into which PDOs", context.label(part)),
                "write rww for RPDOs, rwr for TPDOs; rw has both in mind");
        }
    });
}

void check_mappable_types(const Context& context) {
    constexpr unsigned most_bits = 64;
    for_each_part(context, [&](const Group&, const Part& part) {
        if (part.variable == nullptr || !part.variable->pdo_mapping) {
            return;
        }
        const TypeRow& type = dictionary::row_of(part.variable->type);
        if (type.kind == TypeKind::domain || type.kind == TypeKind::structure || type.bits > most_bits) {
            context.reading.report(
                rules::eds_mappable_type, context.document.value_span(part.lines[ObjectKey::pdo_mapping]),
                fmt::format("{} is {}, which fits into no PDO", context.label(part), type.name));
        }
    });
}

void check_domain_defaults(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        const std::uint32_t line = part.lines[ObjectKey::default_value];
        if (part.variable != nullptr && part.variable->type == object::DataType::domain &&
            context.stated(line) && eds::is_number_zero(context.document.value(line))) {
            context.reading.report(
                rules::eds_domain_default, context.document.value_span(line),
                fmt::format("{} is a DOMAIN, and a number is its DefaultValue", context.label(part)));
        }
    });
}

}  // namespace cgw::eds_check
