// What stands in a file in short form: sub-objects by CompactSubObj with their lists, PDO parameters by
// CompactPDO.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "diagnostic/rules/eds.hpp"
#include "eds/reader.hpp"
#include "eds/reading.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;
using dictionary::Object;
using dictionary::Variable;
using object::DataType;

Variable* find(Object& object, std::uint32_t sub_index) {
    const auto found = std::lower_bound(
        object.variables.begin(), object.variables.end(), sub_index,
        [](const Variable& variable, std::uint32_t wanted) { return variable.sub_index < wanted; });
    return found != object.variables.end() && found->sub_index == sub_index ? &*found : nullptr;
}

void sort(std::vector<Variable>& variables) {
    std::sort(variables.begin(), variables.end(),
              [](const Variable& a, const Variable& b) { return a.sub_index < b.sub_index; });
}

Variable entry_count(std::uint8_t count) {
    Variable variable;
    variable.name = "NrOfObjects";
    variable.default_value.number = count;
    return variable;
}

void take(Reading& reading, SectionKind kind, Variable& variable, std::uint32_t line) {
    if (kind == SectionKind::names) {
        variable.name = reading.text(line);
    } else if (kind == SectionKind::denotations) {
        variable.denotation = reading.text(line);
    } else {
        variable.parameter_value = reading.value(line, dictionary::row_of(variable.type));
    }
}

// A kind of PDO: where its parameters stand.
struct PdoRow {
    std::uint16_t communication;
    std::uint16_t mapping;
    std::string_view prefix;
};
constexpr PdoRow receive{0x1400, 0x1600, "RPDO"};
constexpr PdoRow transmit{0x1800, 0x1A00, "TPDO"};
constexpr unsigned most_pdos = 512;
constexpr std::uint8_t most_mapped = 64;

// CiA 301: the communication parameter of a PDO, from sub-index 1.
struct ParameterRow {
    std::string_view name;
    DataType type;
};
constexpr std::array parameter_rows{
    ParameterRow{"COB-ID", DataType::unsigned32},
    ParameterRow{"Transmission Type", DataType::unsigned8},
    ParameterRow{"Inhibit Time", DataType::unsigned16},
    ParameterRow{"Compatibility Entry", DataType::unsigned8},
    ParameterRow{"Event Timer", DataType::unsigned16},
    ParameterRow{"SYNC Start Value", DataType::unsigned8},
};

Variable implied(std::uint8_t sub_index, std::string name, DataType type) {
    Variable variable;
    variable.sub_index = sub_index;
    variable.name = std::move(name);
    variable.type = type;
    variable.access = object::Access::rw;
    variable.no_default = true;
    return variable;
}

Object communication_parameter(const PdoRow& row, unsigned pdo, std::uint32_t mask) {
    Object object;
    object.index = static_cast<std::uint16_t>(row.communication + pdo);
    object.name = fmt::format("{}{} Communication Parameter", row.prefix, pdo + 1);
    object.code = object::ObjectCode::record;
    object.variables.push_back(entry_count(0));
    for (std::size_t i = 0; i < parameter_rows.size(); ++i) {
        if ((mask >> i & 1U) != 0) {
            const auto sub_index = static_cast<std::uint8_t>(i + 1);
            object.variables.push_back(
                implied(sub_index, std::string(parameter_rows[i].name), parameter_rows[i].type));
            object.variables.front().default_value.number = sub_index;
        }
    }
    return object;
}

Object mapping_parameter(const PdoRow& row, unsigned pdo) {
    Object object;
    object.index = static_cast<std::uint16_t>(row.mapping + pdo);
    object.name = fmt::format("{}{} Mapping Parameter", row.prefix, pdo + 1);
    object.code = object::ObjectCode::record;
    object.variables.push_back(implied(0, "NrOfObjects", DataType::unsigned8));
    for (std::uint8_t sub = 1; sub <= most_mapped; ++sub) {
        object.variables.push_back(implied(sub, fmt::format("Mapped Object {}", sub), DataType::unsigned32));
    }
    return object;
}

