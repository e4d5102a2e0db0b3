#include <fmt/format.h>

#include <optional>

#include "catalogue/catalogue.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "emit/emitter.hpp"
#include "explain/lists.hpp"

namespace cgw::cli {
namespace {

using explain::Table;
using parameter::Catalogue;
using parameter::Device;

// What one list is made for.
struct Request {
    const Catalogue& catalogue;
    std::optional<Device> device;
    bool for_people;
};

// People read that there is no file; programs an empty cell.
Table emitter_list(bool for_people) {
    Table table{"emitters", false, {}, {}};
    table.columns = {
        {"name", "name"}, {"format", "format"}, {"file", "file of build"}, {"summary", "what it is"}};
    for (const emit::Emitter& emitter : emit::all_emitters()) {
        for (const emit::Format& format : emitter.formats) {
            const std::string file = emit::file_name(format, {});
            table.rows.push_back({std::string(emitter.name), std::string(format.name),
                                  file.empty() && for_people ? "none" : file, std::string(emitter.summary)});
        }
    }
    return table;
}

struct ListRow {
    std::string_view name;
    std::string_view summary;
    bool by_device;
    Table (*make)(const Request& request);
};

constexpr ListRow lists[] = {
    {"parameters", "parameters and measurements of the devices", true,
     [](const Request& r) { return explain::parameter_list(r.catalogue, r.device, r.for_people); }},
    {"checks", "the rules behind the findings", false, [](const Request&) { return explain::check_list(); }},
    {"emitters", "artefacts that build and emit write", false,
     [](const Request& r) { return emitter_list(r.for_people); }},
    {"codes", "error numbers of the devices and SDO abort codes", true,
     [](const Request& r) { return explain::code_list(r.catalogue, r.device); }},
    {"assumptions", "points that the documents leave open, to measure on a device", false,
     [](const Request&) { return explain::assumption_list(); }},
};

std::vector<Word> list_words() {
    std::vector<Word> words;
    for (const ListRow& list : lists) {
        words.push_back({list.name, list.summary});
    }
    return words;
}

std::vector<Word> device_words() {
    return {{to_text(Device::governor), "the digital governor"},
            {to_text(Device::gateway), "the CANopen gateway"}};
}

std::vector<Word> table_format_words() {
    std::vector<Word> words;
    for (const explain::TableFormat& format : explain::table_formats()) {
        words.push_back({format.name, format.summary});
    }
    return words;
}

constexpr Option list_options[] = {
    {.names = "WHAT", .summary = "what to list", .required = true, .words = list_words},
    {.names = "--device",
     .value = "DEVICE",
     .summary = "parameters and codes of this device only",
     .words = device_words},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the list",
     .default_value = "table",
     .words = table_format_words},
};

std::optional<Device> device_of(const Arguments& arguments) {
    if (!arguments.given("--device")) {
        return std::nullopt;
    }
    return arguments.value("--device") == to_text(Device::governor) ? Device::governor : Device::gateway;
}

int list(const Arguments& arguments) {
    const std::string what = arguments.value("WHAT");
    const explain::TableFormat& format = *explain::find_table_format(arguments.value("--format"));
    for (const ListRow& row : lists) {
        if (row.name != what) {
            continue;
        }
        if (arguments.given("--device") && !row.by_device) {
            throw UsageError(fmt::format("--device: {} do not belong to a device", what));
        }
        const Catalogue catalogue(catalogue::shipped_rows());
        const Table table = row.make({catalogue, device_of(arguments), format.for_people});
        return print(format.render(table)) ? exit_fine : exit_environment;
    }
    return exit_internal;
}

}  // namespace

const Verb list_verb = {"list", "list what cgw knows: parameters, checks, emitters, codes, assumptions",
                        list_options, list,
                        "In table and md the elements of an array share a line; in json and csv every\n"
                        "number has a line of its own. --device gateway includes the gateway's\n"
                        "bootloader: a group of its own for people, `program` in json and csv.\n"};

}  // namespace cgw::cli
