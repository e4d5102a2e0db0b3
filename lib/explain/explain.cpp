#include "explain/explain.hpp"

#include <array>
#include <cctype>

#include <fmt/format.h>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules.hpp"
#include "explain/entries.hpp"
#include "explain/wording.hpp"
#include "facts/gateway.hpp"

namespace cgw::explain {

namespace {

using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using parameter::Row;

constexpr std::array forms{
    QuestionForm{"416", "a parameter or measurement, in both devices"},
    QuestionForm{"CanOpenMyNodeID", "the same by name"},
    QuestionForm{"12412", "an error: cause, action, how it clears"},
    QuestionForm{"2005h=0x0102", "a value: which bits are set, and why"},
    QuestionForm{"835=-5", "a value of a parameter: what it leads to, whether it fits"},
    QuestionForm{"2003h:1", "an object of the gateway"},
    QuestionForm{"0x06010002", "an SDO abort code"},
    QuestionForm{"E0203", "a finding, also by name: node-id-duplicate"},
};

constexpr Device devices[] = {Device::governor, Device::gateway};
constexpr Program programs[] = {Program::application, Program::bootloader};

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string shown;
    for (const char c : text.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        shown += byte < 0x20 || byte == 0x7F ? '?' : c;
    }
    return fmt::format("`{}{}`", shown, text.size() > longest ? "…" : "");
}

Answer refused(std::string complaint, std::string help = {}) {
    return {{}, {}, std::move(complaint), std::move(help)};
}

Answer explained(std::vector<Entry> entries) {
    return {{}, std::move(entries), {}, {}};
}

// The row of that number or name in each device and program.
template <typename NumberOrName>
std::vector<const Row*> rows_of(NumberOrName wanted, const Catalogue& catalogue) {
    std::vector<const Row*> rows;
    for (const Device device : devices) {
        for (const Program program : programs) {
            if (const Row* row = catalogue.find(device, program, wanted)) {
                rows.push_back(row);
            }
        }
    }
    return rows;
}

// --- numbers ---

Entry misprint_entry(const Row& row, std::uint16_t number, const Catalogue& catalogue) {
    Entry entry = parameter_entry(row, catalogue);
    entry.fields.insert(entry.fields.begin(),
                        {"note", {fmt::format("the manual prints {} for it in places", number)}});
    return entry;
}

// D21: an error of the governor that our documents do not name.
void describe_nameless_error(Entry& entry, std::uint16_t number) {
    const unsigned bit = number - unsigned{facts::first_error_number};
    entry.add("meaning", "no document names it, see the governor's own manual");
    entry.add("seen in", fmt::format("bit {} of {}", bit % facts::word_bits,
                                     object_text(facts::object::errors, bit / facts::word_bits + 1)));
    entry.add("source", "GWM 9.1, D21");
}

Entry nameless_error(std::uint16_t number) {
    Entry entry{"error", fmt::format("error {}", number), {}};
    describe_nameless_error(entry, number);
    return entry;
}

Entry nameless_error_value(std::uint16_t number, std::uint32_t value) {
    Entry entry{"value", fmt::format("error {} = {}", number, value), {}};
    if (value <= 1) {
        entry.add("this value", value == 0 ? "the error is not there" : "the error is there");
    }
    entry.add("range", fmt::format("{} 0..1", value <= 1 ? "within" : "outside"));
    describe_nameless_error(entry, number);
    return entry;
}

Answer explain_number(std::uint16_t number, const Catalogue& catalogue) {
    std::vector<Entry> entries = row_entries(rows_of(number, catalogue), catalogue);
    for (const Device device : devices) {
        if (const Row* row = catalogue.find_misprint(device, number, "")) {
            entries.push_back(misprint_entry(*row, number, catalogue));
        }
    }
    if (entries.empty() && facts::is_error_number(number)) {
        entries.push_back(nameless_error(number));
    }
    if (!entries.empty()) {
        return explained(std::move(entries));
    }
    return refused(fmt::format("no parameter, measurement or error with the number {} is known", number),
                   "governor types differ: your governor's own manual may have it");
}

// --- names ---

// "416 HzmCanBaudrate": the name tells the device.
std::vector<const Row*> rows_numbered_and_named(std::string_view text, const Catalogue& catalogue) {
    const std::size_t blank = text.find(' ');
    const auto number =
        blank != std::string_view::npos ? parse_parameter_number(text.substr(0, blank)) : std::nullopt;
    std::vector<const Row*> rows;
    if (number) {
        const std::string_view name = base::trimmed(text.substr(blank));
        for (const Row* row : rows_of(name, catalogue)) {
            if (row->number == *number) {
                rows.push_back(row);
            }
        }
        for (const Device device : devices) {
            const Row* row = catalogue.find_misprint(device, *number, name);
            if (row != nullptr) {
                rows.push_back(row);
            }
        }
    }
    return rows;
}

std::vector<const Row*> rows_meant(std::string_view text, const Catalogue& catalogue) {
    if (const auto number = parse_parameter_number(text)) {
        std::vector<const Row*> rows = rows_of(*number, catalogue);
        for (const Device device : devices) {
            const Row* const meant = rows.empty() ? catalogue.find_misprint(device, *number, "") : nullptr;
            if (meant != nullptr) {
                rows.push_back(meant);  // 409=250 is 416=250 (D2)
            }
        }
        return rows;
    }
    std::vector<const Row*> rows = rows_of(text, catalogue);
    return rows.empty() ? rows_numbered_and_named(text, catalogue) : rows;
}

const diagnostic::Rule* find_rule(std::string_view text) {
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        if (base::equal_ignoring_case(text, rule->code) || base::equal_ignoring_case(text, rule->name)) {
            return rule;
        }
    }
    return nullptr;
}

