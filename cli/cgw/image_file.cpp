#include "cli/cgw/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "authoring/from_image.hpp"
#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/terminal.hpp"
#include "image/area.hpp"
#include "wire/search.hpp"

namespace cgw::cli {
namespace {

using firmware_file::Area;
using firmware_file::FirmwareFile;
using firmware_file::Outcome;
using firmware_file::Target;

void say(std::string_view name, std::string_view what) {
    std::fputs(fmt::format("{}: {}\n", name, what).c_str(), stderr);
}

// "", " 0xFF" or " 0x00".
std::string_view filling_of(std::span<const std::uint8_t> bytes) {
    return wire::all_are(bytes, 0xFF) ? " 0xFF" : wire::all_are(bytes, 0x00) ? " 0x00" : "";
}

// As a gateway sees the region: the image at its beginning, and nothing behind it counts.
FoundImage image_of_region(const std::string& path, const base::Bytes& content) {
    const std::span<const std::uint8_t> judged = image::image_in(content);
    FoundImage found{base::printable(path), {judged.begin(), judged.end()}, {}};
    if (judged.empty() && !content.empty()) {
        found.erased = fmt::format("erased, all {} bytes are{}", content.size(), filling_of(content));
    }
    const std::size_t stated = image::stated_image(content).size();
    if (stated != 0 && stated < content.size()) {
        const auto rest = std::span(content).subspan(stated);
        const std::string_view filling = filling_of(rest);
        say(found.name,
            filling.empty()
                ? fmt::format("{} bytes behind the image are not judged; they are no filling", rest.size())
                : fmt::format("{} bytes behind the image, all{}", rest.size(), filling));
    }
    return found;
}

Outcome<std::vector<Area>> areas_of(const FirmwareFile& file, const std::optional<Target>& target) {
    if (!target) {
        return find_images(file);
    }
    const Outcome<Area> there = image_at(file, *target);
    if (!there) {
        return tl::unexpected(there.error());
    }
    return std::vector<Area>{*there};
}

FoundImages images_of_firmware(const Arguments& arguments, const std::string& path,
                               const base::Bytes& content, const std::optional<Target>& target) {
    FoundImages found;
    found.in_firmware = true;
    const Outcome<FirmwareFile> file = FirmwareFile::read(content);
    if (!file) {
        found.exit_code = report_refusal(arguments, path, content, file.error());
        return found;
    }
    const Outcome<std::vector<Area>> areas = areas_of(*file, target);
    if (!areas) {
        found.exit_code = report_refusal(arguments, path, content, areas.error());
        return found;
    }
    for (const Area& area : *areas) {
        found.images.push_back({place_text(path, area.address),
                                {area.bytes.begin(), area.bytes.end()},
                                area.bytes.empty() ? "erased, all bytes are 0xFF or 0x00" : ""});
    }
    if (areas->empty()) {
        say(base::printable(path),
            fmt::format("refused: no configuration image is in this {} file", to_text(file->kind())));
        found.exit_code = exit_findings;
    }
    return found;
}

}  // namespace

FoundImages find_in_file(const Arguments& arguments, const std::string& path,
                         const std::optional<Target>& target, bool any_kind) {
    const base::Result<std::string> read = base::read_file(path, largest_firmware_file);
    if (!read) {
        if (read.error().too_large) {
            return {{}, refuse_image({base::printable(path), {}, {}}, image::Status::too_large)};
        }
        print_error(read.error().message);
        return {{}, exit_environment};
    }
    const base::Bytes content = base::to_bytes(*read);
    if (firmware_file::kind_of(content) || (target && !any_kind)) {
        return images_of_firmware(arguments, path, content, target);
    }
    return {{image_of_region(path, content)}};
}

FoundImages find_one_in_file(const Arguments& arguments, const std::string& path,
                             const std::optional<Target>& target, bool any_kind) {
    FoundImages found = find_in_file(arguments, path, target, any_kind);
    if (found.images.size() > 1) {
        for (const FoundImage& image : found.images) {
            say(image.name, "an image");
        }
        say(base::printable(path),
            fmt::format("refused: {} images are in it; say with --section or --address which one is meant",
                        found.images.size()));
        found.exit_code = exit_findings;
    }
    return found;
}

LoadedImage load_image(FoundImages found) {
    LoadedImage loaded;
    loaded.exit_code = found.exit_code;
    loaded.in_firmware = found.in_firmware;
    if (found.exit_code == exit_fine) {
        loaded.found = std::move(found.images.front());
        const image::Status status = image::Image::open(loaded.found.bytes, loaded.image);
        loaded.exit_code = status == image::Status::ok ? exit_fine : refuse_image(loaded.found, status);
    }
    return loaded;
}

int refuse_image(const FoundImage& found, image::Status status) {
    say(found.name,
        fmt::format("refused: {} (status {})", found.erased.empty() ? to_text(status) : found.erased,
                    static_cast<unsigned>(status)));
    return exit_findings;
}

void warn_about_model(const std::string& name, const image::Image& image) {
    if (!authoring::model_fits(image)) {
        say(name,
            "warning: the configuration id is not that of the model in the image; one of the two is not this "
            "plant's, and a gateway does not look");
    }
}

}  // namespace cgw::cli
