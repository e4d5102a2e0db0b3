#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "catalogue/objects.hpp"
#include "config/numbers.hpp"
#include "explain/entries.hpp"
#include "explain/text.hpp"
#include "explain/wording.hpp"
#include "input/required.hpp"

namespace cgw::explain {

namespace {

using catalogue::ErrorDescription;
using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using parameter::Role;
using parameter::Row;

std::string list_text(const Row& row) {
    return row.level == 0 ? std::string(to_text(row.list))
                          : fmt::format("{}, level {}", to_text(row.list), row.level);
}

std::string array_text(const Row& row) {
    if (row.array_first == 0) {
        return {};
    }
    return fmt::format("element {} of {}, {}..{}", row.array_index(), array_name(row), row.array_first,
                       row.array_first + row.array_size - 1);
}

std::string default_text(const Row& row) {
    if (!row.settable()) {
        return {};
    }
    for (const input::Required& required : input::required_parameters) {
        if (required.device == row.device && required.number == row.number) {
            return required.manual_timing == 0
                       ? "none, it must be set"
                       : fmt::format("none, it must be set unless {} is 1", required.manual_timing);
        }
    }
    return row.minimum.value_or(0) <= 0 ? "0" : "none; the device keeps what it has";
}

std::string typed_text(const Row& row) {
    if (!row.settable() || row.base != parameter::Base::hexadecimal) {
        return {};
    }
    return "in hexadecimal, as the manual prints it: write 0x";
}

std::string limit_text(std::optional<double> constant, std::uint16_t reference, std::string_view unit) {
    if (reference != 0) {
        return fmt::format("the value of {}", reference);
    }
    return fmt::format("{}{}{}", constant ? base::to_text(*constant) : "?", unit.empty() ? "" : " ", unit);
}

// How a measurement travels in TPDO4..16; the gateway's own measurements never do.
std::vector<std::string> word_text(const Row& row) {
    if (row.list != parameter::List::measurement || row.device != Device::governor || row.width == 0) {
        return {};
    }
    if (row.is_bit()) {
        return {"a single bit: TPDO4..16 do not carry it"};
    }
    std::vector<std::string> lines{
        fmt::format("{} bits, {}: an entry of {} while one of TPDO4..16 carries it", row.width,
                    row.is_signed ? "signed" : "unsigned", row.is_signed ? "2002h" : "2001h")};
    if (row.scaling) {
        const parameter::Scaling& scaling = *row.scaling;
        const bool known = scaling.external_minimum || scaling.external_minimum_parameter != 0;
        lines.push_back(
            known ? fmt::format(
                        "{} is {}, {} is {}", scaling.internal_minimum,
                        limit_text(scaling.external_minimum, scaling.external_minimum_parameter, row.unit),
                        scaling.internal_maximum,
                        limit_text(scaling.external_maximum, scaling.external_maximum_parameter, row.unit))
                  : fmt::format("{}..{}, what they mean is not printed", scaling.internal_minimum,
                                scaling.internal_maximum));
    }
    return lines;
}

// What both devices hold of the same thing.
struct Counterpart {
    std::uint16_t governor;
    std::uint16_t gateway;
    std::string_view demand;
};

constexpr Counterpart counterparts[] = {
    {400, 400, "set both alike"},
    {401, 402, "they must agree"},
    {403, 401, "they must agree"},
    {416, 416, "one bus, one bit rate"},
    {4406, 4400, "without both nothing is exchanged"},
};

std::string counterpart_text(const Row& row, const Catalogue& catalogue) {
    const bool in_governor = row.device == Device::governor;
    for (const Counterpart& both : counterparts) {
        if (row.program == parameter::Program::application &&
            row.number == (in_governor ? both.governor : both.gateway)) {
            const Device other = in_governor ? Device::gateway : Device::governor;
            const Row* const partner = catalogue.find(other, in_governor ? both.gateway : both.governor);
            return partner == nullptr
                       ? ""
                       : fmt::format("{} {}: {}", to_text(other), label(*partner), both.demand);
        }
    }
    return {};
}

// 8nn and 48nn, 9nn and 49nn belong together.
std::string partner_text(const Row& row, const Catalogue& catalogue) {
    const bool assignment = row.role == Role::switch_assignment || row.role == Role::sensor_assignment;
    const bool type = row.role == Role::switch_type || row.role == Role::sensor_type;
    if (!assignment && !type) {
        return counterpart_text(row, catalogue);
    }
    const std::uint16_t number =
        assignment ? config::governor::type_of(row.number) : config::governor::assignment_of(row.number);
    return fmt::format(
        "{}, {}", reference_text(number, row.device, row.program, catalogue),
        assignment ? "which says where it comes from" : "which says which input, bit or channel");
}

std::string bit_text(const Row& row) {
    const auto bit =
        row.program == Program::application ? catalogue::find_object_bit(row.number) : std::nullopt;
    if (!bit) {
        return {};
    }
    return fmt::format("bit {} of {}", bit->bit,
                       bit->sub == 0 ? object_text(bit->index) : object_text(bit->index, bit->sub));
}

std::vector<std::string> value_lines(const Row& row) {
    std::vector<std::string> lines;
    for (const parameter::NamedValue& value : row.values) {
        lines.push_back(fmt::format("{}: {}", value_text(row, value.value), value.text));
    }
    return lines;
}

// Errors that one reads this parameter with: 2401 tells more about 3071.
std::string belongs_text(const Row& row, const Catalogue& catalogue) {
    std::string text;
    for (const ErrorDescription& error : catalogue::shipped_errors()) {
        const bool told = std::find(error.with.begin(), error.with.end(), row.number) != error.with.end();
        const bool same_world = error.shown_by(row.device) && error.program == row.program;
        const bool is_error = catalogue::find_error(row.device, row.program, row.number) != nullptr;
        if (told && same_world && !is_error) {
            text += fmt::format("{}{}", text.empty() ? "" : ", ",
                                reference_text(error.number, row.device, row.program, catalogue));
        }
    }
    return text;
}

std::vector<std::string> alias_lines(const Row& row) {
    std::vector<std::string> lines(row.aliases.begin(), row.aliases.end());
    for (const std::string_view misprint : row.misprints) {
        lines.push_back(fmt::format("{}, a misprint", misprint));
    }
    return lines;
}

// Why a sensor or switch over CANopen fails, for the rows that make it one.
std::string failure_text(const Row& row) {
    switch (row.role) {
        case Role::switch_assignment:
        case Role::switch_type:
            return "cgw explain switch-error tells when it falls to 0";
        case Role::sensor_assignment:
        case Role::sensor_type:
            return "cgw explain sensor-error tells when it counts as faulty";
        case Role::none:
            return {};
    }
    return {};
}

}  // namespace

std::vector<std::string> bit_lines(const std::vector<parameter::NamedBit>& bits) {
    std::vector<std::string> lines;
    for (std::size_t first = 0; first < bits.size();) {
        const auto merged = [&](std::size_t last) {
            return merged_text(
                fmt::format("bit {}, {}: {}", bits[first].bit, bits[first].name, bits[first].text),
                fmt::format("bit {}, {}: {}", bits[last].bit, bits[last].name, bits[last].text));
        };
        std::size_t last = first;
        while (last + 1 < bits.size() && bits[last + 1].bit == bits[last].bit + 1 && merged(last + 1)) {
            ++last;
        }
        lines.push_back(*merged(last));
        first = last + 1;
    }
    return lines;
}

Entry parameter_entry(const Row& row, const Catalogue& catalogue) {
    Entry entry{"parameter", fmt::format("{} {}", program_text(row.device, row.program), label(row)), {}};
    entry.add("meaning", row.text);
    entry.add("list", list_text(row));
    entry.add("array", array_text(row));
    entry.add("range", range_text(row));
    entry.add("typed", typed_text(row));
    entry.add("default", default_text(row));
    entry.add("values", value_lines(row));
    entry.add("bits", bit_lines({row.bits.begin(), row.bits.end()}));
    entry.add("word", word_text(row));
    entry.add("seen in", bit_text(row));
    entry.add("feeds", row.used);
    entry.add("partner", partner_text(row, catalogue));
    entry.add("tells of", belongs_text(row, catalogue));
    entry.add("failure", failure_text(row));
    entry.add("also", alias_lines(row));
    entry.add("source", row.section);
    if (!row.pages.empty()) {
        entry.add("pages", fmt::format("{} of GWM", fmt::join(row.pages, ", ")));
    }
    return entry;
}

std::vector<Entry> row_entries(const std::vector<const Row*>& rows, const Catalogue& catalogue) {
    std::vector<Entry> entries;
    std::vector<const ErrorDescription*> errors;
    for (const Row* row : rows) {
        entries.push_back(parameter_entry(*row, catalogue));
        const ErrorDescription* error = catalogue::find_error(row->device, row->program, row->number);
        if (error != nullptr && std::find(errors.begin(), errors.end(), error) == errors.end()) {
            errors.push_back(error);
        }
    }
    std::vector<Entry> all;
    all.reserve(errors.size() + entries.size());
    for (const ErrorDescription* error : errors) {
        all.push_back(error_entry(*error, catalogue));
    }
    all.insert(all.end(), std::make_move_iterator(entries.begin()), std::make_move_iterator(entries.end()));
    return all;
}

}  // namespace cgw::explain
