// The checks behind the table of checks.cpp, by the file that holds them.
#pragma once

#include "eds_check/checks.hpp"

namespace cgw::eds_check {

// text.cpp
void check_line_lengths(const Context& context);
void check_characters(const Context& context);
void check_byte_order_mark(const Context& context);
void check_comment_marks(const Context& context);
void check_line_ends(const Context& context);
void check_blanks(const Context& context);
void check_header_tails(const Context& context);
void check_semicolons(const Context& context);

// names.cpp
void check_section_case(const Context& context);
void check_sub_zeros(const Context& context);
void check_unknown_sections(const Context& context);
void check_key_case(const Context& context);
void check_misspelt_keys(const Context& context);
void check_unknown_keys(const Context& context);
void check_absent_sections(const Context& context);
void check_absent_keys(const Context& context);
void check_both_commissionings(const Context& context);
void check_absent_commissioning(const Context& context);

// lists.cpp
void check_list_counts(const Context& context);
void check_entry_counts(const Context& context);
void check_comment_counts(const Context& context);
void check_list_numbers(const Context& context);
void check_listed_twice(const Context& context);
void check_listed_objects(const Context& context);
void check_unlisted_objects(const Context& context);
void check_list_choice(const Context& context);
void check_mandatory_objects(const Context& context);

// objects.cpp
void check_key_uses(const Context& context);
void check_names(const Context& context);
void check_equal_names(const Context& context);
void check_object_types_stated(const Context& context);
void check_standard_codes(const Context& context);
void check_standard_types(const Context& context);
void check_access_case(const Context& context);

// sub_objects.cpp
void check_sub_numbers(const Context& context);
void check_sub_numbers_stated(const Context& context);
void check_first_sub_objects(const Context& context);
void check_first_sub_types(const Context& context);
void check_first_sub_values(const Context& context);
void check_defaults(const Context& context);
void check_array_types(const Context& context);
void check_sub_object_types(const Context& context);

// modules.cpp
void check_modules(const Context& context);
void check_object_links(const Context& context);

// values.cpp
void check_octal_numbers(const Context& context);
void check_leading_zeros(const Context& context);
void check_limits(const Context& context);
void check_values_in_limits(const Context& context);
void check_signed_values(const Context& context);
void check_formula_places(const Context& context);
void check_domain_defaults(const Context& context);
void check_mappable_access(const Context& context);
void check_mappable_types(const Context& context);

// information.cpp
void check_file_name(const Context& context);
void check_version(const Context& context);
void check_dates(const Context& context);
void check_times(const Context& context);
void check_identity(const Context& context);
void check_bit_rates(const Context& context);
void check_granularity(const Context& context);
void check_pdo_counts(const Context& context);
void check_lss(const Context& context);
void check_node(const Context& context);
void check_node_bit_rate(const Context& context);
void check_serial_number(const Context& context);
void check_configured_values(const Context& context);

// pdos.cpp
void check_mapped_objects(const Context& context);
void check_mapped_lengths(const Context& context);
void check_mapped_mappable(const Context& context);
void check_mapped_directions(const Context& context);
void check_dummies(const Context& context);
void check_mapped_bits(const Context& context);
void check_mapped_counts(const Context& context);
void check_pdo_pairs(const Context& context);
void check_transmission_types(const Context& context);

// identifiers.cpp
void check_restricted_identifiers(const Context& context);
void check_duplicate_identifiers(const Context& context);
void check_identifier_forms(const Context& context);
void check_node_bases(const Context& context);
void check_default_server(const Context& context);

// heartbeat.cpp
void check_heartbeat_consumers(const Context& context);

}  // namespace cgw::eds_check
