// Inside the room explain: the entries about one thing each.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/abort_codes.hpp"
#include "catalogue/errors.hpp"
#include "diagnostic/rule.hpp"
#include "explain/answer.hpp"
#include "explain/query.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::explain {

Entry parameter_entry(const parameter::Row& row, const parameter::Catalogue& catalogue);

// The errors that these parameters show, each once, and after them the parameters.
std::vector<Entry> row_entries(const std::vector<const parameter::Row*>& rows,
                               const parameter::Catalogue& catalogue);

Entry error_entry(const catalogue::ErrorDescription& error, const parameter::Catalogue& catalogue);

Entry rule_entry(const diagnostic::Rule& rule);
Entry abort_code_entry(const base::AbortCodeRow& row);

// The object or its entry; nullopt when the Gateway has none.
std::optional<Entry> object_entry(const ObjectName& name, const parameter::Catalogue& catalogue);

// What the device makes of a time; nothing where the parameter is none.
void add_time(Entry& entry, const parameter::Row& row, std::uint32_t value);
// The bit, channel or measurement that the value of an 8nn, a 9nn or a TPDO word leads to.
void add_what_it_leads_to(Entry& entry, const parameter::Row& row, double value,
                          const parameter::Catalogue& catalogue);

// What the value of a parameter or an object says.
Entry parameter_value_entry(const parameter::Row& row, double value, const parameter::Catalogue& catalogue);
Answer object_value_answer(const ObjectName& name, std::uint32_t value,
                           const parameter::Catalogue& catalogue);

// "3070 ErrCanBus1", with the device where it is not this one: "governor 3070 ErrCanBus".
std::string reference_text(std::uint16_t number, parameter::Device device, parameter::Program program,
                           const parameter::Catalogue& catalogue);

// "bits 1..15  Node1..15: the governor with …": neighbours that differ in numbers share a line.
std::vector<std::string> bit_lines(const std::vector<parameter::NamedBit>& bits);

}  // namespace cgw::explain
