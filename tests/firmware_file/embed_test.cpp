#include "firmware_file/embed.hpp"

#include <gtest/gtest.h>

#include "elf_builder.hpp"
#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"
#include "text.hpp"

namespace cgw::firmware_file {
namespace {

using test::ElfBuilder;

constexpr ElfBuilder kinds[] = {{false, false}, {true, false}, {false, true}, {true, true}};
constexpr std::uint64_t place = 0x08000100;

// The image of a plant, with and without labels: a longer and a shorter one.
struct Sample {
    explicit Sample(bool labels = true) : bytes(test::SamplePlant().image(labels)) {
        EXPECT_EQ(image::Image::open(bytes, image), image::Status::ok);
    }
    base::Bytes bytes;
    image::Image image;
};

// Code up to the place, nothing behind it.
IntelHex hex_file() {
    IntelHex file;
    file.memory = Memory(0x08000000, base::Bytes(0x100, 0x4B));
    file.start_linear = StartRecord{.start = 0x080000ED, .address = 0};
    file.end_address = 0x100;
    return file;
}
base::Bytes bytes_of(const IntelHex& file) {
    return base::to_bytes(write_intel_hex(file));
}

std::string why(const Outcome<Embedded>& outcome) {
    return outcome ? "" : fmt::format("{}: {}", outcome.error().rule->name, outcome.error().message);
}

EmbedOptions at(std::uint64_t address, std::uint8_t fill = 0xFF) {
    return {{"", address}, 8, fill};
}
EmbedOptions in(const std::string& section, std::uint8_t fill = 0xFF) {
    return {{section, 0}, 8, fill};
}

TEST(EmbedIntoHex, adds_the_image_and_keeps_everything_else) {
    const Sample sample;
    const Outcome<Embedded> embedded = embed(bytes_of(hex_file()), sample.image, at(place));
    ASSERT_EQ(why(embedded), "");
    EXPECT_EQ(embedded->replaced, Replaced::nothing);
    EXPECT_EQ(embedded->address, place);
    EXPECT_EQ(embedded->size, sample.bytes.size());
    IntelHex wanted = hex_file();
    wanted.memory.put(place, sample.bytes);
    EXPECT_EQ(embedded->file, bytes_of(wanted));
}

TEST(EmbedIntoHex, replaces_an_earlier_image_and_fills_what_is_left_of_it) {
    const Sample longer(true);
    const Sample shorter(false);
    ASSERT_GT(longer.bytes.size(), shorter.bytes.size());
    const Outcome<Embedded> first = embed(bytes_of(hex_file()), longer.image, at(place));
    const Outcome<Embedded> second = embed(first->file, shorter.image, at(place));
    ASSERT_EQ(why(second), "");
    EXPECT_EQ(second->replaced, Replaced::image);
    EXPECT_EQ(second->replaced_id, "a0a1a2a3a4a5a6a7");
    EXPECT_EQ(second->size, longer.bytes.size());
    const FirmwareFile file = *FirmwareFile::read(second->file);
    const Area area = *file.from(place);
    ASSERT_EQ(area.bytes.size(), longer.bytes.size());
    for (std::size_t i = shorter.bytes.size(); i < longer.bytes.size(); ++i) {
        EXPECT_EQ(area.bytes[i], 0xFF);
    }
    EXPECT_EQ(embed(second->file, longer.image, at(place))->file, first->file);  // the filling is free again
}

TEST(EmbedIntoHex, takes_a_filled_area_and_refuses_data) {
    const Sample sample;
    IntelHex file = hex_file();
    file.memory.put(place, base::Bytes(64, 0xFF));
    EXPECT_EQ(embed(bytes_of(file), sample.image, at(place))->replaced, Replaced::reserved);
    EXPECT_EQ(
        why(embed(bytes_of(file), sample.image, at(place, 0x00))),
        "image-occupied: the byte at 0x08000100 is 0xFF: the area is not free, and no image stands there");
    const std::uint64_t last = place + sample.bytes.size() - 1;
    file.memory.put(last, base::Bytes{0xFF, 0x12});
    EXPECT_EQ(why(embed(bytes_of(file), sample.image, at(place))), "");
    file.memory.put(last, base::Bytes{0xFE});
    EXPECT_EQ(
        why(embed(bytes_of(file), sample.image, at(place))),
        fmt::format("image-occupied: the byte at {} is 0xFE: the area is not free, and no image stands there",
                    address_text(last)));
    EXPECT_EQ(
        why(embed(bytes_of(hex_file()), sample.image, at(0x080000F8))),
        "image-occupied: the byte at 0x080000F8 is 0x4B: the area is not free, and no image stands there");
}

TEST(EmbedIntoHex, refuses_to_replace_a_damaged_image_or_to_begin_within_one) {
    const Sample sample;
    const Outcome<Embedded> first = embed(bytes_of(hex_file()), sample.image, at(place));
    EXPECT_EQ(
        why(embed(first->file, sample.image, at(place + 8))),
        "image-occupied: the byte at 0x08000108 is 0x40: the area is not free, and no image stands there");
    IntelHex damaged = hex_file();
    damaged.memory.put(place, test::flipped(sample.bytes, 1000));
    EXPECT_EQ(why(embed(bytes_of(damaged), sample.image, at(place))),
              "image-occupied: the image at 0x08000100 is damaged: its CRC-32 does not fit");
}

TEST(EmbedIntoHex, replaces_an_image_of_another_format_version) {
    const Sample sample;
    base::Bytes foreign = sample.bytes;
    foreign[image::header::format_major] = 9;
    test::sign(foreign);
    IntelHex file = hex_file();
    file.memory.put(place, foreign);
    EXPECT_EQ(embed(bytes_of(file), sample.image, at(place))->replaced, Replaced::image);
}

TEST(EmbedIntoHex, refuses_a_new_place_beside_an_image_unless_told) {
    const Sample sample;
    const Outcome<Embedded> first = embed(bytes_of(hex_file()), sample.image, at(place));
    EmbedOptions elsewhere = at(place + 0x10000);
    const Outcome<Embedded> refused = embed(first->file, sample.image, elsewhere);
    EXPECT_EQ(
        why(refused),
        "image-elsewhere: an image stands at 0x08000100 already, configuration id a0a1a2a3a4a5a6a7, and "
        "none at 0x08010100");
    elsewhere.beside = true;
    const Outcome<Embedded> second = embed(first->file, sample.image, elsewhere);
    ASSERT_EQ(why(second), "");
    EXPECT_EQ(find_images(*FirmwareFile::read(second->file))->size(), 2U);
    EXPECT_EQ(why(embed(second->file, sample.image, at(place))), "");  // each of them can be replaced
    EXPECT_EQ(why(embed(second->file, sample.image, at(place + 0x10000))), "");
}

TEST(EmbedIntoHex, is_not_kept_from_a_new_place_by_a_damaged_image) {
    const Sample sample;
    IntelHex file = hex_file();
    file.memory.put(place, test::flipped(sample.bytes, 1000));
    EXPECT_EQ(why(embed(bytes_of(file), sample.image, at(place + 0x10000))), "");
}

TEST(EmbedIntoHex, refuses_odd_places) {
    const Sample sample;
    const base::Bytes file = bytes_of(hex_file());
    EXPECT_EQ(why(embed(file, sample.image, at(place + 4))),
              "image-alignment: 0x08000104, where the image would begin, is no multiple of 8");
    EmbedOptions options = at(place + 4);
    options.alignment = 4;
    EXPECT_EQ(why(embed(file, sample.image, options)), "");
    EXPECT_EQ(why(embed(file, sample.image, at(0xFFFFFFF8))),
              "firmware-address: at 0xFFFFFFF8 the image would end beyond 32 bits");
    EXPECT_EQ(why(embed(file, sample.image, at(std::uint64_t{1} << 62U))),
              "firmware-address: at 0x4000000000000000 the image would end beyond 32 bits");
    EXPECT_EQ(why(embed(file, sample.image, in(".cgw_config"))),
              "firmware-section: an Intel HEX file has no sections");
    EXPECT_EQ(why(embed(base::to_bytes("hello"), sample.image, at(place))),
              "firmware-kind: this is neither an ELF program nor an Intel HEX or S-record file");
    EXPECT_EQ(why(embed({}, sample.image, at(place))),
              "firmware-kind: this is neither an ELF program nor an Intel HEX or S-record file");
    base::Bytes large(largest_record_file + 1, '\n');
    large[0] = ':';
    EXPECT_EQ(why(embed(large, sample.image, at(place))),
              "firmware-kind: the Intel HEX file has 67108865 bytes; more than 64 MiB are not read");
}

TEST(EmbedIntoSRecord, adds_the_image_and_keeps_header_start_and_count) {
    const Sample sample;
    SRecord file;
    file.memory = Memory(0x08000000, base::Bytes(0x100, 0x4B));
    file.headers = {{0, base::to_bytes("firmware")}, {7, {}}};
    file.start = 0x080000ED;
    file.counted = true;
    const Outcome<Embedded> embedded = embed(base::to_bytes(write_s_record(file)), sample.image, at(place));
    ASSERT_EQ(why(embedded), "");
    file.memory.put(place, sample.bytes);
    EXPECT_EQ(embedded->file, base::to_bytes(write_s_record(file)));
}

TEST(EmbedIntoElf, fills_the_section_in_both_classes_and_byte_orders) {
    const Sample sample(false);
    for (const ElfBuilder& kind : kinds) {
        for (const std::uint8_t fill : {std::uint8_t{0xFF}, std::uint8_t{0}}) {
            base::Bytes wanted = kind.build();
            const Outcome<Embedded> embedded = embed(wanted, sample.image, in(".cgw_config", fill));
            ASSERT_EQ(why(embedded), "") << kind.wide << kind.big;
            EXPECT_EQ(embedded->address, ElfBuilder::config);
            EXPECT_EQ(embedded->size, 0xF00U);
            EXPECT_EQ(embedded->replaced, Replaced::reserved);
            const auto section = wanted.begin() + 0x300;
            std::fill(section, section + 0xF00, fill);
            std::copy(sample.bytes.begin(), sample.bytes.end(), section);
            EXPECT_EQ(embedded->file, wanted);
            EXPECT_EQ(embed(wanted, sample.image, in(".cgw_config"))->replaced, Replaced::image);
        }
    }
}

TEST(EmbedIntoElf, at_an_address_changes_no_byte_behind_the_image) {
    const Sample sample(false);
    base::Bytes wanted = ElfBuilder().build();
    const Outcome<Embedded> embedded = embed(wanted, sample.image, at(0x08000180));
    ASSERT_EQ(why(embedded), "");
    std::copy(sample.bytes.begin(), sample.bytes.end(), wanted.begin() + 0x380);
    EXPECT_EQ(embedded->file, wanted);
}

TEST(EmbedIntoElf, refuses_what_is_too_small_used_or_not_loaded) {
    const Sample sample(false);
    const ElfBuilder builder;
    base::Bytes bytes = builder.build();
    const std::size_t size = sample.bytes.size();
    EXPECT_EQ(
        why(embed(bytes, sample.image, at(0x08000F00))),
        fmt::format("image-room: the segment has 256 bytes from 0x08000F00 on, the image needs {}", size));
    EXPECT_EQ(why(embed(bytes, sample.image, at(0x08001000))),
              "firmware-address: no loaded segment has contents at 0x08001000");
    EXPECT_EQ(why(embed(bytes, sample.image, at(0x08000000))), "firmware-section: section .text is code");
    const std::size_t section = builder.sections_offset() + 2 * builder.section_size();
    base::Bytes small = bytes;
    builder.set(small, section + 20, 0x100, 4);
    EXPECT_EQ(why(embed(small, sample.image, in(".cgw_config"))),
              fmt::format("image-room: section .cgw_config has 256 bytes, the image needs {}", size));
    base::Bytes odd = bytes;
    builder.set(odd, section + 12, ElfBuilder::config + 4, 4);
    builder.set(odd, section + 16, 0x304, 4);
    builder.set(odd, section + 20, 0xEFC, 4);
    EXPECT_EQ(why(embed(odd, sample.image, in(".cgw_config"))),
              "image-alignment: 0x08000104, where the image would begin, is no multiple of 8");
    bytes[0x300 + 0xEFF] = 7;
    EXPECT_EQ(
        why(embed(bytes, sample.image, in(".cgw_config"))),
        "image-occupied: the byte at 0x08000FFF is 0x07: the area is not free, and no image stands there");
    std::fill(bytes.begin() + 0x300, bytes.begin() + 0x1200, 0);
    EXPECT_EQ(why(embed(bytes, sample.image, in(".cgw_config"))), "");
}

TEST(EmbedIntoElf, refuses_writable_sections_code_and_what_belongs_to_several) {
    const Sample sample(false);
    const ElfBuilder builder;
    const base::Bytes good = builder.build();
    const std::size_t section = builder.sections_offset() + 2 * builder.section_size();
    const auto with_flags = [&](std::uint64_t flags, const EmbedOptions& options) {
        base::Bytes bytes = good;
        builder.set(bytes, section + 8, flags, 4);
        return why(embed(bytes, sample.image, options));
    };
    for (const EmbedOptions& options : {in(".cgw_config"), at(ElfBuilder::config)}) {
        EXPECT_EQ(with_flags(2, options), "");
        EXPECT_EQ(with_flags(3, options), "firmware-section: section .cgw_config is writable");
        EXPECT_EQ(with_flags(6, options), "firmware-section: section .cgw_config is code");
    }
    EXPECT_EQ(with_flags(0x802, at(ElfBuilder::config)),
              "firmware-section: section .cgw_config is compressed");
    EXPECT_EQ(with_flags(0, at(ElfBuilder::config)), "firmware-address: no section holds 0x08000100");
    base::Bytes twin = good;  // .twin in the middle of .cgw_config
    builder.set(twin, section + builder.section_size() + 16, 0x400, 4);
    EXPECT_EQ(why(embed(twin, sample.image, at(ElfBuilder::config))),
              "elf-structure: sections .cgw_config and .twin share bytes of the file");
}

TEST(EmbedIntoElf, says_all_that_is_demanded_of_a_section_whatever_is_wrong_with_it) {
    const Sample sample(false);
    const ElfBuilder builder;
    for (const std::uint64_t flags : {std::uint64_t{0}, std::uint64_t{3}, std::uint64_t{6}}) {
        base::Bytes bytes = builder.build();
        builder.set(bytes, builder.sections_offset() + 2 * builder.section_size() + 8, flags, 4);
        const Outcome<Embedded> refused = embed(bytes, sample.image, in(".cgw_config"));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().help,
                  "an image stands in read-only data that has contents and is loaded: a constant array, or "
                  "(READONLY) in the linker script");
    }
}

TEST(EmbedIntoElf, does_not_run_into_the_next_section) {
    const Sample sample(false);
    const ElfBuilder builder;
    base::Bytes bytes = builder.build();
    const std::size_t section = builder.sections_offset() + 2 * builder.section_size();
    builder.set(bytes, section + 20, 0x88, 4);
    EXPECT_EQ(
        why(embed(bytes, sample.image, at(ElfBuilder::config + 0x80))),
        fmt::format("image-room: section .cgw_config has 8 bytes from 0x08000180 on, the image needs {}",
                    sample.bytes.size()));
    EXPECT_EQ(why(embed(bytes, sample.image, at(ElfBuilder::config + 0x88))),
              "firmware-address: no section holds 0x08000188");
}

TEST(EmbedIntoElf, without_sections_takes_read_only_segments) {
    const Sample sample(false);
    const ElfBuilder builder;
    base::Bytes bytes = builder.build();
    builder.set(bytes, 32, 0, 4);
    builder.set(bytes, 48, 0, 2);
    EXPECT_EQ(why(embed(bytes, sample.image, at(ElfBuilder::config))), "");
    builder.set(bytes, 52 + 24, 6, 4);
    EXPECT_EQ(why(embed(bytes, sample.image, at(ElfBuilder::config))),
              "firmware-address: the segment at 0x08000000 is writable");
}

// A second segment of 8 bytes, then one that has memory only.
TEST(EmbedIntoElf, refuses_bytes_and_addresses_that_another_segment_has_too) {
    const Sample sample(false);
    const ElfBuilder builder;
    const base::Bytes good = builder.build();
    const auto with_second = [&](std::uint64_t offset, std::uint64_t address, std::uint64_t size) {
        base::Bytes bytes = good;
        builder.set(bytes, 44, 2, 2);
        std::copy_n(bytes.begin() + 52, 32, bytes.begin() + 84);
        builder.set(bytes, 84 + 4, offset, 4);
        builder.set(bytes, 84 + 8, address, 4);
        builder.set(bytes, 84 + 16, size, 4);
        builder.set(bytes, 84 + 20, 8, 4);
        return why(embed(bytes, sample.image, in(".cgw_config")));
    };
    const std::string twice = "elf-structure: two segments hold the bytes at 0x08000100";
    EXPECT_EQ(with_second(0x1F8, 0x20000000, 8), "");
    EXPECT_EQ(with_second(0x400, 0x20000000, 8), twice);
    EXPECT_EQ(with_second(0x1F8, 0x08000200, 8), twice);
    EXPECT_EQ(with_second(0x1F8, 0x08000FF8, 0), twice);
    EXPECT_EQ(with_second(0x1F8, 0x08001000, 0), "");
    EXPECT_EQ(with_second(0x400, 0x20000000, 0), "");
}

// Whatever the headers say: an error, or a file in which nothing but the image has changed (embed() proves
// it).
TEST(EmbedIntoElf, survives_any_flipped_bit_of_the_headers) {
    const Sample sample(false);
    std::size_t taken = 0;
    const ElfBuilder builder;
    const base::Bytes good = builder.build();
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        if (bit == 8 * 0x80) {
            bit = 8 * builder.names_offset();
        }
        const base::Bytes bytes = test::flipped(good, bit);
        taken += embed(bytes, sample.image, in(".cgw_config")) ? 1U : 0U;
    }
    EXPECT_GT(taken, 1000U);
}

}  // namespace
}  // namespace cgw::firmware_file
