// What of an EDS or DCF cgw passes over, so that no conversion carries it.
#pragma once

#include <string>
#include <vector>

#include "convert/description.hpp"
#include "xdd/unread.hpp"

namespace cgw::convert {

using xdd::Unread;

struct PassedOver {
    std::vector<FurtherSection> sections;  // in file order
    std::vector<Unread>
        unread;  // keys that CiA 306 does not give to the other sections, then lines of comment
};
PassedOver passed_over_in(std::string text);

// The sections as what a format that has no place for them does not carry.
std::vector<Unread> unread_of(const std::vector<FurtherSection>& sections);

}  // namespace cgw::convert
