#include "cli/canopen-gateway/plant_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/canopen-gateway/display.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr Time sdo_timeout = 500'000;
constexpr Time longest_step = 1'000;

}  // namespace

PlantRun::PlantRun(const image::Image& image, Time duration, std::ostream& out)
    : image_(&image),
      out_(&out),
      end_(duration),
      plant_(image),
      node_(plant_.can2(), image.can2().own_node, sdo_timeout),
      plc_(plant_.can2(), node_, image) {
    simulation::subscribe_transmit_pdos(node_, image);
    plc_.send_heartbeat();
}

bool PlantRun::run_for(Time time) {
    const Time target = now() + time;
    return run_until([this, target] { return now() >= target; }, time) && !over();
}

bool PlantRun::run_until(const std::function<bool()>& reached, Time at_most) {
    const Time target = std::min(end_, now() + at_most);
    while (!reached()) {
        if (now() >= target) {
            return false;
        }
        plant_.run_until(std::min(target, now() + longest_step));
    }
    return true;
}

void PlantRun::say(std::string_view text) {
    const auto milliseconds = now() / 1000;
    *out_ << clipped(fmt::format("{:4}.{:03} s  {}", milliseconds / 1000, milliseconds % 1000, text),
                     line_width)
          << '\n';
}

void PlantRun::detail(std::string_view text) {
    *out_ << clipped(fmt::format("            {}", text), line_width) << '\n';
}

std::optional<PlantRun::Transfer> PlantRun::upload(std::uint16_t index, std::uint8_t sub_index) {
    master().sdo().upload({index, sub_index});
    return finish_transfer();
}

std::optional<PlantRun::Transfer> PlantRun::download(std::uint16_t index, std::uint8_t sub_index,
                                                     std::uint32_t value, std::uint8_t length) {
    master().sdo().download({index, sub_index}, value, length);
    return finish_transfer();
}

std::optional<PlantRun::Transfer> PlantRun::finish_transfer() {
    using Status = canopen::SdoClient::Status;
    const canopen::SdoClient& sdo = master().sdo();
    if (!run_until([&sdo] { return sdo.status() != Status::busy; }, 2 * sdo_timeout)) {
        return std::nullopt;
    }
    return Transfer{static_cast<std::uint32_t>(sdo.abort_code()), sdo.value(), sdo.length()};
}

}  // namespace cgw::gateway_cli
