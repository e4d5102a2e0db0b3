// What a file says of a device, and of one node where it is a configuration.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"

namespace cgw::convert {

// A section of an EDS or DCF that says nothing of objects: [Tools], [DynamicChannels], one of a vendor.
struct FurtherSection {
    std::string name;                // as it is spelt
    std::vector<std::string> lines;  // as they stand there; no comments, none that are blank

    friend bool operator==(const FurtherSection&, const FurtherSection&) = default;
};

struct Description {
    dictionary::Dictionary dictionary;
    std::optional<dictionary::Commissioning> node;
    std::vector<FurtherSection> sections{};  // an EDS or DCF made of it has them as well

    friend bool operator==(const Description&, const Description&) = default;
};

}  // namespace cgw::convert
