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
        case Example::database:
            return "text";
        case Example::data_sheet:
        case Example::data_sheet_lines:
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
    &image_model,
    &image_elsewhere,
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
    &eds_line_length,
    &eds_character,
    &eds_byte_order_mark,
    &eds_comment_mark,
    &eds_line_ends,
    &eds_blanks,
    &eds_header_tail,
    &eds_semicolon,
    &eds_section_case,
    &eds_sub_zero,
    &eds_section_unknown,
    &eds_key_case,
    &eds_key_misspelt,
    &eds_key_unknown,
    &eds_section_absent,
    &eds_keys_absent,
    &eds_commissioning_twice,
    &eds_list_count,
    &eds_entry_count,
    &eds_comment_count,
    &eds_list_numbers,
    &eds_listed_twice,
    &eds_listed_absent,
    &eds_unlisted,
    &eds_wrong_list,
    &eds_mandatory_object,
    &eds_key_use,
    &eds_name_absent,
    &eds_names_equal,
    &eds_object_type_absent,
    &eds_sub_number,
    &eds_sub_number_absent,
    &eds_sub_0_absent,
    &eds_sub_0_type,
    &eds_sub_0_value,
    &eds_default_absent,
    &eds_array_types,
    &eds_standard_code,
    &eds_standard_type,
    &eds_access_case,
    &eds_octal,
    &eds_leading_zero,
    &eds_limits,
    &eds_value_limits,
    &eds_signed_value,
    &eds_mappable_rw,
    &eds_mappable_type,
    &eds_file_name,
    &eds_version,
    &eds_date,
    &eds_time,
    &eds_identity,
    &eds_bit_rates,
    &eds_granularity,
    &eds_pdo_count,
    &eds_lss,
    &eds_node_id,
    &eds_node_bit_rate,
    &eds_serial_number,
    &eds_configured_value,
    &eds_mapped_absent,
    &eds_mapped_length,
    &eds_mapped_refused,
    &eds_mapped_direction,
    &eds_dummy,
    &eds_mapped_bits,
    &eds_mapped_count,
    &eds_pdo_pair,
    &eds_transmission_type,
    &eds_cob_id_restricted,
    &eds_cob_id_twice,
    &eds_cob_id_form,
    &eds_node_id_absent,
    &eds_sdo_server,
    &eds_heartbeat_consumer,
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
    &dbc_text,
    &dbc_statement,
    &dbc_twice,
};

}  // namespace

std::span<const Rule* const> all_rules() {
    return table;
}

}  // namespace cgw::diagnostic
