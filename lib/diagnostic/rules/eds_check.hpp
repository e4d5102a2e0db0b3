// E08: EDS and DCF, as they are checked. Every name once; the rows stand in the files eds_check_*.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_EDS_CHECK_RULES(RULE) \
    RULE(eds_formula_place) \
    RULE(eds_line_length) \
    RULE(eds_character) \
    RULE(eds_byte_order_mark) \
    RULE(eds_comment_mark) \
    RULE(eds_line_ends) \
    RULE(eds_blanks) \
    RULE(eds_header_tail) \
    RULE(eds_semicolon) \
    RULE(eds_section_case) \
    RULE(eds_sub_zero) \
    RULE(eds_section_unknown) \
    RULE(eds_key_case) \
    RULE(eds_key_misspelt) \
    RULE(eds_key_unknown) \
    RULE(eds_section_absent) \
    RULE(eds_keys_absent) \
    RULE(eds_commissioning_twice) \
    RULE(eds_list_count) \
    RULE(eds_entry_count) \
    RULE(eds_comment_count) \
    RULE(eds_list_numbers) \
    RULE(eds_listed_twice) \
    RULE(eds_listed_absent) \
    RULE(eds_unlisted) \
    RULE(eds_wrong_list) \
    RULE(eds_mandatory_object) \
    RULE(eds_key_use) \
    RULE(eds_name_absent) \
    RULE(eds_names_equal) \
    RULE(eds_object_type_absent) \
    RULE(eds_sub_number) \
    RULE(eds_sub_number_absent) \
    RULE(eds_sub_0_absent) \
    RULE(eds_sub_0_type) \
    RULE(eds_sub_0_value) \
    RULE(eds_default_absent) \
    RULE(eds_array_types) \
    RULE(eds_standard_code) \
    RULE(eds_standard_type) \
    RULE(eds_access_case) \
    RULE(eds_octal) \
    RULE(eds_leading_zero) \
    RULE(eds_limits) \
    RULE(eds_value_limits) \
    RULE(eds_signed_value) \
    RULE(eds_mappable_rw) \
    RULE(eds_mappable_type) \
    RULE(eds_file_name) \
    RULE(eds_version) \
    RULE(eds_date) \
    RULE(eds_time) \
    RULE(eds_identity) \
    RULE(eds_bit_rates) \
    RULE(eds_granularity) \
    RULE(eds_pdo_count) \
    RULE(eds_lss) \
    RULE(eds_node_id) \
    RULE(eds_node_bit_rate) \
    RULE(eds_serial_number) \
    RULE(eds_configured_value) \
    RULE(eds_mapped_absent) \
    RULE(eds_mapped_length) \
    RULE(eds_mapped_refused) \
    RULE(eds_mapped_direction) \
    RULE(eds_dummy) \
    RULE(eds_mapped_bits) \
    RULE(eds_mapped_count) \
    RULE(eds_pdo_pair) \
    RULE(eds_transmission_type) \
    RULE(eds_cob_id_restricted) \
    RULE(eds_cob_id_twice) \
    RULE(eds_cob_id_form) \
    RULE(eds_node_id_absent) \
    RULE(eds_sdo_server) \
    RULE(eds_heartbeat_consumer) \
    RULE(eds_sub_object_type) \
    RULE(eds_module) \
    RULE(eds_object_link) \
    RULE(eds_commissioning_absent) \
    RULE(eds_domain_default)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_EDS_CHECK_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
