// The whole program, over streams and an image handed in, so that tests run it as users do.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>

namespace cgw::gateway_cli {

// Arguments without the program's name. Returns the exit code.
int run(std::span<const char* const> arguments, std::span<const std::uint8_t> image_bytes, std::ostream& out,
        std::ostream& error);

}  // namespace cgw::gateway_cli
