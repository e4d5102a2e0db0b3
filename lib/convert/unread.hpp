// What of a file cgw passes over, so that no conversion can carry it.
#pragma once

#include <string>
#include <vector>

namespace cgw::convert {

// Sections of an EDS or DCF that mean nothing to cgw, as they are spelt there: [Tools], [DynamicChannels],
// those of a vendor; in file order.
std::vector<std::string> sections_not_read(std::string text);

}  // namespace cgw::convert
