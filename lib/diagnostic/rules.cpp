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

std::string_view language_of(Example example) {
    switch (example) {
        case Example::none:
            return "";
        case Example::parameter_file:
        case Example::copied_file:
        case Example::scenario:
            return "toml";
        case Example::table:
        case Example::table_rows:
        case Example::firmware:
            return "text";
        case Example::data_sheet:
            return "ini";
        case Example::device_description:
            return "xml";
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
    &monitoring_early,
    &monitoring_short,
    &rpdo_unmonitored,
    &rpdo_inactive_monitored,
    &decimal_for_hexadecimal,
    &cob_id_restricted,
    &tpdo_empty,
    &tpdo_unsent,
    &switch_without_bit,
    &sensor_without_channel,
    &switch_bit_shared,
    &sensor_channel_shared,
    &start_up_delay_mismatch,
    &partner_unmonitored,
    &heartbeat_off,
    &manual_misprint,
    &time_quantised,
    &tpdo_words_moved,
    &cob_id_unlisted_owner,
    &cob_id_default_rpdo,
    &hzm_bit_rate_unverified,
    &table_row,
    &table_value_ambiguous,
    &table_ellipsis,
    &table_unit,
    &table_of_other_device,
    &table_empty,
    &table_row_skipped,
    &clone_identifier,
    &table_row_absent,
    &step_action,
    &step_time,
    &step_subject,
    &step_value,
    &step_answer,
    &firmware_kind,
    &record_line,
    &record_checksum,
    &record_address,
    &record_end,
    &elf_structure,
    &firmware_section,
    &firmware_address,
    &image_alignment,
    &image_room,
    &image_occupied,
    &image_refused,
    &eds_text,
    &eds_line,
    &eds_header,
    &eds_section_twice,
    &eds_key_twice,
    &eds_value,
    &eds_number_range,
    &eds_number_form,
    &eds_formula,
    &eds_access_type,
    &eds_data_type,
    &eds_object_type,
    &eds_key_absent,
    &eds_section_alone,
    &eds_entry_alone,
    &eds_spelling,
    &eds_too_much,
    &xdd_text,
    &xdd_root,
    &xdd_absent,
    &xdd_value,
    &xdd_number_range,
    &xdd_number_form,
    &xdd_data_type,
    &xdd_object_type,
    &xdd_access,
    &xdd_no_access,
    &xdd_reference,
    &xdd_contradiction,
    &xdd_twice,
};

}  // namespace

std::span<const Rule* const> all_rules() {
    return table;
}

}  // namespace cgw::diagnostic
