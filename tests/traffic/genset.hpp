// The plant of samples/genset.toml, for frames of node 12.
#pragma once

#include <string>
#include <vector>

#include "driver/plant.hpp"
#include "driver/traffic_subject.hpp"
#include "support/recording_port.hpp"
#include "traffic/audit.hpp"
#include "traffic/decoder.hpp"

namespace cgw::test {

struct Genset {
    driver::CheckedFile file = driver::check_file(CGW_SAMPLES "/genset.toml");
    driver::Plant plant = *driver::Plant::make(file);
    emit::Plant view = plant.view();
    traffic::Subject subject = driver::traffic_subject(file, view);
};

inline const Genset& genset() {
    static const Genset plant;
    return plant;
}

}  // namespace cgw::test