bool has(const std::vector<Object>& objects, std::size_t count, std::uint16_t index) {
    const auto end = objects.begin() + static_cast<std::ptrdiff_t>(count);
    const auto found =
        std::lower_bound(objects.begin(), end, index,
                         [](const Object& object, unsigned wanted) { return object.index < wanted; });
    return found != end && found->index == index;
}

// The PDOs that the file describes count among `count`; the others are the lowest free ones.
void add_pdos(const PdoRow& row, unsigned count, std::uint32_t mask, std::vector<Object>& objects) {
    const std::size_t described = objects.size();
    unsigned missing = std::min(count, most_pdos);
    for (unsigned pdo = 0; pdo < most_pdos; ++pdo) {
        const bool is_described =
            has(objects, described, static_cast<std::uint16_t>(row.communication + pdo));
        missing -= missing > 0 && is_described ? 1U : 0U;
    }
    for (unsigned pdo = 0; pdo < most_pdos && missing > 0; ++pdo) {
        if (has(objects, described, static_cast<std::uint16_t>(row.communication + pdo))) {
            continue;
        }
        objects.push_back(communication_parameter(row, pdo, mask));
        if (!has(objects, described, static_cast<std::uint16_t>(row.mapping + pdo))) {
            objects.push_back(mapping_parameter(row, pdo));
        }
        --missing;
    }
    std::sort(objects.begin(), objects.end(),
              [](const Object& a, const Object& b) { return a.index < b.index; });
}

}  // namespace

void add_compact_variables(Reading& reading, std::uint32_t section, std::uint8_t count, Object& object) {
    if (reading.variables + count >= most_variables) {
        reading.report(
            rules::eds_too_much, reading.document.name_span(reading.section(section)),
            fmt::format("the sub-objects of {} are left out", reading.quoted(reading.section(section))));
        return;
    }
    const std::optional<Variable> model = read_variable(reading, section);
    if (!model) {
        return;
    }
    const std::size_t described = object.variables.size();
    std::array<bool, highest_u8 + 1> taken{};
    for (const Variable& variable : object.variables) {
        taken[variable.sub_index] = true;
    }
    object.variables.reserve(described + count + 1U);
    if (!taken[0]) {
        object.variables.push_back(entry_count(count));
    }
    for (unsigned sub = 1; sub <= count; ++sub) {
        if (!taken[sub]) {
            Variable& variable = object.variables.emplace_back(*model);
            variable.sub_index = static_cast<std::uint8_t>(sub);
            variable.name = fmt::format("{}{}", model->name, sub);
        }
    }
    reading.variables += object.variables.size() - described;
    sort(object.variables);
}

void read_compact_entries(Reading& reading, std::uint32_t section, Object& object) {
    const Section& of = reading.section(section);
    const SectionKind kind = reading.sections.name(section).kind;
    reading.numbered(of, [&](std::uint32_t number, std::uint32_t line) {
        if (kind == SectionKind::object_links) {
            if (const auto index = reading.number(line, highest_u16)) {
                object.object_links.push_back(static_cast<std::uint16_t>(*index));
            }
            return;
        }
        if (Variable* const variable = find(object, number)) {
            take(reading, kind, *variable, line);
            return;
        }
        reading.report(rules::eds_entry_alone, reading.document.key_span(line),
                       fmt::format("{} names sub-index {}, which {:04X}h does not have", reading.quoted(of),
                                   number, object.index));
    });
}

void add_compact_pdos(const dictionary::DeviceInformation& device, std::vector<Object>& objects) {
    if (device.compact_pdo != 0) {
        add_pdos(receive, device.receive_pdos, device.compact_pdo, objects);
        add_pdos(transmit, device.transmit_pdos, device.compact_pdo, objects);
    }
}

}  // namespace cgw::eds
