#include "catalogue/description_reader.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include <fmt/format.h>

#include "base/edit_distance.hpp"
#include "catalogue/cells.hpp"
#include "catalogue/named.hpp"
#include "catalogue/templates.hpp"
#include "catalogue/values.hpp"
#include "diagnostic/rules/keys.hpp"
#include "toml/document.hpp"

namespace cgw::catalogue {

namespace rules = diagnostic::rules;
using parameter::Device;
using parameter::Program;
using toml::Node;

// Takes the cells of one table out, keeping their texts in the Descriptions.
class TableReader {
  public:
    TableReader(const Node& table, Descriptions& kept, const Reporter& report)
        : table_(table), kept_(kept), report_(report) {}

    bool has(std::string_view cell) const { return table_.find(cell) != nullptr; }

    void check_cells(std::span<const std::string_view> known) const {
        for (const toml::Entry& entry : table_.entries) {
            if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
                const std::string near = base::nearest_name(entry.key, known);
                report_(rules::key_unknown, entry.key_range,
                        fmt::format("unknown key {}", toml::quoted(entry.key)),
                        near.empty() ? "" : fmt::format("did you mean `{}`?", near));
            }
        }
    }

    // One line; "" when it is not there, with a finding if it has to be.
    std::string_view text(std::string_view cell, bool required, std::uint32_t offset = 0) {
        const Node* value = find(cell, toml::Kind::string, required);
        if (value == nullptr) {
            return {};
        }
        if (!is_line(value->text)) {
            report_(rules::declaration_invalid, value->range, fmt::format("`{}` is empty", cell));
            return {};
        }
        return kept_.texts_.emplace_back(expand_text(value->text, offset));
    }

    std::span<const std::string_view> texts(std::string_view cell) {
        const Node* value = find(cell, toml::Kind::array, true);
        std::vector<std::string_view>& list = kept_.text_lists_.emplace_back();
        for (const Node& element : value != nullptr ? value->elements : std::vector<Node>{}) {
            if (element.kind == toml::Kind::string && is_line(element.text)) {
                list.push_back(kept_.texts_.emplace_back(element.text));
            } else {
                report_(rules::declaration_invalid, element.range, fmt::format("`{}` has texts", cell));
            }
        }
        return list;
    }

    // 0 when it is not there.
    std::uint16_t number(std::string_view cell, bool required) const {
        const Node* value = find(cell, toml::Kind::integer, required);
        return value != nullptr ? number_of(*value, cell) : std::uint16_t{0};
    }

    std::span<const std::uint16_t> numbers(std::string_view cell) {
        std::vector<std::uint16_t>& list = kept_.number_lists_.emplace_back();
        if (const Node* value = find(cell, toml::Kind::array, false)) {
            for (const Node& element : value->elements) {
                list.push_back(number_of(element, cell));
            }
        }
        return list;
    }

    std::span<const parameter::NamedBit> bits(std::string_view cell) {
        std::vector<parameter::NamedBit>& list = kept_.bit_lists_.emplace_back();
        if (const Node* value = find(cell, toml::Kind::array, false)) {
            std::deque<std::string> texts;
            for (const parameter::NamedBit& bit : named_bits(*value, texts, report_)) {
                list.push_back(
                    {bit.bit, kept_.texts_.emplace_back(bit.name), kept_.texts_.emplace_back(bit.text)});
            }
        }
        return list;
    }

    void complain(std::string_view cell, std::string message) const {
        const toml::Entry* entry = table_.find(cell);
        report_(rules::declaration_invalid, entry != nullptr ? entry->value.range : table_.range,
                std::move(message));
    }

  private:
    const Node* find(std::string_view cell, toml::Kind kind, bool required) const {
        const toml::Entry* entry = table_.find(cell);
        if (entry == nullptr) {
            if (required) {
                report_(rules::key_missing, table_.range, fmt::format("`{}` is missing", cell));
            }
            return nullptr;
        }
        if (entry->value.kind != kind) {
            report_(rules::key_type, entry->value.range,
                    fmt::format("`{}` is {}, not {}", cell, toml::to_text(kind),
                                toml::to_text(entry->value.kind)));
            return nullptr;
        }
        return &entry->value;
    }

    std::uint16_t number_of(const Node& value, std::string_view cell) const {
        constexpr std::int64_t highest = 0xFFFF;
        if (value.kind == toml::Kind::integer && value.integer >= 0 && value.integer <= highest) {
            return static_cast<std::uint16_t>(value.integer);
        }
        report_(rules::declaration_invalid, value.range, fmt::format("`{}` is no number of 16 bits", cell));
        return 0;
    }

    const Node& table_;
    Descriptions& kept_;
    const Reporter& report_;
};

