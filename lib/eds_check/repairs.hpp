// The repairs behind the table of checks.cpp. Each gets the place of a finding of its rule, and gives nothing
// where more than one thing can be meant.
#pragma once

#include <optional>

#include "eds_check/checks.hpp"

namespace cgw::eds_check {

// repair_text.cpp
std::optional<Repair> remove_byte_order_mark(const Context& context, const eds::Span& place);
std::optional<Repair> mend_comment_mark(const Context& context, const eds::Span& place);
std::optional<Repair> remove_blanks(const Context& context, const eds::Span& place);
std::optional<Repair> mend_spelling(const Context& context, const eds::Span& place);
std::optional<Repair> mend_section_name(const Context& context, const eds::Span& place);
std::optional<Repair> mend_key_case(const Context& context, const eds::Span& place);
std::optional<Repair> mend_number_form(const Context& context, const eds::Span& place);
std::optional<Repair> mend_formula(const Context& context, const eds::Span& place);
std::optional<Repair> remove_leading_zeros(const Context& context, const eds::Span& place);
std::optional<Repair> lower_access(const Context& context, const eds::Span& place);

// repair_objects.cpp
std::optional<Repair> mend_count(const Context& context, const eds::Span& place);
std::optional<Repair> number_list(const Context& context, const eds::Span& place);
std::optional<Repair> unlist(const Context& context, const eds::Span& place);
std::optional<Repair> mend_sub_number(const Context& context, const eds::Span& place);
std::optional<Repair> state_sub_number(const Context& context, const eds::Span& place);
std::optional<Repair> state_object_type(const Context& context, const eds::Span& place);
std::optional<Repair> mend_sub_object_type(const Context& context, const Span& place);
std::optional<Repair> mend_standard_code(const Context& context, const eds::Span& place);
std::optional<Repair> mend_pdo_count(const Context& context, const eds::Span& place);
std::optional<Repair> mend_identity(const Context& context, const eds::Span& place);
std::optional<Repair> mend_file_name(const Context& context, const eds::Span& place);
std::optional<Repair> mend_version(const Context& context, const eds::Span& place);
std::optional<Repair> mend_date(const Context& context, const eds::Span& place);
std::optional<Repair> mend_time(const Context& context, const eds::Span& place);

}  // namespace cgw::eds_check
