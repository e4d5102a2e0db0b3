#include <fmt/format.h>

#include <cstdio>

#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "inspect/annotation.hpp"

namespace cgw::cli {
namespace {

constexpr Option annotate_options[] = {
    image_option,
    {.names = "--json", .summary = "as one JSON document"},
    firmware_section_option,
    firmware_address_option,
    color_option,
};

constexpr std::string_view annotate_details =
    "One line for each field: offset, bytes, type, name, value and what it means. A\n"
    "damaged image is followed as far as sense can be made of it: lines that begin\n"
    "with ! show where it breaks, and the exit code is 1, as with cgw image verify.\n";

int image_annotate(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const FoundImages all = find_one_in_file(arguments, path, place_of(arguments));
    if (all.exit_code != exit_fine) {
        return all.exit_code;
    }
    const FoundImage& found = all.images.front();
    const inspect::Annotation annotation = inspect::annotate(found.bytes);
    const std::string text = arguments.given("--json")
                                 ? inspect::annotation_json(annotation, found.bytes, path)
                                 : inspect::annotation_text(annotation, found.bytes, found.name);
    if (!print(text)) {
        return exit_environment;
    }
    if (annotation.status == image::Status::ok && !annotation.model_fits) {
        print_error(found.name + ": the configuration id is not that of the model in the image");
        return exit_findings;
    }
    if (annotation.status == image::Status::ok) {
        return exit_fine;
    }
    const int exit_code = refuse_image(found, annotation.status);
    if (annotation.status_beyond_crc != image::Status::ok) {
        std::fputs(fmt::format("{}: with a right CRC-32 also refused: {} (status {})\n", found.name,
                               image::to_text(annotation.status_beyond_crc),
                               static_cast<unsigned>(annotation.status_beyond_crc))
                       .c_str(),
                   stderr);
    }
    return exit_code;
}

}  // namespace

const Verb image_annotate_verb = {"image annotate", "tell an image field by field, sound or damaged",
                                  annotate_options, image_annotate, annotate_details};

}  // namespace cgw::cli
