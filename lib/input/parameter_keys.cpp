#include "input/parameter_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/keys.hpp"
#include "input/required.hpp"

namespace cgw::input {

namespace rules = diagnostic::rules;
using parameter::Catalogue;
using parameter::Device;
using parameter::Row;

namespace {

Device other_device(Device device) {
    return device == Device::governor ? Device::gateway : Device::governor;
}

parameter::ParameterSet& set_of(Context& context, Device device) {
    return device == Device::governor ? context.settings().governor : context.settings().gateway;
}

const std::vector<const toml::Entry*>& tables_of(const Context& context, Device device) {
    return device == Device::governor ? context.postponed.governor_parameters
                                      : context.postponed.gateway_parameters;
}

const Row* row_of(const Catalogue& catalogue, Device device, const Spelling& spelling) {
    if (spelling.number_text.empty()) {
        return catalogue.find(device, spelling.name);
    }
    if (!spelling.number) {
        return nullptr;
    }
    const Row* by_number = catalogue.find(device, *spelling.number);
    if (spelling.name.empty() && by_number != nullptr) {
        return by_number;
    }
    if (!spelling.name.empty() && by_number != nullptr) {
        const Row* by_name = catalogue.find(device, spelling.name);
        // A row without a name takes any name that is nobody else's: only its governor knows better (D13).
        if (by_name == by_number || (by_name == nullptr && by_number->name.empty())) {
            return by_number;
        }
    }
    return catalogue.find_misprint(device, *spelling.number, spelling.name);
}

// What was probably meant is not reported as missing too: one slip, one finding.
void reject_array(parameter::ParameterSet& set, const Row& row) {
    const std::uint16_t first = row.array_size == 0 ? row.number : row.array_first;
    const int count = std::max<int>(row.array_size, 1);
    for (int i = 0; i < count; ++i) {
        set.reject(static_cast<std::uint16_t>(first + i));
    }
}

// "4.3" is a table in a table to TOML, and 403 with a slip in it to its author.
std::vector<std::string> texts_of(const toml::Entry& entry) {
    constexpr std::size_t longest = 6;  // a number of five digits and one more character
    std::vector<std::string> texts;
    const auto add = [&](std::string text) {
        if (text.size() <= longest && text.find_first_of(base::digits) != text.npos) {
            texts.push_back(std::move(text));
        }
    };
    if (entry.key.size() > longest) {
        return texts;
    }
    add(entry.key);
    for (const toml::Entry& below : entry.value.entries) {
        add(below.key.size() < longest ? entry.key + "." + below.key : "");
    }
    return texts;
}

}  // namespace

Spelling take_apart(std::string_view key) {
    constexpr std::string_view blanks = " \t";
    Spelling spelling;
    key = base::trimmed(key);
    const std::size_t digits = std::min(key.find_first_not_of(base::digits), key.size());
    const bool has_number = digits > 0 && (digits == key.size() || blanks.find(key[digits]) != blanks.npos);
    if (!has_number) {
        spelling.name = key;
        return spelling;
    }
    spelling.number_text = key.substr(0, digits);
    spelling.name = base::trimmed(key.substr(digits));
    const auto number = base::parse_integer(spelling.number_text);
    const bool has_leading_zero = digits > 1 && key.front() == '0';
    if (number && *number <= std::numeric_limits<std::uint16_t>::max() && !has_leading_zero) {
        spelling.number = static_cast<std::uint16_t>(*number);
    }
    return spelling;
}

const Row* resolve_silently(const Catalogue& catalogue, Device device, std::string_view key) {
    return row_of(catalogue, device, take_apart(key));
}

std::string mismatch_message(const Catalogue& catalogue, Device device, std::uint16_t number,
                             std::string_view name) {
    const Row* by_number = catalogue.find(device, number);
    const Row* by_name = catalogue.find(device, name);
    std::string number_says = fmt::format("the {} has no parameter {}", parameter::to_text(device), number);
    if (by_number != nullptr) {
        number_says = fmt::format("{} is {}", by_number->number,
                                  by_number->name.empty() ? "another parameter" : by_number->name);
    }
    const std::string name_says = by_name == nullptr
                                      ? fmt::format("no parameter is named {}", toml::quoted(name))
                                      : fmt::format("{} is {}", by_name->name, by_name->number);
    return fmt::format("{}, but {}", number_says, name_says);
}

const Row* KeyResolver::resolve(const toml::Entry& entry) {
    const Spelling spelling = take_apart(entry.key);
    if (const Row* row = row_of(context_.catalogue, device_, spelling)) {
        return row;
    }
    const bool has_both = spelling.number && !spelling.name.empty();
    const bool knows_one = has_both && (context_.catalogue.find(device_, *spelling.number) != nullptr ||
                                        context_.catalogue.find(device_, spelling.name) != nullptr);
    if (knows_one) {
        report_mismatch(entry, spelling);
    } else {
        report_unknown(entry, spelling);
    }
    return nullptr;
}

void KeyResolver::report_mismatch(const toml::Entry& entry, const Spelling& spelling) {
    const Row* by_number = context_.catalogue.find(device_, *spelling.number);
    const Row* by_name = context_.catalogue.find(device_, spelling.name);
    std::string help;
    if (by_name == nullptr) {
        help = fmt::format("write \"{}\"", parameter::label(*by_number));
    } else if (by_number == nullptr) {
        help = fmt::format("write \"{}\"", parameter::label(*by_name));
    } else {
        help = fmt::format(R"(write "{}" or "{}")", parameter::label(*by_number), parameter::label(*by_name));
    }
    context_.report(rules::parameter_name_mismatch, entry.key_range,
                    mismatch_message(context_.catalogue, device_, *spelling.number, spelling.name),
                    std::move(help));
    for (const Row* row : {by_number, by_name}) {
        if (row != nullptr) {
            set_of(context_, device_).reject(row->number);
        }
    }
}

void KeyResolver::report_unknown(const toml::Entry& entry, const Spelling& spelling) {
    const Row* foreign = in_other_device(spelling);
    if (foreign != nullptr && foreign->settable() && tables_of(context_, foreign->device).empty() &&
        !context_.is_first_misplaced(foreign->device)) {
        return;
    }
    context_.report(
        rules::parameter_unknown, entry.key_range,
        fmt::format("the {} has no parameter {}", parameter::to_text(device_), toml::quoted(entry.key)),
        help_for_unknown(entry, spelling, foreign));
}

const Row* KeyResolver::in_other_device(const Spelling& spelling) const {
    return row_of(context_.catalogue, other_device(device_), spelling);
}

void KeyResolver::enter(const toml::Node& table) {
    table_ = &table;
    written_.reset();
}

bool KeyResolver::is_written(std::uint16_t number) {
    if (!written_) {
        written_.emplace();
        for (const toml::Entry& entry : table_->entries) {
            if (const Row* row = resolve_silently(context_.catalogue, device_, entry.key)) {
                written_->insert(row->number);
            }
        }
    }
    return written_->contains(number);
}

KeyResolver::Rows KeyResolver::needed() const {
    Rows rows;
    const auto add = [&](Device device, std::uint16_t number) {
        const Row* row = device == device_ ? context_.catalogue.find(device, number) : nullptr;
        if (row != nullptr) {
            rows.push_back(row);
        }
    };
    for (const Required& required : required_parameters) {
        add(required.device, required.number);
    }
    for (const Expected& expected : communication_switches) {
        add(expected.device, expected.number);
    }
    return rows;
}

// Once the suggestions are used up, only what would be reported as missing is looked at.
std::string KeyResolver::nearest(std::string_view name, bool is_thorough) {
    std::vector<std::string_view> needed_names;
    if (!is_thorough) {
        for (const Row* row : needed()) {
            needed_names.push_back(row->name);
        }
    } else if (names_.empty()) {
        names_ = context_.catalogue.names(device_);
    }
    return base::nearest_name(name, is_thorough ? names_ : needed_names);
}

// The parameters whose number is one character away from the key and that the table does not set.
KeyResolver::Rows KeyResolver::neighbours(const toml::Entry& entry, bool is_thorough) {
    Rows found;
    for (const std::string& text : texts_of(entry)) {
        for (const Row* row : is_thorough ? context_.catalogue.rows(device_) : needed()) {
            if (row->settable() && base::edit_distance(text, fmt::format("{}", row->number)) == 1 &&
                !is_written(row->number)) {
                found.push_back(row);
            }
        }
    }
    return found;
}

const Row* KeyResolver::likeliest(const Rows& rows) const {
    const Rows wanted = needed();
    Rows both;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(both), [&](const Row* row) {
        return std::find(wanted.begin(), wanted.end(), row) != wanted.end();
    });
    if (both.size() == 1) {
        return both.front();
    }
    return rows.size() == 1 ? rows.front() : nullptr;
}

