#include "partner/half.hpp"

#include <fmt/format.h>

namespace cgw::partner {

std::string prefix(const Half& half) {
    return fmt::format("gw{}", half.node_id);
}

std::optional<int> raw_of_on(const signals::Signal& signal) {
    for (const signals::NamedValue& value : signal.values) {
        if (value.text == "on") {
            return value.raw;
        }
    }
    return std::nullopt;
}

}  // namespace cgw::partner
