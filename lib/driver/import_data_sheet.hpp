// The EDS or DCF of a configured gateway as a parameter file, and what that file makes of the gateway.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dictionary/difference.hpp"
#include "driver/check_file.hpp"
#include "driver/device_description.hpp"

namespace cgw::driver {

struct ImportedDataSheet {
    std::string text;                       // the parameter file; its first comments say what is missing
    std::vector<std::string> undetermined;  // what the data sheet does not say, nor the plant; a phrase each
    std::vector<std::string> contradictions;  // "427 CanOpMyNodeNumber: 12, not 13": not as the plant says it
    CheckedFile file;                         // of the text
    // The data sheet (A) and the gateway that the file configures (B).
    dictionary::Differences differences;
};

struct ImportOptions {
    std::string title{};                    // "": what the data sheet's description says
    std::optional<std::uint8_t> node_id{};  // where the data sheet does not state it
    std::string first_line{};               // put before all other text
    const CheckedFile* plant = nullptr;     // valid; says what the data sheet does not
};

// `sheet` is valid and describes a gateway (authoring::describes_gateway); `path` is what findings call the
// text.
ImportedDataSheet import_data_sheet(const DeviceDescription& sheet, const std::string& path,
                                    const ImportOptions& options);

}  // namespace cgw::driver
