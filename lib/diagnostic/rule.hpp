// What a finding is about: one row each in rules/, where every group has a header with the names of its
// rules. Who reports one includes the header of its group, so that a new rule changes nothing for the others.
// A code is never reused; a name never changes.
#pragma once

#include <string_view>

namespace cgw::diagnostic {

enum class Level { error, warning, note };

std::string_view to_text(Level level);  // "error", "warning", "note"

// What the two examples of a rule are.
enum class Example {
    none,              // nothing printed can break the rule; both are empty
    parameter_file,    // lines of a parameter file, to be read on top of a valid one
    copied_file,       // the same, of a file that is then copied
    table,             // a whole printed table of the governor
    table_rows,        // rows of one, on top of a table that prints every row of concern
    scenario,          // steps of a scenario of samples/genset.toml that lasts 10 s
    firmware,          // an Intel HEX file into which an image is put at 0x08010000
    network,           // as parameter_file, and its bus is judged as by cgw network
    data_sheet,        // sections of an EDS or DCF, as they are read
    data_sheet_lines,  // lines of one, on top of an EDS that keeps all rules; behind `; ` one that goes away
    device_description,  // parameters and objects of an XDD
    database,            // a CAN database
    frame_arguments,     // what cgw encode or decode is asked for samples/genset.toml, one argument a line
    frame_log,           // a log of candump -L, audited against samples/genset.toml
};

// The language of such an example, as Markdown names it behind a fence: "toml", "text".
std::string_view language_of(Example example);

struct Rule {
    std::string_view code;  // E0203
    std::string_view name;  // node-id-duplicate
    Level level;
    std::string_view summary;    // what the rule demands, one line
    std::string_view reference;  // manual section or ruling: "GWM 7.3, D33"
    std::string_view why;        // what it means for the plant, one to three sentences

    // The rule broken and kept. Lines of a parameter file stand below their table headers. A line read on top
    // of a file or table replaces the one with its key or number, one behind `# ` takes that one away
    // (`# 427 = 5`, `# 4406;`), other lines are added.
    Example example = Example::parameter_file;
    std::string_view bad;
    std::string_view good;
};

}  // namespace cgw::diagnostic

// How the headers in rules/ declare each name of their lists.
#define CGW_DECLARE_RULE(name) extern const Rule name;