constexpr std::size_t shortest_beginning = 4;  // of a name, that is taken for it

std::string did_you_mean(std::string_view text, const Catalogue& catalogue) {
    std::vector<std::string_view> names;
    for (const Device device : devices) {
        for (const Program program : programs) {
            for (const Row* row : catalogue.rows(device, program)) {
                names.push_back(row->name);
            }
        }
    }
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        names.push_back(rule->name);
        names.push_back(rule->code);
    }
    for (const catalogue::ErrorDescription& error : catalogue::shipped_errors()) {
        names.push_back(error.key);
    }
    std::erase(names, std::string_view{});
    std::string near(base::nearest_name(text, names));
    if (near.empty() && text.size() >= shortest_beginning) {
        const auto begun = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
            return base::equal_ignoring_case(name.substr(0, text.size()), text);
        });
        near = begun == names.end() ? std::string() : std::string(*begun);
    }
    return near.empty() ? "" : fmt::format("did you mean `{}`?", near);
}

// "400 CanCommBaud": the number is known, and has another name.
std::string known_number(std::string_view text, const Catalogue& catalogue) {
    const auto number = parse_parameter_number(text.substr(0, text.find(' ')));
    std::string known;
    for (const Row* row : number ? rows_of(*number, catalogue) : std::vector<const Row*>()) {
        known += fmt::format("{}{} of the {}", known.empty() ? "" : ", ", label(*row),
                             program_text(row->device, row->program));
    }
    return known.empty() ? "" : "there is " + known;
}

Answer explain_word(std::string_view text, const Catalogue& catalogue) {
    if (const diagnostic::Rule* rule = find_rule(text)) {
        return explained({rule_entry(*rule)});
    }
    if (const catalogue::ErrorDescription* error = catalogue::find_error(text)) {
        return explained({error_entry(*error, catalogue)});
    }
    const std::vector<const Row*> rows = rows_meant(text, catalogue);
    if (!rows.empty()) {
        return explained(row_entries(rows, catalogue));
    }
    const std::string known = known_number(text, catalogue);
    return refused(fmt::format("nothing is known about {}", quoted(text)),
                   known.empty() ? did_you_mean(text, catalogue) : known);
}

// --- values ---

Answer explain_value(std::string_view left, std::string_view right, const Catalogue& catalogue) {
    const auto value = parse_parameter_value(right);
    const auto bits = parse_value(right);
    const auto object = parse_object(left);
    if (!value || (object && !bits)) {
        return refused(fmt::format("{} is no value: write 5, 0x0102 or 102h{}", quoted(right),
                                   object ? "" : ", for a parameter also -5 or 1.5"));
    }
    if (object) {
        return object_value_answer(*object, *bits, catalogue);
    }
    const std::vector<const Row*> rows = rows_meant(left, catalogue);
    const auto number = parse_parameter_number(left);
    if (rows.empty() && number && bits && facts::is_error_number(*number)) {
        return explained({nameless_error_value(*number, *bits)});
    }
    if (rows.empty()) {
        return refused(fmt::format("nothing is known about {}", quoted(left)), did_you_mean(left, catalogue));
    }
    std::vector<Entry> entries;
    entries.reserve(rows.size());
    for (const Row* row : rows) {
        entries.push_back(parameter_value_entry(*row, *value, catalogue));
    }
    return explained(std::move(entries));
}

Answer explain_object(const ObjectName& name, const Catalogue& catalogue) {
    if (std::optional<Entry> entry = object_entry(name, catalogue)) {
        return explained({*std::move(entry)});
    }
    return refused(fmt::format("the gateway has no object {}",
                               name.sub ? object_text(name.index, *name.sub) : object_text(name.index)),
                   name.sub ? "" : "a number of four decimal digits without 0x or h is a parameter");
}

Answer explain_abort_code(std::uint32_t code) {
    const base::AbortCodeRow* row = base::find_abort_code(code);
    return row != nullptr ? explained({abort_code_entry(*row)})
                          : refused(fmt::format("0x{:08X} is no SDO abort code of CiA 301", code));
}

Answer answer_to(std::string_view text, const Catalogue& catalogue) {
    if (text.empty()) {
        return refused("an empty question");
    }
    if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
        return explain_value(base::trimmed(text.substr(0, equals)), base::trimmed(text.substr(equals + 1)),
                             catalogue);
    }
    if (const auto number = parse_parameter_number(text)) {
        return explain_number(*number, catalogue);
    }
    if (const auto code = parse_abort_code(text)) {
        return explain_abort_code(*code);
    }
    if (const auto object = parse_object(text)) {
        return explain_object(*object, catalogue);
    }
    return explain_word(text, catalogue);
}

}  // namespace

Answer explain(std::string_view question, const Catalogue& catalogue) {
    Answer answer = answer_to(base::trimmed(question), catalogue);
    answer.question = question;
    return answer;
}

std::span<const QuestionForm> question_forms() {
    return forms;
}

}  // namespace cgw::explain
