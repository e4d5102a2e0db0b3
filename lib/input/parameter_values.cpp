#include "input/parameter_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/numbers.hpp"
#include "diagnostic/rules/keys.hpp"
#include "input/parameter_keys.hpp"
#include "input/required.hpp"
#include "input/value_limits.hpp"
#include "parameter/value_text.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using diagnostic::Location;
using parameter::Assignment;
using parameter::Device;
using parameter::ParameterSet;
using parameter::Row;
using toml::Entry;
using toml::Kind;
using toml::Node;

std::string help_for_type(const Node& value) {
    if (value.kind == Kind::boolean) {
        return value.boolean ? "write 1" : "write 0";
    }
    if (value.kind != Kind::string) {
        return "";
    }
    std::string text = value.text;
    std::replace(text.begin(), text.end(), ',', '.');
    return base::parse_real(text) ? fmt::format("write {} without quotes", text) : "";
}

class ParameterReader {
  public:
    ParameterReader(Context& context, Device device)
        : context_(context),
          device_(device),
          set_(device == Device::governor ? context.settings().governor : context.settings().gateway),
          keys_(context, device) {}

    void read(const Node& table) {
        keys_.enter(table);
        for (const Entry& entry : table.entries) {
            const Row* row = keys_.resolve(entry);
            if (row == nullptr) {
                continue;
            }
            if (!row->settable()) {
                keys_.reject_needed_neighbours(entry);
                context_.report(rules::parameter_not_settable, entry.key_range,
                                fmt::format("{} is a measurement and cannot be set", parameter::label(*row)));
            } else if (entry.value.kind == Kind::array) {
                read_list(*row, entry);
            } else {
                assign(*row, entry, entry.value, entry.key_range);
            }
        }
    }

  private:
    // The last number that a list starting at `row` may reach (D16): the end of its array, or further where
    // the row says so (16400).
    static std::uint16_t list_end(const Row& row) {
        const auto end = static_cast<std::uint16_t>(row.array_first + row.array_size - 1);
        return std::max(end, row.list_end);
    }

    void read_list(const Row& first, const Entry& entry) {
        const std::vector<Node>& values = entry.value.elements;
        if (first.array_first == 0 || values.empty()) {
            context_.report(
                rules::value_type, entry.value.range,
                fmt::format("{} {}", parameter::label(first),
                            values.empty() ? "has an empty list" : "takes a single value, not a list"));
            set_.reject(first.number);
            return;
        }
        const std::size_t room = static_cast<std::size_t>(list_end(first)) - first.number + 1U;
        for (std::size_t i = 0; i < values.size() && i < room; ++i) {
            const Row* row = context_.catalogue.find(device_, static_cast<std::uint16_t>(first.number + i));
            if (row != nullptr) {
                assign(*row, entry, values[i], values[i].range);
            }
        }
        if (values.size() > room) {
            context_.report(rules::list_too_long, values[room].range,
                            fmt::format("the list has {} values, but {} to {} are only {}", values.size(),
                                        parameter::label(first), list_end(first), room));
        }
    }

    // `place` stands for the assignment when the same parameter is set again.
    void assign(const Row& row, const Entry& entry, const Node& value, const diagnostic::Range& place) {
        const auto [first, is_new] = places_.try_emplace(row.number, context_.at(place));
        if (!is_new) {
            keys_.reject_needed_neighbours(entry);
            context_.findings.report({&rules::parameter_duplicate,
                                      fmt::format("{} is set twice", parameter::label(row)),
                                      context_.at(place),
                                      {{first->second, "first set here"}}});
            return;
        }
        if (!check_value(row, value)) {
            if (value.kind == Kind::table) {
                keys_.reject_needed_neighbours(entry);
            }
            set_.reject(row.number);
            return;
        }
        Assignment assignment;
        assignment.row = &row;
        assignment.value = value.real;
        assignment.decimal_typed = value.kind == Kind::integer && value.notation == toml::Notation::decimal;
        assignment.spelling = entry.key;
        assignment.key = context_.at(entry.key_range);
        assignment.where = context_.at(value.range);
        set_.assign(std::move(assignment));
    }

    bool check_value(const Row& row, const Node& value) {
        const bool is_number = value.kind == Kind::integer || value.kind == Kind::real;
        if (!is_number) {
            context_.report(
                rules::value_type, value.range,
                fmt::format("{} takes a number, not {}", parameter::label(row), toml::to_text(value.kind)),
                help_for_type(value));
            return false;
        }
        if (value.kind == Kind::real && !row.decimal && std::isfinite(value.real)) {
            context_.report(
                rules::value_type, value.range,
                fmt::format("{} takes a whole number, not {}", parameter::label(row), value.text));
            return false;
        }
        const std::string problem = objection(row, value.real);
        if (!problem.empty()) {
            context_.report(rules::value_range, value.range,
                            fmt::format("{} is {}, {}", parameter::label(row), value.text, problem));
        }
        return problem.empty();
    }

    Context& context_;
    Device device_;
    ParameterSet& set_;
    KeyResolver keys_;
    std::map<std::uint16_t, Location> places_;
};

// ", where VALUE is 1..127"
std::string range_of(const Row* row) {
    const std::string range = row != nullptr ? parameter::range_text(*row) : "";
    return range.empty() ? "" : fmt::format(", where VALUE is {}", range);
}

}  // namespace

void read_parameters(Context& context, Device device, std::span<const Entry* const> tables) {
    ParameterReader reader(context, device);
    Location& place =
        device == Device::governor ? context.settings().governor_table : context.settings().gateway_table;
    place = context.at(tables.empty() ? diagnostic::Range{} : tables.front()->value.range);
    for (const Entry* table : tables) {
        reader.read(table->value);
    }
}

void report_missing(Context& context, Device device) {
    if (context.misplaced[static_cast<std::size_t>(device)]) {
        return;
    }
    const ParameterSet& set = context.settings().of(device);
    const auto is_there = [&](std::uint16_t number) {
        return set.find(number) != nullptr || set.rejected(number);
    };
    const Location& place =
        device == Device::governor ? context.settings().governor_table : context.settings().gateway_table;
    for (const Required& required : required_parameters) {
        if (required.device != device || is_there(required.number) ||
            (required.manual_timing != 0 &&
             (set.value(required.manual_timing) == 1 || set.rejected(required.manual_timing)))) {
            continue;
        }
        const Row* row = context.catalogue.find(device, required.number);
        const Row* manual = context.catalogue.find(device, required.manual_timing);
        context.report(
            rules::parameter_missing, place.range,
            fmt::format("{} of the {} is missing and has no default",
                        row != nullptr ? parameter::label(*row) : fmt::format("{}", required.number),
                        parameter::to_text(device)),
            manual != nullptr
                ? fmt::format("set it, or {} = 1 and the bit timing by hand", parameter::label(*manual))
                : fmt::format("below [{}.parameters] write {} = VALUE{}", parameter::to_text(device),
                              required.number, range_of(row)));
    }
}

}  // namespace cgw::input
