#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/edit_distance.hpp"
#include "catalogue/catalogue.hpp"
#include "catalogue/cells.hpp"
#include "catalogue/kinds.hpp"
#include "catalogue/merge.hpp"
#include "diagnostic/rules/keys.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using toml::Node;
namespace rules = diagnostic::rules;

// The profile each device's catalogue may name; one per device today.
constexpr std::string_view profile_of(Device device) {
    return device == Device::governor ? "digital-governor" : "canopen-gateway";
}

bool has_type(const Node& value, toml::Kind type) {
    return value.kind == type || (type == toml::Kind::real && value.kind == toml::Kind::integer);
}

void report_unknown(const toml::Entry& entry, std::span<const std::string_view> known,
                    const Reporter& report) {
    const std::string near = base::nearest_name(entry.key, known);
    report(rules::key_unknown, entry.key_range, fmt::format("unknown key {}", toml::quoted(entry.key)),
           near.empty() ? "" : fmt::format("did you mean `{}`?", near));
}

void report_type(const toml::Entry& entry, toml::Kind type, const Reporter& report) {
    report(
        rules::key_type, entry.value.range,
        fmt::format("`{}` is {}, not {}", entry.key, toml::to_text(type), toml::to_text(entry.value.kind)));
}

// A misspelt cell counts as given and refused, so that it is not reported as missing too.
void report_unknown_cells(Draft& draft, bool declaration, const Reporter& report) {
    std::vector<std::string_view> known;
    for (const Cell& cell : all_cells()) {
        if (!declaration || cell.in_declaration) {
            known.push_back(cell.name);
        }
    }
    for (const toml::Entry& entry : draft.table.entries) {
        if (std::find(known.begin(), known.end(), entry.key) != known.end()) {
            continue;
        }
        report_unknown(entry, known, report);
        const std::string near = base::nearest_name(entry.key, known);
        if (const auto meant = std::find(known.begin(), known.end(), near); meant != known.end()) {
            draft.refused.push_back(*meant);
        }
    }
}

void read_cells(Draft& draft, bool declaration, const Reporter& report) {
    report_unknown_cells(draft, declaration, report);
    for (const Cell& cell : all_cells()) {
        const toml::Entry* entry = draft.table.find(cell.name);
        if (entry == nullptr || (declaration && !cell.in_declaration)) {
            continue;
        }
        const std::size_t findings_before = report.findings().all().size();
        if (has_type(entry->value, cell.type)) {
            cell.read(entry->value, draft, report);
        } else {
            report_type(*entry, cell.type, report);
        }
        if (report.findings().all().size() != findings_before) {
            draft.refused.push_back(cell.name);
        }
    }
}

// What declarations must not do though a catalogue may. False after a finding.
bool check_declared_kind(const Draft& draft, const Reporter& report) {
    const toml::Entry* entry = draft.table.find("kind");
    if (entry == nullptr || !draft.kind_known) {
        return true;
    }
    const Kind* kind = find_kind(entry->value.text, draft.row.device, draft.row.number);
    if (kind->first_declared == 0) {
        report(rules::key_value, entry->value.range,
               fmt::format("a declaration's kind is measurement, switch or sensor, not {}", kind->name));
        return false;
    }
    if (draft.row.number < kind->first_declared && draft.row.number != 0) {
        report(rules::declaration_invalid, draft.where("number"),
               fmt::format("{} is the engine stop, which is known and cannot be declared", draft.row.number));
        return false;
    }
    return true;
}

// Reads one row and merges it; nullptr when its number is not usable or there was a finding.
const parameter::Row* read_row(const Node& table, Device device, Program program, bool declaration,
                               Catalogue& catalogue, const Reporter& report) {
    const std::size_t findings_before = report.findings().all().size();
    Draft draft(table);
    draft.row.device = device;
    draft.row.program = program;
    read_cells(draft, declaration, report);
    if (!draft.says("number") && !draft.refuses("number")) {
        report(rules::key_missing, table.range, "`number` is missing");
    }
    const bool may_declare = !declaration || check_declared_kind(draft, report);
    if (draft.row.number == 0 ||
        (!may_declare && catalogue.find(device, program, draft.row.number) != nullptr)) {
        return nullptr;
    }
    const parameter::Row* row = merge(draft, declaration, catalogue, report);
    return report.findings().all().size() == findings_before ? row : nullptr;
}

std::optional<Device> read_device(const Node& root, const Reporter& report) {
    const toml::Entry* entry = root.find("device");
    if (entry == nullptr) {
        report(rules::key_missing, {}, "`device` is missing",
               R"(say `device = "governor"` or `device = "gateway"`)");
        return std::nullopt;
    }
    if (entry->value.kind != toml::Kind::string) {
        report_type(*entry, toml::Kind::string, report);
        return std::nullopt;
    }
    for (const Device device : {Device::governor, Device::gateway}) {
        if (entry->value.text == parameter::to_text(device)) {
            return device;
        }
    }
    report(rules::key_value, entry->value.range,
           fmt::format(R"(device {} is neither "governor" nor "gateway")", toml::quoted(entry->value.text)));
    return std::nullopt;
}