namespace {

constexpr std::string_view error_cells[] = {"number", "key",      "devices", "counter", "with",   "see",
                                            "cause",  "response", "action",  "clears",  "section"};
constexpr std::string_view object_cells[] = {"index",  "last_index",    "sub",       "last_sub", "text",
                                             "source", "bit_parameter", "bit_count", "bits",     "section"};

// The tables under `key`; the file may have these other keys besides.
std::span<const Node> tables_of(const Node& root, std::string_view key, const Reporter& report) {
    const toml::Entry* entry = root.find(key);
    if (entry == nullptr || entry->value.kind != toml::Kind::array) {
        report(rules::key_missing, {}, fmt::format("`[[{}]]` is missing", key));
        return {};
    }
    return entry->value.elements;
}

Program program_of(const Node& root, const Reporter& report) {
    const toml::Entry* entry = root.find("program");
    for (const Program program : {Program::application, Program::bootloader}) {
        if (entry != nullptr && entry->value.text == to_text(program)) {
            return program;
        }
    }
    report(rules::key_value, entry != nullptr ? entry->value.range : diagnostic::Range{},
           R"(`program` is "application" or "bootloader")");
    return Program::application;
}

ErrorDescription read_error(TableReader& table, Program program) {
    ErrorDescription error;
    table.check_cells(error_cells);
    error.program = program;
    error.number = table.number("number", false);
    error.key = table.text("key", false);
    for (const std::string_view device : table.texts("devices")) {
        error.governor = error.governor || device == to_text(Device::governor);
        error.gateway = error.gateway || device == to_text(Device::gateway);
    }
    error.counter = table.number("counter", false);
    error.with = table.numbers("with");
    error.see = table.numbers("see");
    error.cause = table.texts("cause");
    error.response = table.texts("response");
    error.action = table.texts("action");
    error.clears = table.text("clears", true);
    error.section = table.text("section", true);
    if (error.number == 0 && error.key.empty()) {
        table.complain("number", "an error has a `number` or a `key`");
    }
    if (!error.governor && !error.gateway) {
        table.complain("devices", R"(`devices` are "governor" and "gateway")");
    }
    return error;
}

ObjectDescription read_object(TableReader& table, std::uint16_t first_index, std::uint16_t offset) {
    constexpr std::uint8_t bits_of_a_word = 16;
    ObjectDescription object;
    object.index = static_cast<std::uint16_t>(first_index + offset);
    object.whole = !table.has("sub");
    object.first_sub = static_cast<std::uint8_t>(table.number("sub", false));
    object.last_sub =
        table.has("last_sub") ? static_cast<std::uint8_t>(table.number("last_sub", false)) : object.first_sub;
    object.text = table.text("text", true, offset);
    object.source = table.text("source", false, offset);
    object.bit_parameter = table.number("bit_parameter", false);
    const bool has_count = table.has("bit_count");
    object.bit_count = object.bit_parameter == 0 ? std::uint8_t{0}
                       : has_count               ? static_cast<std::uint8_t>(table.number("bit_count", false))
                                                 : bits_of_a_word;
    object.bits = table.bits("bits");
    object.section = table.text("section", true);
    return object;
}

}  // namespace

bool Descriptions::read_errors(std::string_view text, const std::string& path,
                               diagnostic::Findings& findings) {
    const std::size_t findings_before = findings.all().size();
    const Reporter report(path, findings);
    const std::optional<Node> root = toml::parse(text, path, findings);
    if (!root) {
        return false;
    }
    constexpr std::string_view known[] = {"program", "error"};
    TableReader(*root, *this, report).check_cells(known);
    const Program program = program_of(*root, report);
    for (const Node& node : tables_of(*root, "error", report)) {
        TableReader table(node, *this, report);
        errors_.push_back(read_error(table, program));
    }
    return findings.all().size() == findings_before;
}

bool Descriptions::read_objects(std::string_view text, const std::string& path,
                                diagnostic::Findings& findings) {
    const std::size_t findings_before = findings.all().size();
    const Reporter report(path, findings);
    const std::optional<Node> root = toml::parse(text, path, findings);
    if (!root) {
        return false;
    }
    constexpr std::string_view known[] = {"object"};
    TableReader(*root, *this, report).check_cells(known);
    for (const Node& node : tables_of(*root, "object", report)) {
        TableReader table(node, *this, report);
        table.check_cells(object_cells);
        const std::uint16_t first = table.number("index", true);
        const std::uint16_t last = table.has("last_index") ? table.number("last_index", false) : first;
        for (std::uint16_t offset = 0; first + offset <= last; ++offset) {
            objects_.push_back(read_object(table, first, offset));
        }
    }
    return findings.all().size() == findings_before;
}

std::vector<ErrorDescription> Descriptions::errors() const {
    std::vector<ErrorDescription> sorted = errors_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const ErrorDescription& a, const ErrorDescription& b) {
        return std::tie(a.program, a.number, a.key, b.governor) <
               std::tie(b.program, b.number, b.key, a.governor);
    });
    return sorted;
}

std::vector<ObjectDescription> Descriptions::objects() const {
    std::vector<ObjectDescription> sorted = objects_;
    std::stable_sort(
        sorted.begin(), sorted.end(), [](const ObjectDescription& a, const ObjectDescription& b) {
            return std::tuple(a.index, !a.whole, a.first_sub) < std::tuple(b.index, !b.whole, b.first_sub);
        });
    return sorted;
}

}  // namespace cgw::catalogue
