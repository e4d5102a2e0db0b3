// Configuration images from a path, for the verbs of `cgw image`: from a file of their own, from a region
// that was read out of a device, or from a firmware file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/bytes.hpp"
#include "cli/cgw/command.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "firmware_file/find_image.hpp"
#include "image/image.hpp"

namespace cgw::cli {

inline constexpr Option image_option = {.names = "FILE",
                                        .summary = "image, or a file with one in it; - is standard input",
                                        .required = true,
                                        .completes = Completes::files};

// What a gateway would judge: of a region the image alone, as image::image_in() gives it to the firmware.
struct FoundImage {
    std::string name;  // for people: the path, and the address in a firmware file
    base::Bytes bytes;
    std::string erased;  // why there are no bytes; "" for anything but an erased region
};

// What is wrong has been said on stderr when exit_code is not exit_fine.
struct FoundImages {
    std::vector<FoundImage> images;  // one at least when exit_code is exit_fine
    int exit_code = exit_fine;
    bool in_firmware = false;  // the file is a firmware file
};

// `target` says where in a firmware file; without one all images in it are found. A file of another kind is
// taken as one image, or the region of one: what stands behind the image is told on stderr. With a `target`
// such a file is refused unless `any_kind`.
FoundImages find_in_file(const Arguments& arguments, const std::string& path,
                         const std::optional<firmware_file::Target>& target, bool any_kind = false);

// The same, where a verb takes a single image: several in one firmware file are refused.
FoundImages find_one_in_file(const Arguments& arguments, const std::string& path,
                             const std::optional<firmware_file::Target>& target, bool any_kind = false);

// The view of the first image found; meaningful when exit_code is exit_fine.
struct LoadedImage {
    FoundImage found;
    image::Image image;
    int exit_code = exit_fine;
    bool in_firmware = false;
};
LoadedImage load_image(FoundImages found);

// Says on stderr that and why the image is refused, with the number that firmware shows; returns
// exit_findings.
int refuse_image(const FoundImage& found, image::Status status);

// Says on stderr when the model is not that of the configuration id. A gateway does not look.
void warn_about_model(const std::string& name, const image::Image& image);

}  // namespace cgw::cli
