// Judges of the identifier of one active PDO: each gives its finding or nothing. The first that objects has
// the word.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "check/checks.hpp"

namespace cgw::check {

// network_identifiers.cpp
std::optional<diagnostic::Diagnostic> judge_foreign(const Context& context, const config::Pdo& pdo);
std::optional<diagnostic::Diagnostic> judge_restricted(const Context& context, const config::Pdo& pdo);
std::optional<diagnostic::Diagnostic> judge_unlisted_owner(const Context& context, const config::Pdo& pdo);
std::optional<diagnostic::Diagnostic> judge_default_rpdo(const Context& context, const config::Pdo& pdo);

// identifiers.cpp, for TPDO5..16: 16404..16415, its label, and a finding at its value that proposes a free
// one.
std::uint16_t identifier_parameter(const config::Pdo& pdo);
std::string identifier_label(const Context& context, const config::Pdo& pdo);
diagnostic::Diagnostic finding_at(const Context& context, const config::Pdo& pdo,
                                  const diagnostic::Rule& rule);

// The identifier is typed in decimal and reported for that (D15): it may not be the one that is meant.
bool is_in_doubt(const Context& context, const config::Pdo& pdo);

}  // namespace cgw::check
