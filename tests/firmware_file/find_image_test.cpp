#include "firmware_file/find_image.hpp"

#include <gtest/gtest.h>

#include "diagnostic/rules/firmware.hpp"
#include "elf_builder.hpp"
#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"
#include "text.hpp"

namespace cgw::firmware_file {
namespace {

FirmwareFile hex_with(const Memory& memory) {
    IntelHex file;
    file.memory = memory;
    return *FirmwareFile::read(base::to_bytes(write_intel_hex(file)));
}

std::vector<std::uint64_t> places(const Outcome<std::vector<Area>>& found) {
    std::vector<std::uint64_t> addresses;
    for (const Area& area : *found) {
        addresses.push_back(area.address);
    }
    return addresses;
}

using Addresses = std::vector<std::uint64_t>;

TEST(ImagesInFirmware, are_found_wherever_they_stand) {
    const base::Bytes image = test::SamplePlant().image(false);
    Memory memory(0x1000, base::Bytes(0x33, 0x4B));
    memory.put(0x1033, image);
    memory.put(0x8000, image);
    const FirmwareFile file = hex_with(memory);
    const Outcome<std::vector<Area>> found = find_images(file);
    EXPECT_EQ(places(found), (Addresses{0x1033, 0x8000}));
    EXPECT_TRUE(
        std::equal(image.begin(), image.end(), found->front().bytes.begin(), found->front().bytes.end()));
}

TEST(ImagesInFirmware, are_found_when_they_are_damaged_or_cut) {
    const base::Bytes image = test::SamplePlant().image(false);
    const FirmwareFile damaged = hex_with(Memory(0x1000, test::flipped(image, 2000)));
    EXPECT_EQ(places(find_images(damaged)), Addresses{0x1000});
    const FirmwareFile cut = hex_with(Memory(0x1000, std::span(image).first(image.size() - 1)));
    const Outcome<std::vector<Area>> found = find_images(cut);
    EXPECT_EQ(places(found), Addresses{0x1000});
    EXPECT_EQ(found->front().bytes.size(), image.size() - 1);
}

// A boot loader compares with the letters that an image begins with.
TEST(ImagesInFirmware, are_not_seen_in_the_letters_that_one_begins_with) {
    const base::Bytes image = test::SamplePlant().image(false);
    base::Bytes letters(image.begin(), image.begin() + 4);
    for (const std::uint8_t rest :
         {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{0x40}, std::uint8_t{0xFF}}) {
        letters.resize(4);
        letters.resize(100, rest);
        EXPECT_TRUE(find_images(hex_with(Memory(0x1000, letters)))->empty()) << int{rest};
    }
    const FirmwareFile begun = hex_with(Memory(0x1000, std::span(image).first(63)));
    EXPECT_TRUE(find_images(begun)->empty());
    const FirmwareFile other = hex_with(Memory(0x1000, base::to_bytes("CGWI is how it begins")));
    EXPECT_TRUE(find_images(other)->empty());
}

TEST(ImagesInFirmware, are_not_searched_for_without_end) {
    base::Bytes header = test::SamplePlant().image(false);
    header.resize(80);
    wire::store_u32(&header[image::header::total_size], 70);
    Memory memory;
    for (std::uint64_t i = 0; i < 65; ++i) {
        memory.append(0x1000 * i, header);
    }
    const Outcome<std::vector<Area>> found = find_images(hex_with(memory));
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().message, "more than 64 places look like an image");
}

TEST(ImagesInFirmware, are_taken_from_a_section_or_an_address) {
    base::Bytes bytes = test::ElfBuilder().build();
    const base::Bytes image = test::SamplePlant().image(false);
    std::copy(image.begin(), image.end(), bytes.begin() + 0x300);
    const FirmwareFile file = *FirmwareFile::read(bytes);
    for (const Target& target : {Target{".cgw_config", 0}, Target{"", test::ElfBuilder::config}}) {
        const Outcome<Area> there = image_at(file, target);
        ASSERT_TRUE(there);
        EXPECT_EQ(there->address, test::ElfBuilder::config);
        EXPECT_EQ(there->bytes.size(), image.size());
    }
    EXPECT_EQ(image_at(file, {"", 0x08000000})->bytes.size(), 0x1000U);
    const FirmwareFile erased = hex_with(Memory(0x1000, base::Bytes(8192, 0xFF)));
    EXPECT_TRUE(image_at(erased, {"", 0x1000})->bytes.empty());
    EXPECT_EQ(image_at(file, {"", 0x08001000}).error().message, "the file has nothing at 0x08001000");
    EXPECT_EQ(image_at(file, {".bss", 0}).error().rule, &diagnostic::rules::firmware_section);
}

}  // namespace
}  // namespace cgw::firmware_file
