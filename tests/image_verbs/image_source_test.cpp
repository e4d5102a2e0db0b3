// The image as source files; that they compile and link is shown by embed_consumer and judges.image_forms.
#include <gtest/gtest.h>

#include <regex>

#include "emit/emitter.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

std::string source_of(const SamplePlant& plant, const emit::Options& options = {}) {
    const parameter::Catalogue catalogue({});
    const emit::Plant view{plant.settings,         catalogue,          plant.configuration, plant.dictionary,
                           plant.configuration_id, "a0a1a2a3a4a5a6a7", {1, 2, 3},           "1.2.3"};
    const base::Bytes bytes = emit::find_emitter("image-source")->emit(view, options);
    return {bytes.begin(), bytes.end()};
}

emit::Options other_names(const std::string& format) {
    emit::Options options;
    options.format = format;
    options.section = ".engine";
    options.alignment = 64;
    options.symbol = "plant";
    options.image_file = "out/plant.bin";
    return options;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(ImageSource, holds_the_bytes_of_the_image) {
    const SamplePlant plant;
    const std::string text = source_of(plant);
    base::Bytes bytes;
    const std::regex number("0x([0-9a-f]{2}),");
    for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul((*it)[1], nullptr, 16)));
    }
    EXPECT_EQ(bytes, plant.image());
}

TEST(ImageSource, names_title_configuration_and_version) {
    const std::string text = source_of(SamplePlant());
    EXPECT_TRUE(contains(text, "written by cgw 1.2.3;"));
    EXPECT_TRUE(contains(text, "\"Genset 2, starboard – Größe\"\n"));
    EXPECT_TRUE(contains(text, "a0a1a2a3a4a5a6a7\n"));
}

TEST(ImageSource, uses_the_section_alignment_and_symbol_asked_for) {
    const std::string text = source_of(SamplePlant(), other_names(""));
    EXPECT_TRUE(contains(text, "alignas(64) __attribute__((section(\".engine\"), used))"));
    EXPECT_TRUE(contains(text, "extern const unsigned char plant["));
    EXPECT_TRUE(contains(text, "const unsigned int plant_size = "));
}

TEST(ImageSource, is_a_header_whose_definition_one_file_asks_for) {
    const std::string text = source_of(SamplePlant(), other_names("h"));
    const std::string size = std::to_string(SamplePlant().image().size());
    EXPECT_TRUE(contains(text, "#define PLANT_SIZE " + size + "\n#define PLANT_ID \"a0a1a2a3a4a5a6a7\"\n"));
    EXPECT_TRUE(contains(text, "extern const unsigned char plant[" + size + "];\n"));
    const std::size_t asked = text.find("#ifdef PLANT_DEFINE\n");
    ASSERT_NE(asked, std::string::npos);
    EXPECT_GT(text.find("__attribute__((aligned(64), section(\".engine\"), used))"), asked);
}

TEST(ImageSource, for_the_assembler_includes_the_binary_and_says_nothing_of_the_plant) {
    const std::string text = source_of(SamplePlant(), other_names("asm"));
    EXPECT_TRUE(contains(text, ".section \".engine\", \"a\", %progbits\n    .balign 64\n"));
    EXPECT_TRUE(contains(text, "plant:\n    .incbin \"out/plant.bin\"\n"));
    EXPECT_FALSE(contains(text, "a0a1a2a3a4a5a6a7"));
}

TEST(ImageSource, keeps_any_title_inside_its_comment) {
    SamplePlant plant;
    plant.settings.title = "a\nint b;\x7F\xFF \xE2\x80\xAE\xE2\x81\xA6\xD8\x9C \\";
    EXPECT_TRUE(contains(source_of(plant), "// title:            \"a?int b;?? ??? \\\"\n"));
}

}  // namespace
}  // namespace cgw::test
