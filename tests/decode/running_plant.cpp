#include "running_plant.hpp"

#include <stdexcept>

#include "canopen/nmt.hpp"
#include "driver/plant.hpp"

namespace cgw::test {

RunningPlant::RunningPlant(const std::string& path) : file_(driver::check_file(path)) {
    if (!file_.valid()) {
        const auto& all = file_.findings.all();
        throw std::runtime_error(path + ": " + (all.empty() ? "unreadable" : all.front().message));
    }
    const auto made = driver::Plant::make(file_);
    const emit::Plant view = made->view();
    bytes_ = emit::find_emitter("image")->emit(view, {});
    const base::Bytes database = emit::find_emitter("dbc")->emit(view, {});
    messages_ = read_dbc({database.begin(), database.end()});
    if (image::Image::open(bytes_, image_) != image::Status::ok) {
        throw std::runtime_error(path + ": the image is refused");
    }
    plant_ = std::make_unique<simulation::Plant>(image_);
    node_ = std::make_unique<simulation::MasterNode>(plant_->can2(), configuration().node_id, second);
}

const DbcMessage& RunningPlant::message(const config::Pdo& pdo) const {
    return messages_.at("GW" + std::to_string(configuration().node_id) + "_" + pdo.name());
}

void RunningPlant::start() {
    if (configuration().heartbeat_consumer.effective_us != 0) {
        node_->produce(
            canopen::heartbeat_frame(configuration().partner_node_id, canopen::NmtState::operational),
            configuration().heartbeat_consumer.effective_us / 2);
    }
    for (const config::Pdo& pdo : configuration().pdos) {
        if (pdo.active && pdo.direction == config::Direction::receive) {
            send(message(pdo), {});
        }
    }
    start_alone();
}

void RunningPlant::start_alone() {
    run_for(second);
    node_->master().command(canopen::NmtCommand::start, configuration().node_id);
    run_for(second / 100);
}

void RunningPlant::send(const DbcMessage& message, const frame::Frame& frame) {
    frame::Frame sent = frame;
    sent.id = message.id;
    sent.length = static_cast<std::uint8_t>(message.length);
    node_->produce(sent, period);
}

}  // namespace cgw::test
