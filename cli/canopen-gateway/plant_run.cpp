#include "cli/canopen-gateway/plant_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canopen/nmt.hpp"
#include "cli/canopen-gateway/display.hpp"
#include "facts/gateway.hpp"
#include "wire/little_endian.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr Time sdo_timeout = 500'000;
constexpr Time longest_period = 50'000;  // of what the master sends by itself
constexpr Time longest_step = 1'000;

// Twice in the time within which the gateway expects it.
Time period_for(Time monitoring) {
    return monitoring == 0 ? longest_period : std::min(longest_period, monitoring / 2);
}

}  // namespace

PlantRun::PlantRun(const image::Image& image, Time duration, std::ostream& out)
    : image_(&image),
      out_(&out),
      end_(duration),
      plant_(image),
      node_(plant_.can2(), image.can2().own_node, sdo_timeout) {
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image.pdo(position);
        if (pdo.active) {
            master().subscribe(pdo.cob_id);
        }
    }
    send_heartbeat();
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

void PlantRun::send_outputs() {
    for (std::size_t rpdo = 0; rpdo < outputs_.size(); ++rpdo) {
        const image::Pdo pdo = image_->pdo(facts::tpdo_count + rpdo);
        if (!pdo.active) {
            continue;
        }
        frame::Frame frame;
        frame.id = pdo.cob_id;
        frame.length = static_cast<std::uint8_t>(facts::word_bytes * pdo.word_count);
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            wire::store_u16(&frame.data[facts::word_bytes * word], outputs_[rpdo][word]);
        }
        node_.produce(frame, period_for(pdo.effective_us));
    }
}

// In the name of the partner whose heartbeat the gateway watches.
void PlantRun::send_heartbeat() {
    const image::Heartbeat heartbeat = image_->heartbeat();
    if (heartbeat.consumer_us != 0) {
        node_.produce(canopen::heartbeat_frame(heartbeat.consumer_node, canopen::NmtState::operational),
                      period_for(heartbeat.consumer_us));
    }
}

}  // namespace cgw::gateway_cli
