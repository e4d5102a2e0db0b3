// Descriptions of devices as verbs take them: EDS, DCF, XDD, XDC, parameter files, images.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/cgw/command.hpp"
#include "driver/device_description.hpp"

namespace cgw::cli {

inline constexpr Option node_id_option = {
    .names = "--node-id", .value = "N", .summary = "node number that $NODEID stands for, 1 to 127"};

// Throws UsageError for anything but a number from 1 to 127; nothing when the option is not given.
std::optional<std::uint8_t> node_id_of(const Arguments& arguments);

// Findings are on stderr; `exit_code` becomes worse where the file cannot be read or has errors.
driver::DeviceDescription load_description(const Arguments& arguments, const std::string& path,
                                           int& exit_code);

}  // namespace cgw::cli
