#include "firmware_file/elf.hpp"

#include <gtest/gtest.h>

#include "elf_builder.hpp"
#include "text.hpp"

namespace cgw::firmware_file {
namespace {

using test::ElfBuilder;

constexpr ElfBuilder kinds[] = {{false, false}, {true, false}, {false, true}, {true, true}};

// Rule and message, "" when it is fine.
template <typename T>
std::string why(const Outcome<T>& outcome) {
    return outcome ? "" : fmt::format("{}: {}", outcome.error().rule->name, outcome.error().message);
}

TEST(ElfFile, is_read_in_both_classes_and_byte_orders) {
    for (const ElfBuilder& kind : kinds) {
        const Outcome<Elf> elf = read_elf(kind.build());
        ASSERT_EQ(why(elf), "") << kind.wide << kind.big;
        EXPECT_EQ(elf->segments, (std::vector<ElfSegment>{{0x08000000, 0x200, 0x1000, 0x1040, false}}));
        ASSERT_EQ(elf->sections.size(), 8U);
        const Outcome<ElfSection> section = find_section(*elf, ".cgw_config");
        ASSERT_EQ(why(section), "");
        EXPECT_EQ(section->address, ElfBuilder::config);
        EXPECT_EQ(section->offset, 0x300U);
        EXPECT_EQ(section->size, 0xF00U);
    }
}

TEST(ElfFile, says_why_a_section_is_no_place_for_an_image) {
    const ElfBuilder builder;
    base::Bytes bytes = builder.build();
    const auto with = [&bytes](const char* name) { return why(find_section(*read_elf(bytes), name)); };
    EXPECT_EQ(with(".bss"), "firmware-section: section .bss has no contents in the file (NOBITS)");
    EXPECT_EQ(with(".comment"), "firmware-section: section .comment is not loaded into the device");
    EXPECT_EQ(with(".zipped"), "firmware-section: section .zipped is compressed");
    EXPECT_EQ(with(".shstrtab"), "firmware-section: section .shstrtab is no program data (PROGBITS)");
    EXPECT_EQ(with(".text"), "elf-structure: sections .text and .twin share bytes of the file");
    EXPECT_EQ(with(".data\x1b"), "firmware-section: there is no section .data?");
    const std::size_t config = builder.sections_offset() + 2 * builder.section_size();
    builder.set(bytes, config + 12, ElfBuilder::config + 4, 4);
    EXPECT_EQ(with(".cgw_config"),
              "firmware-section: section .cgw_config does not lie in one loaded segment");
    builder.set(bytes, config, 1, 4);  // called .text as well
    EXPECT_EQ(with(".text"), "firmware-section: section .text exists twice");
}

TEST(ElfFile, without_sections_still_has_its_segments) {
    const ElfBuilder builder;
    base::Bytes bytes = builder.build();
    builder.set(bytes, 32, 0, 4);
    builder.set(bytes, 48, 0, 2);
    const Outcome<Elf> elf = read_elf(bytes);
    ASSERT_EQ(why(elf), "");
    EXPECT_TRUE(elf->sections.empty());
    EXPECT_EQ(elf->segments.size(), 1U);
}

struct Damage {
    std::size_t at;
    std::uint64_t value;
    std::size_t width;
    const char* why;
};

TEST(ElfFile, is_refused_when_a_header_is_wrong) {
    const ElfBuilder builder;
    const std::size_t text = builder.sections_offset() + builder.section_size();
    const Damage damages[] = {
        {4, 3, 1, "at byte 0x4: unknown class, byte order or version"},
        {5, 0, 1, "at byte 0x4: unknown class, byte order or version"},
        {6, 2, 1, "at byte 0x4: unknown class, byte order or version"},
        {16, 1, 2, "at byte 0x10: this is no linked program"},
        {28, 0xFFFFFFF0, 4, "at byte 0x1C: the program header table lies outside the file"},
        {32, 0x1290, 4, "at byte 0x20: the section header table lies outside the file"},
        {42, 31, 2, "at byte 0x2A: an entry of the program header table has 31 bytes, not 32"},
        {44, 0xFFFF, 2, "at byte 0x2C: extended numbering of segments is not supported"},
        {44, 0xFFFE, 2, "at byte 0x1C: the program header table lies outside the file"},
        {46, 0, 2, "at byte 0x2E: an entry of the section header table has 0 bytes, not 40"},
        {48, 0, 2, "at byte 0x30: extended numbering of sections is not supported"},
        {50, 0xFFFF, 2, "at byte 0x30: extended numbering of sections is not supported"},
        {50, 8, 2, "at byte 0x32: there is no section with the names of the sections"},
        {50, 4, 2, "at byte 0x32: the names of the sections lie outside the file"},
        {56, 0xFFFFFFFF, 4, "at byte 0x34: segment 0 lies outside the file"},
        {68, 0x2000, 4, "at byte 0x34: segment 0 lies outside the file"},
        {72, 0xFFF, 4, "at byte 0x34: segment 0 does not fit its addresses"},
        {60, 0xFFFFF800, 4, "at byte 0x34: segment 0 does not fit its addresses"},
        {builder.sections_offset() + builder.section_size() + 12, 0xFFFFFF80, 4,
         "at byte 0x12A8: section 1 does not fit its addresses"},
        {text, 0xFFFFFFFF, 4, "at byte 0x12A8: the name of section 1 lies outside the names"},
        {text + 16, 0xFFFFFFFF, 4, "at byte 0x12A8: section 1 lies outside the file"},
        {text + 20, 0xFFFFFFFF, 4, "at byte 0x12A8: section 1 lies outside the file"},
    };
    for (const Damage& damage : damages) {
        base::Bytes bytes = builder.build();
        builder.set(bytes, damage.at, damage.value, damage.width);
        EXPECT_EQ(why(read_elf(bytes)), std::string("elf-structure: ") + damage.why) << damage.at;
    }
}

TEST(ElfFile, of_64_bits_is_refused_when_numbers_would_wrap) {
    const ElfBuilder builder{true, false};
    const std::size_t text = builder.sections_offset() + builder.section_size();
    const Damage damages[] = {
        {32, ~std::uint64_t{0}, 8, "at byte 0x20: the program header table lies outside the file"},
        {72, ~std::uint64_t{0} - 8, 8, "at byte 0x40: segment 0 lies outside the file"},
        {80, ~std::uint64_t{0} - 8, 8, "at byte 0x40: segment 0 does not fit its addresses"},
        {104, ~std::uint64_t{0}, 8, "at byte 0x40: segment 0 does not fit its addresses"},
        {text + 16, ~std::uint64_t{0}, 8, "at byte 0x12C0: section 1 does not fit its addresses"},
    };
    for (const Damage& damage : damages) {
        base::Bytes bytes = builder.build();
        builder.set(bytes, damage.at, damage.value, damage.width);
        EXPECT_EQ(why(read_elf(bytes)), std::string("elf-structure: ") + damage.why) << damage.at;
    }
}

TEST(ElfFile, is_refused_when_segments_lie_over_each_other) {
    const ElfBuilder builder;
    base::Bytes bytes = builder.build();
    std::copy_n(bytes.begin() + 52, 32, bytes.begin() + 84);
    builder.set(bytes, 44, 2, 2);
    EXPECT_EQ(why(read_elf(bytes)), "elf-structure: at byte 0x54: the segments lie over each other");
}

TEST(ElfFile, survives_any_truncation_and_any_flipped_bit_of_its_headers) {
    for (const ElfBuilder& kind : {kinds[0], kinds[3]}) {
        const base::Bytes good = kind.build();
        for (std::size_t size = 0; size < good.size(); size += size == 0x200 ? 0x1000 : 1) {
            const base::Bytes cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_FALSE(read_elf(cut)) << size;
        }
        for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
            if (bit == 8 * ElfBuilder::segment_offset) {
                bit = 8 * kind.names_offset();
            }
            const base::Bytes bytes = test::flipped(good, bit);
            if (const Outcome<Elf> elf = read_elf(bytes); elf) {
                for (const ElfSection& section : elf->sections) {
                    find_section(*elf, section.name);
                }
            }
        }
    }
}

}  // namespace
}  // namespace cgw::firmware_file
