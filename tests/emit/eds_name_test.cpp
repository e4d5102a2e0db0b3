// --eds-name: the data sheets' file name, inside and outside, and the EDS that needs no configuration.
#include <gtest/gtest.h>

#include "plant.hpp"

namespace cgw::emit {
namespace {

std::string accepted(const std::string& name) {
    const base::Result<std::string> result = eds_file_name(name);
    return result ? *result : "refused: " + result.error().message;
}

std::string text_of(const base::Bytes& bytes) {
    return {bytes.begin(), bytes.end()};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(EdsName, gets_its_ending_where_that_is_left_out) {
    EXPECT_EQ(accepted("genset-2"), "genset-2.eds");
    EXPECT_EQ(accepted("Genset 2.eds"), "Genset 2.eds");
    EXPECT_EQ(accepted("GENSET_2.EDS"), "GENSET_2.EDS");
    EXPECT_EQ(accepted("v1.2"), "v1.2.eds");
    EXPECT_EQ(accepted("eds"), "eds.eds");
    EXPECT_EQ(accepted(default_eds_name.data()), default_eds_name);
}

TEST(EdsName, is_refused_with_the_reason) {
    EXPECT_EQ(accepted(""), "refused: '' is no name for a data sheet: it begins with a letter or digit");
    for (const std::string name : {".eds", "-x.eds", " x", "..", "_x"}) {
        EXPECT_TRUE(contains(accepted(name), "it begins with a letter or digit")) << name;
    }
    for (const std::string name : {"out/x.eds", "a\\x", "C:x", "x;y", "x\ny",
                                   "Gr\xC3\xB6\xC3\x9F"
                                   "e",
                                   "x?"}) {
        EXPECT_TRUE(contains(accepted(name), "letters, digits, blanks and . _ - only, and no directory"))
            << name;
    }
    for (const std::string name : {"x ", "x .eds", "x.", "x..eds"}) {
        EXPECT_TRUE(contains(accepted(name), "no blank or point stands before .eds")) << name;
    }
    for (const std::string ending : {".dcf", ".dbc", ".xdd", ".xdc", ".cdcf"}) {
        EXPECT_EQ(accepted("x" + ending), "refused: 'x" + ending +
                                              "' is no name for a data sheet: " + ending +
                                              " names another kind of file; leave it out, or write .eds");
        EXPECT_EQ(accepted("x" + ending + "s"), "x" + ending + "s.eds");
    }
    EXPECT_TRUE(contains(accepted("x.DCF"), ".dcf names another kind of file"));
    EXPECT_EQ(accepted(std::string(60, 'x')), std::string(60, 'x') + ".eds");
    EXPECT_TRUE(contains(accepted(std::string(61, 'x')), "it has at most 64 characters"));
}

TEST(EdsName, stands_in_the_file_and_names_it) {
    const test::SamplePlant plant(test::manual_configuration());
    Options options;
    options.eds_name = "starboard.eds";
    const Emitter& eds = *find_emitter("eds");
    EXPECT_TRUE(contains(text_of(eds.emit(plant.view(), options)), "FileName=starboard.eds\r\n"));
    EXPECT_EQ(file_name(eds.formats.front(), options), "starboard.eds");
    EXPECT_EQ(file_name(eds.formats.front(), {}), "CANopenGateway.eds");
    options.eds_name = "PORT.EDS";
    EXPECT_EQ(file_name(eds.formats.front(), options), "PORT.EDS");
    EXPECT_EQ(file_name(find_emitter("dcf")->formats.front(), options), "PORT.dcf");
    options.eds_name = "starboard.eds";
    EXPECT_EQ(file_name(find_emitter("image")->formats.front(), options), "gateway-config.bin");
}

TEST(GenericEds, needs_no_plant_and_takes_the_name) {
    Options options;
    options.eds_name = "plain.eds";
    const std::string text = text_of(find_emitter("eds")->emit_generic({{2026, 3, 1}, "1.2.3"}, options));
    EXPECT_TRUE(contains(text, "FileName=plain.eds\r\n"));
    EXPECT_TRUE(contains(text, "ModificationDate=03-01-2026\r\n"));
    EXPECT_TRUE(contains(text, "ModifiedBy=cgw 1.2.3\r\n"));
    EXPECT_TRUE(contains(text, "DefaultValue=$NODEID+0x80000480\r\n"));
}

TEST(GenericEds, is_the_only_artefact_without_a_configuration) {
    for (const Emitter& emitter : all_emitters()) {
        EXPECT_EQ(emitter.emit_generic != nullptr, emitter.name == "eds") << emitter.name;
    }
}

}  // namespace cgw::emit
