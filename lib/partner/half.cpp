#include "partner/half.hpp"

#include <fmt/format.h>

namespace cgw::partner {

std::string prefix(const Half& half) {
    return fmt::format("gw{}", half.node_id);
}

}  // namespace cgw::partner
