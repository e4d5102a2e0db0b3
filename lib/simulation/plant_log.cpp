#include "simulation/plant_log.hpp"

#include "base/files.hpp"

namespace cgw::simulation {

PlantLog::PlantLog(Plant& plant) {
    record(plant.can1(), "can1");
    record(plant.can2(), "can2");
}

void PlantLog::record(Bus& bus, const char* name) {
    bus.observe([this, name](const frame::Frame& frame, Time now) {
        if (frames_.size() < most_frames) {
            frames_.push_back({now, name, frame});
        } else {
            ++left_out_;
        }
    });
}

base::Result<void> PlantLog::write(const std::string& path, media::LogFormat format) const {
    const base::Result<base::Bytes> content = media::write_log(format, frames_);
    return content ? base::write_file(path, *content) : tl::unexpected(content.error());
}

}  // namespace cgw::simulation
