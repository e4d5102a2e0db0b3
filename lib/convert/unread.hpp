// What of an EDS or DCF cgw passes over, so that no conversion carries it.
#pragma once

#include <string>
#include <vector>

#include "xdd/unread.hpp"

namespace cgw::convert {

using xdd::Unread;

// Sections that mean nothing to cgw, as they are spelt there: [Tools], [DynamicChannels], those of a vendor;
// then keys that CiA 306 does not give to the other sections, then lines of comment; each in file order.
std::vector<Unread> unread_of_sections(std::string text);

}  // namespace cgw::convert
