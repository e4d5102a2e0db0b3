// `cgw image verify` and `cgw image inspect`; docs/image-format.md. Each returns the exit code.
#pragma once

#include <string>

namespace cgw::cli {

// One line that says the image is valid, on stdout; or why the gateway would refuse it, on stderr.
int image_verify(const std::string& path);

// What the image holds, for people (at most 80 columns) or as one JSON document.
int image_inspect(const std::string& path, bool json);

}  // namespace cgw::cli
