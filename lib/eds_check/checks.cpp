#include "eds_check/checks.hpp"

#include <algorithm>

#include "diagnostic/rules/eds.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/context.hpp"
#include "eds_check/repairs.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;

constexpr auto by_reader = nullptr;
constexpr bool refused = true;  // by strict importers
constexpr bool tolerated = false;
constexpr auto no_repair = nullptr;
constexpr bool doubtful = true;

const Check table[] = {
    {&rules::eds_text, by_reader, refused, no_repair, doubtful},
    {&rules::eds_header, by_reader, refused, no_repair, doubtful},
    {&rules::eds_section_twice, by_reader, refused, no_repair, doubtful},
    {&rules::eds_key_twice, by_reader, refused, no_repair, doubtful},
    {&rules::eds_too_much, by_reader, refused, no_repair, doubtful},
    {&rules::eds_number_form, by_reader, refused, mend_number_form},
    {&rules::eds_formula, by_reader, refused, mend_formula},
    {&rules::eds_spelling, by_reader, refused, mend_spelling},

    {&rules::eds_line_length, check_line_lengths},
    {&rules::eds_character, check_characters},
    {&rules::eds_byte_order_mark, check_byte_order_mark, tolerated, remove_byte_order_mark},
    {&rules::eds_comment_mark, check_comment_marks, tolerated, mend_comment_mark},
    {&rules::eds_line_ends, check_line_ends},
    {&rules::eds_blanks, check_blanks, tolerated, remove_blanks},
    {&rules::eds_header_tail, check_header_tails},
    {&rules::eds_semicolon, check_semicolons},

    {&rules::eds_section_case, check_section_case, tolerated, mend_section_name},
    {&rules::eds_sub_zero, check_sub_zeros, tolerated, mend_section_name},
    {&rules::eds_section_unknown, check_unknown_sections},
    {&rules::eds_key_case, check_key_case, tolerated, mend_key_case},
    {&rules::eds_key_misspelt, check_misspelt_keys, refused},
    {&rules::eds_key_unknown, check_unknown_keys, refused},
    {&rules::eds_section_absent, check_absent_sections},
    {&rules::eds_keys_absent, check_absent_keys},
    {&rules::eds_commissioning_twice, check_both_commissionings, refused, no_repair, doubtful},

    {&rules::eds_list_count, check_list_counts, refused, mend_count},
    {&rules::eds_entry_count, check_entry_counts, tolerated, mend_count},
    {&rules::eds_comment_count, check_comment_counts, tolerated, mend_count},
    {&rules::eds_list_numbers, check_list_numbers, refused, number_list},
    {&rules::eds_listed_twice, check_listed_twice, tolerated, unlist},
    {&rules::eds_listed_absent, check_listed_objects, refused},
    {&rules::eds_unlisted, check_unlisted_objects, refused},
    {&rules::eds_wrong_list, check_list_choice},
    {&rules::eds_mandatory_object, check_mandatory_objects},

    {&rules::eds_key_use, check_key_uses},
    {&rules::eds_name_absent, check_names},
    {&rules::eds_names_equal, check_equal_names},
    {&rules::eds_object_type_absent, check_object_types_stated, tolerated, state_object_type},
    {&rules::eds_sub_number, check_sub_numbers, refused, mend_sub_number},
    {&rules::eds_sub_number_absent, check_sub_numbers_stated, tolerated, state_sub_number},
    {&rules::eds_sub_0_absent, check_first_sub_objects},
    {&rules::eds_sub_0_type, check_first_sub_types},
    {&rules::eds_sub_0_value, check_first_sub_values, refused},
    {&rules::eds_default_absent, check_defaults},
    {&rules::eds_array_types, check_array_types},
    {&rules::eds_standard_code, check_standard_codes, tolerated, mend_standard_code},
    {&rules::eds_standard_type, check_standard_types},
    {&rules::eds_access_case, check_access_case, refused, lower_access},

    {&rules::eds_octal, check_octal_numbers},
    {&rules::eds_leading_zero, check_leading_zeros, tolerated, remove_leading_zeros},
    {&rules::eds_limits, check_limits},
    {&rules::eds_value_limits, check_values_in_limits},
    {&rules::eds_signed_value, check_signed_values},
    {&rules::eds_formula_place, check_formula_places},
    {&rules::eds_mappable_rw, check_mappable_access, refused},
    {&rules::eds_mappable_type, check_mappable_types},

    {&rules::eds_file_name, check_file_name, tolerated, mend_file_name},
    {&rules::eds_version, check_version, tolerated, mend_version},
    {&rules::eds_date, check_dates, tolerated, mend_date},
    {&rules::eds_time, check_times, refused, mend_time},
    {&rules::eds_identity, check_identity, refused, mend_identity},
    {&rules::eds_bit_rates, check_bit_rates},
    {&rules::eds_granularity, check_granularity},
    {&rules::eds_pdo_count, check_pdo_counts, refused, mend_pdo_count},
    {&rules::eds_lss, check_lss},
    {&rules::eds_node_id, check_node},
    {&rules::eds_node_bit_rate, check_node_bit_rate},
    {&rules::eds_serial_number, check_serial_number},
    {&rules::eds_configured_value, check_configured_values},

    {&rules::eds_mapped_absent, check_mapped_objects, refused},
    {&rules::eds_mapped_length, check_mapped_lengths, refused},
    {&rules::eds_mapped_refused, check_mapped_mappable, refused},
    {&rules::eds_mapped_direction, check_mapped_directions, refused},
    {&rules::eds_dummy, check_dummies, refused},
    {&rules::eds_mapped_bits, check_mapped_bits, refused},
    {&rules::eds_mapped_count, check_mapped_counts, refused},
    {&rules::eds_pdo_pair, check_pdo_pairs},
    {&rules::eds_transmission_type, check_transmission_types},

    {&rules::eds_cob_id_restricted, check_restricted_identifiers},
    {&rules::eds_cob_id_twice, check_duplicate_identifiers},
    {&rules::eds_cob_id_form, check_identifier_forms},
    {&rules::eds_node_id_absent, check_node_bases},
    {&rules::eds_sdo_server, check_default_server},
    {&rules::eds_heartbeat_consumer, check_heartbeat_consumers},

    {&rules::eds_sub_object_type, check_sub_object_types, tolerated, mend_sub_object_type},
    {&rules::eds_module, check_modules},
    {&rules::eds_object_link, check_object_links},
    {&rules::eds_commissioning_absent, check_absent_commissioning},
    {&rules::eds_domain_default, check_domain_defaults},
};

std::vector<const diagnostic::Rule*> strict_rules() {
    std::vector<const diagnostic::Rule*> strict;
    for (const Check& row : table) {
        if (row.strict) {
            strict.push_back(row.rule);
        }
    }
    return strict;
}

}  // namespace

std::span<const Check> all_checks() {
    return table;
}

const Check* find_check(const diagnostic::Rule* rule) {
    const auto* const found = std::find_if(std::begin(table), std::end(table),
                                           [rule](const Check& row) { return row.rule == rule; });
    return found != std::end(table) ? found : nullptr;
}

void check(const eds::Document& document, const eds::Sheet& sheet, const std::string& path,
           const Options& options, diagnostic::Findings& findings) {
    if (eds::is_sheet(document)) {
        eds::Reading reading(document, sheet.sections, path, findings, options.most_findings);
        const Model model(document, sheet);
        const Context context{reading, document, sheet, model, options};
        for (const Check& row : table) {
            if (row.run != nullptr) {
                row.run(context);
            }
        }
        reading.finish();
    }
    if (options.strict) {
        findings.promote(strict_rules());
    }
}

}  // namespace cgw::eds_check
