#include "bit_timing/controller.hpp"

namespace cgw::bit_timing {

const Controller* find_controller(std::string_view name) {
    for (const Controller& row : controllers) {
        if (row.name == name) {
            return &row;
        }
    }
    return nullptr;
}

}  // namespace cgw::bit_timing
