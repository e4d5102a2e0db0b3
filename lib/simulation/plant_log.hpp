// The frames of both buses of a plant, kept until the run is over and then written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "media/log.hpp"
#include "simulation/plant.hpp"

namespace cgw::simulation {

class PlantLog {
  public:
    static constexpr std::size_t most_frames = 5'000'000;  // some 500 MB while the plant runs

    // Listens from now on; outlives the plant's running.
    explicit PlantLog(Plant& plant);
    PlantLog(const PlantLog&) = delete;
    PlantLog& operator=(const PlantLog&) = delete;
    ~PlantLog() = default;

    std::size_t frames() const { return frames_.size(); }
    std::uint64_t left_out() const { return left_out_; }  // beyond `most_frames`

    base::Result<void> write(const std::string& path, media::LogFormat format) const;

  private:
    void record(Bus& bus, const char* name);

    std::vector<media::LoggedFrame> frames_;
    std::uint64_t left_out_ = 0;
};

}  // namespace cgw::simulation
