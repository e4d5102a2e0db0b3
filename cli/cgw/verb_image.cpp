#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "image/image.hpp"

namespace cgw::cli {
namespace {

int image_verify(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const LoadedImage loaded = load_image(path);
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    return print(image_summary(base::printable(path), loaded.image) + "\n") ? exit_fine : exit_environment;
}

int image_inspect(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const LoadedImage loaded = load_image(path);
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    const std::string text = arguments.given("--json")
                                 ? image_as_json(path, loaded.image)
                                 : image_for_people(base::printable(path), loaded.image);
    return print(text) ? exit_fine : exit_environment;
}

constexpr Option verify_options[] = {image_option};

constexpr Option inspect_options[] = {
    image_option,
    {.names = "--json", .summary = "as one JSON document"},
};

}  // namespace

const Verb image_verify_verb = {"image verify", "say whether the gateway would take an image", verify_options,
                                image_verify};

const Verb image_inspect_verb = {"image inspect", "show what an image holds", inspect_options, image_inspect};

}  // namespace cgw::cli
