// What `cgw list` lists, as tables. The list of emitters is made where emitters are known.
#pragma once

#include <optional>

#include "explain/table.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::explain {

// Parameters of one device, or of both; the gateway's bootloader is a group of its own. For people, the
// elements of an array and numbers that have no name share a row; for programs, every number has its own.
Table parameter_list(const parameter::Catalogue& catalogue, std::optional<parameter::Device> device,
                     bool for_people);

// The rules behind the findings, by code.
Table check_list();

// What cgw assumes where the documents leave a point open, and how to measure it.
Table assumption_list();

// What a running device answers with: error numbers of both devices and the SDO abort codes. With `device`,
// the errors of that device only; abort codes are the gateway's.
Table code_list(const parameter::Catalogue& catalogue, std::optional<parameter::Device> device);

}  // namespace cgw::explain
