// A device and its objects, from whatever file describes them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "convert/unread.hpp"
#include "diagnostic/diagnostic.hpp"
#include "dictionary/dictionary.hpp"

namespace cgw::driver {

// What kind a file is, is told from its content.
enum class DescriptionKind : std::uint8_t {
    data_sheet,
    configuration_file,
    parameter_file,
    image,
    xml_description,
    xml_configuration,
};

std::string_view to_text(DescriptionKind kind);  // "EDS", "parameter file"
constexpr bool is_eds(DescriptionKind kind) {    // or DCF
    return kind == DescriptionKind::data_sheet || kind == DescriptionKind::configuration_file;
}
constexpr bool is_of_any_device(DescriptionKind kind) {  // EDS, DCF, XDD, XDC
    return kind != DescriptionKind::parameter_file && kind != DescriptionKind::image;
}

struct DeviceDescription {
    std::string path;
    DescriptionKind kind = DescriptionKind::data_sheet;
    dictionary::Dictionary dictionary;
    std::optional<dictionary::Commissioning> commissioning;
    std::optional<std::uint8_t> node_id;  // of the one device it describes
    std::string configuration_id;         // 16 digits; of a parameter file and an image
    diagnostic::Findings findings;        // sorted by place
    std::map<std::string, std::string> sources;
    std::vector<convert::FurtherSection> sections;  // of an EDS or DCF
    std::vector<convert::Unread> unread;            // of an EDS, DCF, XDD or XDC: what nothing here holds
    bool unreadable = false;                        // exit code 3

    // The dictionary holds all that the file says.
    bool valid() const { return !unreadable && !findings.has_errors(); }
};

// An EDS or DCF, an XDD or XDC, a parameter file, or a configuration image. Path "-" is standard input. A
// parameter file must pass every check. Fails on a malformed SOURCE_DATE_EPOCH.
base::Result<DeviceDescription> read_device_description(const std::string& path);

}  // namespace cgw::driver
