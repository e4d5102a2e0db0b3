// A copy of a parameter file for another gateway: its text with a few values replaced.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "config/configuration.hpp"
#include "diagnostic/diagnostic.hpp"
#include "parameter/settings.hpp"

namespace cgw::authoring {

struct CloneRequest {
    std::uint8_t node_id = 0;            // 1..127
    std::optional<std::string> title{};  // nullopt: as it is
    bool keep_identifiers = false;       // the copy is for another CANopen network
    // Active TPDOs whose identifiers are not of that form get the next ones from here, in 680h..6DFh.
    std::optional<std::uint16_t> identifiers_from{};
};

// Replaces 427, the title, and identifiers of TPDO5..16 of the form base + node id (D30). Another identifier
// of an active TPDO would be sent by both gateways: a finding (E0508) unless the identifiers are kept or new
// ones are given; so is a new one that a PDO of either gateway has or that is outside 680h..6DFh.
// Comments, order and spelling stay. `settings` and `configuration` are those of `text`, which is valid.
// nullopt after a finding.
std::optional<std::string> clone_text(std::string_view text, const parameter::Settings& settings,
                                      const config::Configuration& configuration, const CloneRequest& request,
                                      diagnostic::Findings& findings);

}  // namespace cgw::authoring
