#include "gateway_operations.hpp"

#include <stdexcept>

#include "canopen/nmt.hpp"
#include "canopen/sdo.hpp"
#include "driver/plant.hpp"

namespace cgw::bench {
namespace {

constexpr std::uint8_t node = 12;  // 427
constexpr std::uint32_t rpdo3 = canopen::cob::rpdo[2] + node;
constexpr std::uint32_t foreign = 0x123;

void ask(RunningGateway& running, std::uint8_t command, std::uint16_t index, std::uint8_t sub_index) {
    frame::Frame frame;
    frame.id = canopen::cob::sdo_request + node;
    frame.length = canopen::sdo::frame_length;
    frame.data = {command, static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(index >> 8),
                  sub_index};
    running.gateway.receive(frame, running.now);
}

// Two objects far from each other in turn: the server has to search for each.
void ask_in_turn(RunningGateway& running) {
    const bool odd = running.port.frames % 2 != 0;
    ask(running, 0x40, odd ? 0x2000 : 0x1800, 3);
}

void receive(RunningGateway& running, std::uint32_t id) {
    frame::Frame frame;
    frame.id = id;
    frame.length = 8;
    running.gateway.receive(frame, running.now);
}

constexpr Operation all[] = {
    {"SDO upload u16", [](RunningGateway& running) { ask(running, 0x40, 0x2000, 3); }, 1, true},
    {"SDO upload u32", [](RunningGateway& running) { ask(running, 0x40, 0x1018, 2); }, 1, true},
    {"SDO upload, another each time", ask_in_turn, 1, true},
    {"SDO download refused", [](RunningGateway& running) { ask(running, 0x2B, 0x1017, 0); }, 1, true},
    {"SDO object missing", [](RunningGateway& running) { ask(running, 0x40, 0x3000, 0); }, 1, true},
    {"RPDO of 4 words", [](RunningGateway& running) { receive(running, rpdo3); }, 0, true},
    {"RPDO of 4 words, and poll",
     [](RunningGateway& running) {
         receive(running, rpdo3);
         running.gateway.poll(running.now);
     },
     0, true},
    {"foreign frame", [](RunningGateway& running) { receive(running, foreign); }, 0, true},
    {"foreign frame, and poll",
     [](RunningGateway& running) {
         receive(running, foreign);
         running.gateway.poll(running.now);
     },
     0, true},
    {"governor cycle with 13 TPDOs",
     [](RunningGateway& running) { running.gateway.main_cycle(running.data, running.now); }, 13},
    {"idle poll", [](RunningGateway& running) { running.gateway.poll(running.now); }, 0},
};

}  // namespace

base::Bytes image_of(const std::string& parameter_file) {
    const driver::CheckedFile file = driver::check_file(parameter_file);
    if (!file.valid()) {
        throw std::runtime_error(parameter_file + " is not valid");
    }
    const auto plant = driver::Plant::make(file);
    return emit::find_emitter("image")->emit(plant->view(), {});
}

RunningGateway::RunningGateway() : bytes_(image_of(CGW_TEST_DATA "/full.toml")) {
    if (image::Image::open(bytes_, image_) != image::Status::ok ||
        gateway.open(image_, now) != device::OpenStatus::ok) {
        throw std::runtime_error("the image is refused");
    }
    gateway.command(device::GovernorCommand::init, now);
    gateway.command(device::GovernorCommand::pre_operational, now);
    gateway.receive(canopen::nmt_frame(canopen::NmtCommand::start, node), now);
    gateway.main_cycle(data, now);
}

std::span<const Operation> operations() {
    return all;
}

}  // namespace cgw::bench
