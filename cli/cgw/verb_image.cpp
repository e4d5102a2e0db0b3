#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "image/image.hpp"

namespace cgw::cli {
namespace {

int image_inspect(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const LoadedImage loaded = load_image(find_one_in_file(arguments, path, place_of(arguments)));
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    const std::string text = arguments.given("--json") ? image_as_json(path, loaded.image)
                                                       : image_for_people(loaded.found.name, loaded.image);
    warn_about_model(loaded.found.name, loaded.image);
    return print(text) ? exit_fine : exit_environment;
}

constexpr Option inspect_options[] = {
    image_option,
    {.names = "--json", .summary = "as one JSON document"},
    firmware_section_option,
    firmware_address_option,
    color_option,
};

}  // namespace

const Verb image_inspect_verb = {"image inspect", "show what an image holds", inspect_options, image_inspect};

}  // namespace cgw::cli