void check_profile(const Node& root, Device device, const Reporter& report) {
    const toml::Entry* entry = root.find("profile");
    if (entry == nullptr) {
        return;
    }
    if (entry->value.kind != toml::Kind::string) {
        report_type(*entry, toml::Kind::string, report);
    } else if (entry->value.text != profile_of(device)) {
        report(rules::key_value, entry->value.range,
               fmt::format("unknown profile {} of a {}", toml::quoted(entry->value.text),
                           parameter::to_text(device)),
               fmt::format("the profile is \"{}\"", profile_of(device)));
    }
}

// Most files are about the application and do not say so.
Program read_program(const Node& root, const Reporter& report) {
    const toml::Entry* entry = root.find("program");
    if (entry == nullptr) {
        return Program::application;
    }
    if (entry->value.kind != toml::Kind::string) {
        report_type(*entry, toml::Kind::string, report);
    } else if (entry->value.text == parameter::to_text(Program::bootloader)) {
        return Program::bootloader;
    } else if (entry->value.text != parameter::to_text(Program::application)) {
        report(rules::key_value, entry->value.range,
               fmt::format(R"(program {} is neither "application" nor "bootloader")",
                           toml::quoted(entry->value.text)));
    }
    return Program::application;
}

// A number stands once in a file, arrays and ranges included.
class NumbersSeen {
  public:
    explicit NumbersSeen(const Reporter& report) : report_(report) {}

    // False after a finding.
    bool add(const Node& table) {
        const toml::Entry* number = table.find("number");
        if (number == nullptr || number->value.kind != toml::Kind::integer) {
            return true;  // reported elsewhere
        }
        const std::int64_t first = number->value.integer;
        if (first < 1 || first > highest_number) {
            return true;
        }
        const std::int64_t last = std::min(last_of(table, first), highest_number);
        for (std::int64_t n = first; n <= last; ++n) {
            const auto [place, fresh] = seen_.try_emplace(n, number->value.range);
            if (!fresh) {
                report_.findings().report({&rules::declaration_invalid,
                                           fmt::format("number {} stands here twice", n),
                                           report_.at(number->value.range),
                                           {{report_.at(place->second), "the first time"}}});
                return false;
            }
        }
        return true;
    }

  private:
    static std::int64_t last_of(const Node& table, std::int64_t first) {
        if (const toml::Entry* count = table.find("count");
            count != nullptr && count->value.integer <= highest_number) {
            return first + std::max<std::int64_t>(count->value.integer, 1) - 1;
        }
        const toml::Entry* last = table.find("last");
        return last != nullptr ? std::max(last->value.integer, first) : first;
    }

    const Reporter& report_;
    std::map<std::int64_t, diagnostic::Range> seen_;
};

void read_rows(const toml::Entry& rows, Device device, Program program, Catalogue& catalogue,
               const Reporter& report) {
    NumbersSeen seen(report);
    for (const Node& table : rows.value.elements) {
        if (table.kind != toml::Kind::table) {
            report(rules::key_type, table.range,
                   fmt::format("a row is a table, not {}", toml::to_text(table.kind)));
        } else if (seen.add(table)) {
            read_row(table, device, program, false, catalogue, report);
        }
    }
    for (const Node& table : rows.value.elements) {  // any row may be the reference of an earlier one
        check_references(table, device, catalogue, report);
    }
}

}  // namespace

bool is_catalogue(const Node& root) {
    const auto has = [&root](std::string_view key) { return root.find(key) != nullptr; };
    return (has("row") || has("device")) && !has("format") && !has("governor") && !has("gateway");
}

bool read_catalogue(std::string_view text, const std::string& path, Catalogue& catalogue,
                    diagnostic::Findings& findings) {
    const std::optional<Node> root = toml::parse(text, path, findings);
    return root && read_catalogue(*root, path, catalogue, findings);
}

bool read_catalogue(const Node& root, const std::string& path, Catalogue& catalogue,
                    diagnostic::Findings& findings) {
    const std::size_t findings_before = findings.all().size();
    const Reporter report(path, findings);
    constexpr std::string_view known[] = {"device", "profile", "program", "row"};
    for (const toml::Entry& entry : root.entries) {
        if (std::find(std::begin(known), std::end(known), entry.key) == std::end(known)) {
            report_unknown(entry, known, report);
        }
    }
    const std::optional<Device> device = read_device(root, report);
    if (device) {
        check_profile(root, *device, report);
    }
    const Program program = read_program(root, report);
    const toml::Entry* rows = root.find("row");
    if (rows != nullptr && rows->value.kind != toml::Kind::array) {
        report_type(*rows, toml::Kind::array, report);
    } else if (rows != nullptr && device) {
        read_rows(*rows, *device, program, catalogue, report);
    }
    return findings.all().size() == findings_before;
}

const parameter::Row* read_declaration(const Node& table, const std::string& path, Catalogue& catalogue,
                                       diagnostic::Findings& findings) {
    const Reporter report(path, findings);
    const std::size_t findings_before = findings.all().size();
    const parameter::Row* row =
        read_row(table, Device::governor, Program::application, true, catalogue, report);
    check_references(table, Device::governor, catalogue, report);
    return findings.all().size() == findings_before ? row : nullptr;
}

}  // namespace cgw::catalogue
