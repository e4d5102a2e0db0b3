// A parameter file from the EDS or DCF of a configured gateway.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.hpp"
#include "dictionary/dictionary.hpp"
#include "parameter/settings.hpp"

namespace cgw::authoring {

// 1018h says that the device is a CANopen Gateway.
bool describes_gateway(const dictionary::Dictionary& dictionary);

// The parameter file of the same plant, valid: what the data sheet does not say is taken from it.
struct PlantSource {
    const parameter::Settings& settings;
    const config::Configuration& configuration;
};

struct DataSheetSource {
    const dictionary::Dictionary& dictionary;                  // of a gateway
    const dictionary::Commissioning* commissioning = nullptr;  // of a DCF
    std::optional<std::uint8_t> node_id{};                     // where the file does not state it
    const PlantSource* plant = nullptr;
};

struct FileFromDataSheet {
    std::string text;
    std::vector<std::string> undetermined;  // what the data sheet does not say, nor the plant; a phrase each
    // Parameters that both say and that differ, as the data sheet has them: "427 CanOpMyNodeNumber: 12, not
    // 13".
    std::vector<std::string> contradictions;
};

// As much as a data sheet determines: identifiers, times, words and channels of PDOs, heartbeat, identity.
// Words and sensors are recognised by the names that cgw and the manual give to their objects. What the
// parameters are on the governor's side of the bus, no data sheet says: with a plant they are its own, and
// the data sheet counts where both say something. `remarks`: lines of comment at the top.
FileFromDataSheet file_from_data_sheet(const DataSheetSource& source, const std::vector<std::string>& remarks,
                                       const std::string& title);

}  // namespace cgw::authoring
