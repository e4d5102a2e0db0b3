#include "diagnostic/rules.hpp"

namespace cgw::diagnostic {

std::string_view to_text(Level level) {
    switch (level) {
        case Level::error:
            return "error";
        case Level::warning:
            return "warning";
        case Level::note:
            return "note";
    }
    return "";
}

namespace {

using namespace rules;

const Rule* const table[] = {
    &file_unreadable,
    &file_too_large,
    &file_not_utf8,
    &toml_syntax,
    &toml_number_range,
    &toml_nesting,
    &format_missing,
    &format_unsupported,
    &catalogue_unreadable,
    &key_unknown,
    &key_type,
    &key_missing,
    &key_value,
    &parameter_unknown,
    &parameter_name_mismatch,
    &parameter_not_settable,
    &parameter_duplicate,
    &parameter_missing,
    &value_type,
    &value_range,
    &list_too_long,
    &declaration_invalid,
    &declaration_contradiction,
    &network_node_duplicate,
    &hzm_node_mismatch,
    &hzm_bit_rate_mismatch,
    &node_id_duplicate,
    &node_id_listed,
    &cob_id_reserved,
    &cob_id_duplicate,
    &cob_id_foreign,
    &heartbeat_partner_missing,
    &time_too_long,
    &switch_bit_range,
    &sensor_channel_range,
    &engine_stop_over_canopen,
    &tpdo_parameter_unknown,
    &tpdo_parameter_bit,
    &communication_off,
    &table_row,
    &table_value_ambiguous,
    &table_ellipsis,
    &table_unit,
    &table_of_other_device,
    &table_empty,
    &table_misprint,
    &table_measurement,
    &clone_identifier,
};

}  // namespace

std::span<const Rule* const> all_rules() {
    return table;
}

}  // namespace cgw::diagnostic
