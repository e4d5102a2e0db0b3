// Many parameter files in one call.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "driver/check_file.hpp"

namespace cgw::driver {

// check_file_or_catalogue() for each path, on up to `threads` threads (0 counts as 1); `take` gets the
// results on the calling thread in the order of the paths. Only a few results wait for their turn, whatever
// the number of paths. What a check or `take` throws ends the work and comes out here.
void check_files(std::span<const std::string> paths, unsigned threads,
                 const std::function<void(CheckedFile&&)>& take);

}  // namespace cgw::driver