void KeyResolver::reject_needed_neighbours(const toml::Entry& entry) {
    for (const Row* row : neighbours(entry, false)) {
        set_of(context_, device_).reject(row->number);
    }
}

std::string KeyResolver::help_for_unknown(const toml::Entry& entry, const Spelling& spelling,
                                          const Row* foreign) {
    const bool is_thorough = suggestions_left_ > 0;
    suggestions_left_ -= is_thorough ? 1 : 0;
    if (foreign == nullptr && !spelling.name.empty()) {
        if (const std::string near = nearest(spelling.name, is_thorough); !near.empty()) {
            reject_array(set_of(context_, device_), *context_.catalogue.find(device_, near));
            return is_thorough ? fmt::format("did you mean `{}`?", near) : "";
        }
    }
    const Rows meant = neighbours(entry, is_thorough);
    for (const Row* row : meant) {
        set_of(context_, device_).reject(row->number);
    }
    if (foreign != nullptr) {
        set_of(context_, foreign->device).reject(foreign->number);
        const std::string_view device = parameter::to_text(foreign->device);
        return foreign->settable()
                   ? fmt::format("{} belongs to the {}: write it in [{}.parameters]",
                                 parameter::label(*foreign), device, device)
                   : fmt::format("{} is a measurement of the {}", parameter::label(*foreign), device);
    }
    if (const Row* row = is_thorough ? likeliest(meant) : nullptr) {
        return fmt::format("did you mean {}?", parameter::label(*row));
    }
    return is_thorough
               ? "what the shipped catalogue does not know can be added by a file: catalogue = [\"...\"]"
               : "";
}

}  // namespace cgw::input
