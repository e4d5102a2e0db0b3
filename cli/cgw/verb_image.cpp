#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "image/image.hpp"

namespace cgw::cli {
namespace {

// The file's bytes and the view of them; `image` is meaningful when exit_code is exit_fine.
struct LoadedImage {
    base::Bytes bytes;
    image::Image image;
    int exit_code = exit_fine;
};

int refuse(const std::string& path, image::Status status) {
    std::fputs(fmt::format("{}: refused: {} (status {})\n", base::printable(path), image::to_text(status),
                           static_cast<unsigned>(status))
                   .c_str(),
               stderr);
    return exit_findings;
}

// Reading one byte more than an image may have is enough to see that it is too large.
LoadedImage load(const std::string& path) {
    LoadedImage loaded;
    const base::Result<std::string> read = base::read_file(path, image::maximum_size + 1);
    if (!read) {
        if (read.error().too_large) {
            loaded.exit_code = refuse(path, image::Status::too_large);
        } else {
            print_error(read.error().message);
            loaded.exit_code = exit_environment;
        }
        return loaded;
    }
    loaded.bytes = base::to_bytes(*read);
    const image::Status status = image::Image::open(loaded.bytes, loaded.image);
    if (status != image::Status::ok) {
        loaded.exit_code = refuse(path, status);
    }
    return loaded;
}

int image_verify(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const LoadedImage loaded = load(path);
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    return print(image_summary(base::printable(path), loaded.image) + "\n") ? exit_fine : exit_environment;
}

int image_inspect(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const LoadedImage loaded = load(path);
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    const std::string text = arguments.given("--json")
                                 ? image_as_json(path, loaded.image)
                                 : image_for_people(base::printable(path), loaded.image);
    return print(text) ? exit_fine : exit_environment;
}

constexpr Option image_option = {
    .names = "FILE", .summary = "configuration image", .required = true, .completes = Completes::files};

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
