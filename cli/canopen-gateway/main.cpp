#include <exception>
#include <iostream>
#include <span>

#include "cli/canopen-gateway/options.hpp"
#include "cli/canopen-gateway/run.hpp"
#include "image/area.hpp"

// Made from the parameter file at build time (cmake/CgwEmbedConfig.cmake).
extern "C" const unsigned char cgw_config_image[];
extern "C" const unsigned int cgw_config_image_size;

namespace {

// `cgw image embed` may have put another one there, which is shorter.
std::span<const unsigned char> embedded_image() {
    const std::span<const unsigned char> area(cgw_config_image, cgw_config_image_size);
    const std::span<const unsigned char> image = cgw::image::stated_image(area);
    return image.empty() ? area : image;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::span<const char* const> arguments(argv, static_cast<std::size_t>(argc));
        const int code = cgw::gateway_cli::run(arguments.subspan(argc > 0 ? 1 : 0), embedded_image(),
                                               std::cout, std::cerr);
        std::cout.flush();
        if (!std::cout) {
            std::cerr << "canopen-gateway: cannot write to standard output\n";
            return cgw::gateway_cli::exit_environment;
        }
        return code;
    } catch (const std::exception& failure) {
        std::cerr << "canopen-gateway: internal error: " << failure.what() << '\n';
    }
    return cgw::gateway_cli::exit_internal;
}
