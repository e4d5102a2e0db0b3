#include "diagnostic/rules.hpp"
#include "explain/lists.hpp"

namespace cgw::explain {

Table check_list() {
    Table table{"checks", false, {}, {}};
    table.columns = {
        {"code", "code"},
        {"level", "level"},
        {"name", "name"},
        {"summary", "what is demanded"},
        {"reference", "reference", in_page | in_data},
    };
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        table.rows.push_back({std::string(rule->code), std::string(diagnostic::to_text(rule->level)),
                              std::string(rule->name), std::string(rule->summary),
                              std::string(rule->reference)});
    }
    return table;
}

}  // namespace cgw::explain
