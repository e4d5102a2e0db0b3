// The plant of a parameter file as the room `traffic` wants it.
#pragma once

#include "driver/check_file.hpp"
#include "emit/emitter.hpp"
#include "traffic/subject.hpp"

namespace cgw::driver {

// `plant` is that of the file, which is valid(); its dictionary must outlive the subject.
traffic::Subject traffic_subject(const CheckedFile& file, const emit::Plant& plant);

}  // namespace cgw::driver
