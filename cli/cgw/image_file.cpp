#include "cli/cgw/image_file.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/terminal.hpp"

namespace cgw::cli {

int refuse_image(const std::string& path, image::Status status) {
    std::fputs(fmt::format("{}: refused: {} (status {})\n", base::printable(path), image::to_text(status),
                           static_cast<unsigned>(status))
                   .c_str(),
               stderr);
    return exit_findings;
}

// Reading one byte more than an image may have is enough to see that it is too large.
ImageBytes read_image(const std::string& path) {
    const base::Result<std::string> read = base::read_file(path, image::maximum_size + 1);
    if (read) {
        return {base::to_bytes(*read)};
    }
    if (read.error().too_large) {
        return {{}, refuse_image(path, image::Status::too_large)};
    }
    print_error(read.error().message);
    return {{}, exit_environment};
}

LoadedImage load_image(const std::string& path) {
    LoadedImage loaded;
    ImageBytes read = read_image(path);
    loaded.exit_code = read.exit_code;
    loaded.bytes = std::move(read.bytes);
    if (loaded.exit_code == exit_fine) {
        const image::Status status = image::Image::open(loaded.bytes, loaded.image);
        loaded.exit_code = status == image::Status::ok ? exit_fine : refuse_image(path, status);
    }
    return loaded;
}

}  // namespace cgw::cli
