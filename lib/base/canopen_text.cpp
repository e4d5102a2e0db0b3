#include "base/canopen_text.hpp"

#include <fmt/format.h>

#include "base/numbers.hpp"

namespace cgw::base {

std::string object_text(unsigned index) {
    return fmt::format("{:04X}h", index);
}

std::string object_text(unsigned index, unsigned sub_index) {
    return fmt::format("{:04X}h:{}", index, sub_index);
}

std::string identifier_text(std::uint32_t identifier) {
    return fmt::format("{:03X}h", identifier);
}

std::string pdo_name(bool is_transmit, unsigned number) {
    return fmt::format("{}PDO{}", is_transmit ? 'T' : 'R', number);
}

std::string milliseconds(std::uint64_t microseconds) {
    return to_text(static_cast<double>(microseconds) / 1000);
}

std::string milliseconds_text(std::uint64_t microseconds) {
    return milliseconds(microseconds) + " ms";
}

}  // namespace cgw::base
