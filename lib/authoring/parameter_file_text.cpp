#include "authoring/parameter_file_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "authoring/declaration_text.hpp"
#include "authoring/toml_text.hpp"
#include "base/numbers.hpp"
#include "config/numbers.hpp"
#include "input/parameter_file.hpp"

namespace cgw::authoring {
namespace {

using parameter::Device;
using parameter::Row;

constexpr std::size_t longest_list = 4;  // one TPDO, or the four RPDOs: who reads it still counts along

bool starts_list(std::span<const WrittenValue> values) {
    const Row& first = *values.front().row;
    if (first.array_first != first.number || first.array_size > longest_list ||
        values.size() < first.array_size) {
        return false;
    }
    return values[first.array_size - 1U].row->number == first.number + first.array_size - 1;
}

std::string key(const Row& row) {
    return row.name.empty() ? fmt::format("{}", row.number) : toml_string(parameter::label(row));
}

std::string list_key(const Row& first) {
    return toml_string(fmt::format("{} {}", first.number, parameter::array_name(first)));
}

bool is_assignment(const Row& row) {
    return row.device == Device::governor && row.number >= config::governor::tpdo_assignment &&
           row.number <= config::governor::last_tpdo_assignment;
}

// "Speed, SpeedSetp, -": what an assigned number is called.
std::string measurement_name(const WrittenValue& value, const parameter::Catalogue& catalogue) {
    const auto number = base::parse_integer(value.literal);
    const bool fits = number && *number > 0 && *number <= 65535;
    const Row* row = fits ? catalogue.find(Device::governor, static_cast<std::uint16_t>(*number)) : nullptr;
    return row != nullptr && !row->name.empty() ? std::string(row->name) : "-";
}

std::string remark(std::span<const WrittenValue> values, const parameter::Catalogue& catalogue) {
    const Row& row = *values.front().row;
    if (is_assignment(row)) {
        std::vector<std::string> names;
        for (const WrittenValue& value : values) {
            names.push_back(measurement_name(value, catalogue));
        }
        const bool says_something =
            std::any_of(names.begin(), names.end(), [](const std::string& name) { return name != "-"; });
        return says_something ? fmt::format("    # {}", fmt::join(names, ", ")) : "";
    }
    return row.unit.empty() ? "" : fmt::format("    # {}", row.unit);
}

std::string assignment_text(std::span<const WrittenValue> values, const parameter::Catalogue& catalogue) {
    const Row& row = *values.front().row;
    const std::string first =
        values.size() == 1 ? "" : fmt::format("{}..{}; the first: ", row.number, values.back().row->number);
    std::string text = row.text.empty() ? "" : fmt::format("# {}{}\n", first, row.text);
    if (values.size() == 1) {
        text += fmt::format("{} = {}", key(row), values.front().literal);
    } else {
        std::vector<std::string_view> literals;
        for (const WrittenValue& value : values) {
            literals.push_back(value.literal);
        }
        text += fmt::format("{} = [{}]", list_key(row), fmt::join(literals, ", "));
    }
    return text + remark(values, catalogue) + "\n";
}

std::string table_text(Device device, std::span<const WrittenValue> values,
                       const parameter::Catalogue& catalogue) {
    std::string text = fmt::format("\n[{}.parameters]\n", parameter::to_text(device));
    while (!values.empty()) {
        const std::size_t count = starts_list(values) ? values.front().row->array_size : 1;
        text += assignment_text(values.first(count), catalogue);
        values = values.subspan(count);
    }
    return text;
}

std::string document_text(const parameter::DocumentInformation& document) {
    std::string text;
    if (document.created) {
        text += fmt::format("created = {:04}-{:02}-{:02}\n", document.created->year, document.created->month,
                            document.created->day);
    }
    text += document.author.empty() ? "" : fmt::format("author = {}\n", toml_string(document.author));
    text += document.revision == 0 ? "" : fmt::format("revision = {}\n", document.revision);
    return text.empty() ? "" : "\n[document]\n" + text;
}

std::string identity_text(const parameter::Identity& identity) {
    if (identity.software_version == 0 && identity.serial_date == 0 && identity.serial_number == 0) {
        return "";
    }
    return fmt::format("identity = {{ software_version = {}, serial_date = {}, serial_number = {} }}\n",
                       identity.software_version, identity.serial_date, identity.serial_number);
}

std::string bit_timing_text(std::string_view bus, const std::optional<parameter::BitTiming>& timing) {
    return timing ? fmt::format("bit_timing.{} = {{ clock_hz = {}, family = \"{}\" }}\n", bus,
                                timing->clock_hz, timing->controller->name)
                  : "";
}

// The table [gateway] itself, which stands before its parameters.
std::string gateway_text(const Draft& draft) {
    const std::string text = identity_text(draft.identity) + bit_timing_text("can1", draft.can1_bit_timing) +
                             bit_timing_text("can2", draft.can2_bit_timing);
    return text.empty() ? "" : "\n[gateway]\n" + text;
}

}  // namespace

std::string parameter_file_text(const Draft& draft, const parameter::Catalogue& catalogue) {
    std::string text;
    for (const std::string& line : draft.remarks) {
        text += fmt::format("# {}\n", line);
    }
    text += fmt::format("format = {}\n", input::parameter_file_format);
    text += draft.title.empty() ? "" : fmt::format("title = {}\n", toml_string(draft.title));
    text += document_text(draft.document);
    // [[governor.declare]] must have [governor] before it.
    text += draft.main_cycle_us || !draft.declarations.empty() ? "\n[governor]\n" : "";
    text += draft.main_cycle_us ? fmt::format("main_cycle_us = {}\n", *draft.main_cycle_us) : "";
    text += table_text(Device::governor, draft.governor, catalogue);
    for (const Row* row : draft.declarations) {
        text += declaration_text(*row);
    }
    text += gateway_text(draft);
    text += table_text(Device::gateway, draft.gateway, catalogue);
    if (!draft.network_nodes.empty()) {
        text += fmt::format("\n[network]\nnodes = [{}]\n", fmt::join(draft.network_nodes, ", "));
    }
    return text;
}

}  // namespace cgw::authoring
