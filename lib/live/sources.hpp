// Which parameters decide what an object holds: for whoever finds another value in the device.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::live {

struct Sources {
    std::string
        text;  // "gateway 16404 CanOpTPDO5-16ID(0)=0x282; assignment and …"; empty: fixed in the device
    // Those named by a number of their own, with their values in the file; not those within a range.
    struct Parameter {
        const parameter::Row* row = nullptr;
        double value = 0;
    };
    std::vector<Parameter> parameters;
};

// From the descriptions of the objects (schemas/objects), with names and the file's values put in.
Sources sources_of(std::uint16_t index, std::uint8_t sub_index, const parameter::Settings& settings,
                   const parameter::Catalogue& catalogue);

}  // namespace cgw::live
