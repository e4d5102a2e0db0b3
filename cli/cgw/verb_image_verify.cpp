#include <fmt/format.h>

#include <cstdio>

#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "diagnostic/rules.hpp"
#include "firmware_file/find_image.hpp"

namespace cgw::cli {
namespace {

using firmware_file::Area;
using firmware_file::FirmwareFile;
using firmware_file::Outcome;

// `name` stands for the image in what is printed.
int verify_bytes(const std::string& name, std::span<const std::uint8_t> bytes) {
    image::Image image;
    if (const image::Status status = image::Image::open(bytes, image); status != image::Status::ok) {
        return refuse_image(name, status);
    }
    return print(image_summary(base::printable(name), image) + "\n") ? exit_fine : exit_environment;
}

Outcome<std::vector<Area>> images_in(const FirmwareFile& file, const Arguments& arguments) {
    if (!arguments.given("--section") && !arguments.given("--address")) {
        return find_images(file);
    }
    const Outcome<Area> there = image_at(file, target_of(arguments));
    if (!there) {
        return tl::unexpected(there.error());
    }
    return std::vector<Area>{*there};
}

int verify_firmware(const Arguments& arguments, const std::string& path, const base::Bytes& content) {
    const Outcome<FirmwareFile> file = FirmwareFile::read(content);
    if (!file) {
        return report_refusal(arguments, path, content, file.error());
    }
    const Outcome<std::vector<Area>> images = images_in(*file, arguments);
    if (!images) {
        return report_refusal(arguments, path, content, images.error());
    }
    if (images->empty()) {
        std::fputs(fmt::format("{}: refused: no configuration image is in this {} file\n",
                               base::printable(path), to_text(file->kind()))
                       .c_str(),
                   stderr);
        return exit_findings;
    }
    int exit_code = exit_fine;
    for (const Area& image : *images) {
        exit_code = worse(exit_code, verify_bytes(place_text(path, image.address), image.bytes));
    }
    return exit_code;
}

int image_verify(const Arguments& arguments) {
    target_of(arguments);
    const std::string path = arguments.value("FILE");
    const base::Result<std::string> read = base::read_file(path, largest_firmware_file);
    if (!read) {
        if (read.error().too_large) {
            return refuse_image(path, image::Status::too_large);
        }
        print_error(read.error().message);
        return exit_environment;
    }
    const base::Bytes content = base::to_bytes(*read);
    const bool placed = arguments.given("--section") || arguments.given("--address");
    return placed || firmware_file::kind_of(content) ? verify_firmware(arguments, path, content)
                                                     : verify_bytes(path, content);
}

constexpr Option verify_options[] = {
    {.names = "FILE",
     .summary = "configuration image, or a firmware file with images in it",
     .required = true,
     .completes = Completes::files},
    firmware_section_option,
    firmware_address_option,
    color_option,
};

}  // namespace

const Verb image_verify_verb = {
    "image verify", "say whether the gateway would take an image", verify_options, image_verify,
    "A firmware file is an ELF program, an Intel HEX or an S-record file. Without\n"
    "--section and --address all images in it are found and verified.\n"};

}  // namespace cgw::cli
