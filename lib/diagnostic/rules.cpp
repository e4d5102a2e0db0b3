#include "diagnostic/rules.hpp"

#include "diagnostic/rules/dbc.hpp"
#include "diagnostic/rules/eds.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/firmware.hpp"
#include "diagnostic/rules/frames.hpp"
#include "diagnostic/rules/keys.hpp"
#include "diagnostic/rules/network.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/scenarios.hpp"
#include "diagnostic/rules/tables.hpp"
#include "diagnostic/rules/warnings.hpp"
#include "diagnostic/rules/xdd.hpp"

namespace cgw::diagnostic {

namespace {

using namespace rules;

#define CGW_ADDRESS(name) &name,

// clang-format off
const Rule* const table[] = {
    CGW_FILES_RULES(CGW_ADDRESS)
    CGW_KEYS_RULES(CGW_ADDRESS)
    CGW_PLANT_RULES(CGW_ADDRESS)
    CGW_WARNINGS_RULES(CGW_ADDRESS)
    CGW_NOTES_RULES(CGW_ADDRESS)
    CGW_TABLES_RULES(CGW_ADDRESS)
    CGW_SCENARIOS_RULES(CGW_ADDRESS)
    CGW_FIRMWARE_RULES(CGW_ADDRESS)
    CGW_EDS_RULES(CGW_ADDRESS)
    CGW_EDS_CHECK_RULES(CGW_ADDRESS)
    CGW_XDD_RULES(CGW_ADDRESS)
    CGW_DBC_RULES(CGW_ADDRESS)
    CGW_NETWORK_RULES(CGW_ADDRESS)
    CGW_FRAMES_RULES(CGW_ADDRESS)
};
// clang-format on

#undef CGW_ADDRESS

}  // namespace

std::span<const Rule* const> all_rules() {
    return table;
}

}  // namespace cgw::diagnostic
