// A governor as a process of its own: governor_program hub:127.0.0.1:29536/can1
// It runs until SIGTERM and prints a line when it is ready.
#include <fmt/format.h>

#include <csignal>

#include "media/open_channel.hpp"
#include "support/governor_on_channel.hpp"

extern "C" const unsigned char cgw_config_image[];
extern "C" const unsigned int cgw_config_image_size;

int main(int count, char** arguments) {
    using namespace cgw;
    image::Image image;
    if (count != 2 ||
        image::Image::open({cgw_config_image, cgw_config_image_size}, image) != image::Status::ok) {
        fmt::print(stderr, "usage: governor_program CAN1\n");
        return 2;
    }
    const auto channel = media::open_channel(arguments[1]);
    if (!channel) {
        fmt::print(stderr, "{}\n", channel.error().message);
        return 3;
    }
    media::Loop loop;
    media::Signals signals({SIGTERM, SIGINT}, [&](int) { loop.stop(); });
    test::GovernorOnChannel governor(image, **channel, loop.now());
    loop.add(signals);
    loop.add(governor);
    fmt::print("ready\n");
    std::fflush(stdout);
    loop.run();
    return 0;
}
