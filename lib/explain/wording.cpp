#include "explain/wording.hpp"

#include <array>

#include <fmt/format.h>

namespace cgw::explain {

std::string_view to_text(parameter::List list) {
    constexpr std::array<std::string_view, 4> names{"parameter", "measurement", "function", "curve"};
    return names.at(static_cast<std::size_t>(list));
}

std::string program_text(parameter::Device device, parameter::Program program) {
    const std::string_view name = to_text(device);
    return program == parameter::Program::application ? std::string(name)
                                                      : fmt::format("{} bootloader", name);
}

}  // namespace cgw::explain
