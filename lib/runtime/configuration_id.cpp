#include "runtime/configuration_id.hpp"

#include "base/sha256.hpp"

namespace cgw::runtime {

std::string configuration_id_text(const image::Image& image) {
    constexpr std::size_t shown_bytes = 8;
    return base::to_hex(image.configuration_id().first(shown_bytes));
}

}  // namespace cgw::runtime
