// A configuration image from its path, for the verbs of `cgw image`.
#pragma once

#include <string>

#include "base/bytes.hpp"
#include "cli/cgw/command.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "image/image.hpp"

namespace cgw::cli {

inline constexpr Option image_option = {
    .names = "FILE", .summary = "configuration image", .required = true, .completes = Completes::files};

// The file's bytes, whatever they are; a file that is larger than any image counts as refused. What is wrong
// has been said on stderr when exit_code is not exit_fine.
struct ImageBytes {
    base::Bytes bytes;
    int exit_code = exit_fine;
};
ImageBytes read_image(const std::string& path);

// The file's bytes and the view of them; `image` is meaningful when exit_code is exit_fine.
struct LoadedImage {
    base::Bytes bytes;
    image::Image image;
    int exit_code = exit_fine;
};
LoadedImage load_image(const std::string& path);

// Says on stderr that and why the image is refused, with the number that firmware shows; returns
// exit_findings.
int refuse_image(const std::string& path, image::Status status);

}  // namespace cgw::cli
