#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"

namespace cgw::cli {
namespace {

int verify_one(const FoundImage& found) {
    image::Image image;
    if (const image::Status status = image::Image::open(found.bytes, image); status != image::Status::ok) {
        return refuse_image(found, status);
    }
    if (!print(image_summary(found.name, image) + "\n")) {
        return exit_environment;
    }
    warn_about_model(found.name, image);
    return exit_fine;
}

int image_verify(const Arguments& arguments) {
    const FoundImages found = find_in_file(arguments, arguments.value("FILE"), place_of(arguments));
    int exit_code = found.exit_code;
    for (const FoundImage& image : found.images) {
        exit_code = worse(exit_code, verify_one(image));
    }
    return exit_code;
}

constexpr Option verify_options[] = {
    image_option,
    firmware_section_option,
    firmware_address_option,
    color_option,
};

}  // namespace

const Verb image_verify_verb = {
    "image verify", "say whether the gateway would take an image", verify_options, image_verify,
    "FILE is an image, a region that was read out of a device, or a firmware file: an\n"
    "ELF program, Intel HEX or S-record file. Without --section and --address all\n"
    "images in a firmware file are found and verified.\n"};

}  // namespace cgw::cli
