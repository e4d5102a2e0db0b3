#include "running_plant.hpp"

#include <span>
#include <stdexcept>

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
    node_ = std::make_unique<simulation::MasterNode>(plant_->bus(), configuration().node_id, second);
}

const DbcMessage& RunningPlant::message(const config::Pdo& pdo) const {
    return messages_.at("GW" + std::to_string(configuration().node_id) + "_" + pdo.name());
}

void RunningPlant::start() {
    run_for(second);
    node_->master().command(canopen::NmtCommand::start, configuration().node_id);
    run_for(second / 100);
}

void RunningPlant::send(const DbcMessage& message, const frame::Frame& frame) {
    node_->master().send_process_data(static_cast<std::uint16_t>(message.id),
                                      std::span(frame.data).first(message.length));
}

}  // namespace cgw::test
