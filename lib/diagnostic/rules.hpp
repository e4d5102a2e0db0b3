// Every finding cgw can make, one row each. A code is never reused; a name never changes.
// E00 file and TOML · E01 keys, parameters, values · E02 what makes the plant fail · E03 warnings · E04
// notes · E05 tables read in and files copied · E06 scenario files · E07 firmware files · E08 EDS and DCF
// · E09 XDD and XDC · E10 CAN databases (DBC).
// The rows stand in one source file per group; what explains, lists or documents findings reads them.
#pragma once

#include <span>
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
    data_sheet,        // sections of an EDS or DCF, as they are read
    data_sheet_lines,  // lines of one, on top of an EDS that keeps all rules; behind `; ` one that goes away
    device_description,  // parameters and objects of an XDD
    database,            // a CAN database
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

namespace rules {

#define CGW_RULE(identifier) extern const Rule identifier

// E00: the file
CGW_RULE(file_unreadable);
CGW_RULE(file_too_large);
CGW_RULE(file_not_utf8);
CGW_RULE(toml_syntax);
CGW_RULE(toml_number_range);
CGW_RULE(toml_nesting);
CGW_RULE(format_missing);
CGW_RULE(format_unsupported);
CGW_RULE(catalogue_unreadable);

// E01: keys, parameters, values
CGW_RULE(key_unknown);
CGW_RULE(key_type);
CGW_RULE(key_missing);
CGW_RULE(key_value);
CGW_RULE(parameter_unknown);
CGW_RULE(parameter_name_mismatch);
CGW_RULE(parameter_not_settable);
CGW_RULE(parameter_duplicate);
CGW_RULE(parameter_missing);
CGW_RULE(value_type);
CGW_RULE(value_range);
CGW_RULE(list_too_long);
CGW_RULE(declaration_invalid);
CGW_RULE(declaration_contradiction);
CGW_RULE(network_node_duplicate);

// E02: what makes the plant fail
CGW_RULE(hzm_node_mismatch);
CGW_RULE(hzm_bit_rate_mismatch);
CGW_RULE(node_id_duplicate);
CGW_RULE(node_id_listed);
CGW_RULE(cob_id_reserved);
CGW_RULE(cob_id_duplicate);
CGW_RULE(cob_id_foreign);
CGW_RULE(heartbeat_partner_missing);
CGW_RULE(time_too_long);
CGW_RULE(switch_bit_range);
CGW_RULE(sensor_channel_range);
CGW_RULE(engine_stop_over_canopen);
CGW_RULE(tpdo_parameter_unknown);
CGW_RULE(tpdo_parameter_bit);
CGW_RULE(communication_off);

// E03: warnings, what works but hardly as it was meant
CGW_RULE(monitoring_early);
CGW_RULE(monitoring_short);
CGW_RULE(rpdo_unmonitored);
CGW_RULE(rpdo_inactive_monitored);
CGW_RULE(decimal_for_hexadecimal);
CGW_RULE(cob_id_restricted);
CGW_RULE(tpdo_empty);
CGW_RULE(tpdo_unsent);
CGW_RULE(switch_without_bit);
CGW_RULE(sensor_without_channel);
CGW_RULE(switch_bit_shared);
CGW_RULE(sensor_channel_shared);
CGW_RULE(start_up_delay_mismatch);
CGW_RULE(partner_unmonitored);
CGW_RULE(heartbeat_off);

// E04: notes, what the devices make of a setting
CGW_RULE(manual_misprint);
CGW_RULE(time_quantised);
CGW_RULE(tpdo_words_moved);
CGW_RULE(cob_id_unlisted_owner);
CGW_RULE(cob_id_default_rpdo);
CGW_RULE(hzm_bit_rate_unverified);

// E05: printed tables read in, files copied
CGW_RULE(table_row);
CGW_RULE(table_value_ambiguous);
CGW_RULE(table_ellipsis);
CGW_RULE(table_unit);
CGW_RULE(table_of_other_device);
CGW_RULE(table_empty);
CGW_RULE(table_row_skipped);
CGW_RULE(clone_identifier);
CGW_RULE(table_row_absent);

// E06: scenario files
CGW_RULE(step_action);
CGW_RULE(step_time);
CGW_RULE(step_subject);
CGW_RULE(step_value);
CGW_RULE(step_answer);

// E07: firmware files, and images in them
CGW_RULE(firmware_kind);
CGW_RULE(record_line);
CGW_RULE(record_checksum);
CGW_RULE(record_address);
CGW_RULE(record_end);
CGW_RULE(elf_structure);
CGW_RULE(firmware_section);
CGW_RULE(firmware_address);
CGW_RULE(image_alignment);
CGW_RULE(image_room);
CGW_RULE(image_occupied);
CGW_RULE(image_refused);
CGW_RULE(image_model);
CGW_RULE(image_elsewhere);

// E08: EDS and DCF, as they are read
CGW_RULE(eds_text);
CGW_RULE(eds_line);
CGW_RULE(eds_header);
CGW_RULE(eds_section_twice);
CGW_RULE(eds_key_twice);
CGW_RULE(eds_value);
CGW_RULE(eds_number_range);
CGW_RULE(eds_number_form);
CGW_RULE(eds_formula);
CGW_RULE(eds_access_type);
CGW_RULE(eds_data_type);
CGW_RULE(eds_object_type);
CGW_RULE(eds_key_absent);
CGW_RULE(eds_section_alone);
CGW_RULE(eds_entry_alone);
CGW_RULE(eds_spelling);
CGW_RULE(eds_too_much);

// E08: EDS and DCF, as they are checked
CGW_RULE(eds_line_length);
CGW_RULE(eds_character);
CGW_RULE(eds_byte_order_mark);
CGW_RULE(eds_comment_mark);
CGW_RULE(eds_line_ends);
CGW_RULE(eds_blanks);
CGW_RULE(eds_header_tail);
CGW_RULE(eds_semicolon);
CGW_RULE(eds_section_case);
CGW_RULE(eds_sub_zero);
CGW_RULE(eds_section_unknown);
CGW_RULE(eds_key_case);
CGW_RULE(eds_key_misspelt);
CGW_RULE(eds_key_unknown);
CGW_RULE(eds_section_absent);
CGW_RULE(eds_keys_absent);
CGW_RULE(eds_commissioning_twice);
CGW_RULE(eds_list_count);
CGW_RULE(eds_entry_count);
CGW_RULE(eds_comment_count);
CGW_RULE(eds_list_numbers);
CGW_RULE(eds_listed_twice);
CGW_RULE(eds_listed_absent);
CGW_RULE(eds_unlisted);
CGW_RULE(eds_wrong_list);
CGW_RULE(eds_mandatory_object);
CGW_RULE(eds_key_use);
CGW_RULE(eds_name_absent);
CGW_RULE(eds_names_equal);
CGW_RULE(eds_object_type_absent);
CGW_RULE(eds_sub_number);
CGW_RULE(eds_sub_number_absent);
CGW_RULE(eds_sub_0_absent);
CGW_RULE(eds_sub_0_type);
CGW_RULE(eds_sub_0_value);
CGW_RULE(eds_default_absent);
CGW_RULE(eds_array_types);
CGW_RULE(eds_standard_code);
CGW_RULE(eds_standard_type);
CGW_RULE(eds_access_case);
CGW_RULE(eds_octal);
CGW_RULE(eds_leading_zero);
CGW_RULE(eds_limits);
CGW_RULE(eds_value_limits);
CGW_RULE(eds_signed_value);
CGW_RULE(eds_mappable_rw);
CGW_RULE(eds_mappable_type);
CGW_RULE(eds_file_name);
CGW_RULE(eds_version);
CGW_RULE(eds_date);
CGW_RULE(eds_time);
CGW_RULE(eds_identity);
CGW_RULE(eds_bit_rates);
CGW_RULE(eds_granularity);
CGW_RULE(eds_pdo_count);
CGW_RULE(eds_lss);
CGW_RULE(eds_node_id);
CGW_RULE(eds_node_bit_rate);
CGW_RULE(eds_serial_number);
CGW_RULE(eds_configured_value);
CGW_RULE(eds_mapped_absent);
CGW_RULE(eds_mapped_length);
CGW_RULE(eds_mapped_refused);
CGW_RULE(eds_mapped_direction);
CGW_RULE(eds_dummy);
CGW_RULE(eds_mapped_bits);
CGW_RULE(eds_mapped_count);
CGW_RULE(eds_pdo_pair);
CGW_RULE(eds_transmission_type);
CGW_RULE(eds_cob_id_restricted);
CGW_RULE(eds_cob_id_twice);
CGW_RULE(eds_cob_id_form);
CGW_RULE(eds_node_id_absent);
CGW_RULE(eds_sdo_server);
CGW_RULE(eds_heartbeat_consumer);

// E09: XDD and XDC, as they are read
CGW_RULE(xdd_text);
CGW_RULE(xdd_root);
CGW_RULE(xdd_absent);
CGW_RULE(xdd_value);
CGW_RULE(xdd_number_range);
CGW_RULE(xdd_number_form);
CGW_RULE(xdd_data_type);
CGW_RULE(xdd_object_type);
CGW_RULE(xdd_access);
CGW_RULE(xdd_no_access);
CGW_RULE(xdd_reference);
CGW_RULE(xdd_contradiction);
CGW_RULE(xdd_twice);

// E10: CAN databases (DBC)
CGW_RULE(dbc_text);
CGW_RULE(dbc_statement);
CGW_RULE(dbc_twice);

#undef CGW_RULE

}  // namespace rules

// All of the above, sorted by code.
std::span<const Rule* const> all_rules();

}  // namespace cgw::diagnostic
