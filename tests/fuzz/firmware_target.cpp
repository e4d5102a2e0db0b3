// A firmware file that is read comes back as it was, and an image put into it changes nothing else.
#include <map>
#include <set>

#include "firmware_file/embed.hpp"
#include "fuzz/fuzz.hpp"
#include "support/sample_plant.hpp"

namespace cgw::fuzz {
namespace {

using firmware_file::Area;
using firmware_file::FirmwareFile;
using firmware_file::Kind;

const image::Image& sample_image() {
    static const base::Bytes bytes = test::SamplePlant().image(false);
    static const image::Image image = [] {
        image::Image opened;
        demand(image::Image::open(bytes, opened) == image::Status::ok, "the sample image is accepted");
        return opened;
    }();
    return image;
}

// What stands where. Of an ELF program areas may lie over each other: the pair keeps them apart.
using Contents = std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint8_t>;

Contents contents_of(const FirmwareFile& file) {
    Contents contents;
    std::uint64_t number = 0;
    for (const Area& area : file.areas()) {
        const std::uint64_t layer = file.kind() == Kind::elf ? number : 0;
        for (std::size_t i = 0; i < area.bytes.size(); ++i) {
            contents[{layer, area.address + i}] = area.bytes[i];
        }
        ++number;
    }
    return contents;
}

Contents without(const Contents& contents, std::uint64_t begin, std::uint64_t end) {
    Contents rest;
    for (const auto& [place, byte] : contents) {
        if (place.second < begin || place.second >= end) {
            rest.emplace_hint(rest.end(), place, byte);
        }
    }
    return rest;
}

void demand_embeds(Input input, const FirmwareFile& file, const firmware_file::EmbedOptions& options) {
    const image::Image& image = sample_image();
    const auto embedded = embed(input, image, options);
    if (!embedded) {
        return;
    }
    const auto again = FirmwareFile::read(embedded->file);
    demand(again.has_value() && again->kind() == file.kind(), "the new file can be read");
    const auto area = again->from(embedded->address);
    demand(area.has_value() && area->bytes.size() >= image.bytes().size() &&
               std::equal(image.bytes().begin(), image.bytes().end(), area->bytes.begin()),
           "the image stands where it was put");
    const std::uint64_t end = embedded->address + embedded->size;
    demand(without(contents_of(file), embedded->address, end) ==
               without(contents_of(*again), embedded->address, end),
           "no byte changes outside");
    if (file.kind() == Kind::elf) {
        demand(embedded->file.size() == input.size(), "a program keeps its size");
    }
    const auto twice = embed(embedded->file, image, options);
    demand(twice.has_value() && twice->file == embedded->file, "put in twice it is the same");
}

// Where an image may have room: at each area and behind it, and at those that are there.
std::set<std::uint64_t> places_in(const FirmwareFile& file) {
    std::set<std::uint64_t> places{0x08000100};
    const auto areas = file.areas();
    for (std::size_t i = 0; i < areas.size() && i < 3; ++i) {
        places.insert(areas[i].address);
        places.insert((areas[i].end() + 7) / 8 * 8);
    }
    if (const auto images = find_images(file)) {
        for (std::size_t i = 0; i < images->size() && i < 2; ++i) {
            places.insert((*images)[i].address);
        }
    }
    return places;
}

}  // namespace

void firmware(Input input) {
    auto file = FirmwareFile::read(input);
    if (!file) {
        demand(!file.error().message.empty(), "a refusal says why");
        firmware_file::embed(input, sample_image(), {{".cgw_config", 0}});
        return;
    }
    const base::Bytes written = file->bytes();
    const auto again = FirmwareFile::read(written);
    demand(again.has_value() && again->bytes() == written, "a file written again stays as it is");
    demand(contents_of(*again) == contents_of(*file), "a file written again says the same");
    if (file->kind() == Kind::elf) {
        demand(std::equal(written.begin(), written.end(), input.begin(), input.end()),
               "a program is written as it was");
    }
    demand_embeds(input, *file, {{".cgw_config", 0}});
    for (const std::uint64_t place : places_in(*file)) {
        demand_embeds(input, *file, {{"", place}});
        image_at(*file, {"", place});
    }
}

}  // namespace cgw::fuzz
