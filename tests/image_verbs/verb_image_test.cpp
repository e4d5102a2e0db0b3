#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "base/utf8.hpp"
#include "cli/cgw/parser.hpp"
#include "support/golden.hpp"
#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

struct Outcome {
    int exit_code = 0;
    std::string out;
    std::string err;
};

Outcome run(const std::vector<const char*>& words) {
    const cli::Call call = cli::parse(words);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.exit_code = call.verb->run(call.arguments);
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
}

// In a directory of its own, which is the working directory, so that paths in the output are short.
class ImageVerbs : public testing::Test {
  protected:
    void SetUp() override {
        old_ = std::filesystem::current_path();
        directory_ =
            std::filesystem::temp_directory_path() / ("cgw-image-verbs-" + std::to_string(::getpid()));
        std::filesystem::create_directories(directory_);
        std::filesystem::current_path(directory_);
    }
    void TearDown() override {
        std::filesystem::current_path(old_);
        std::filesystem::remove_all(directory_);
    }

    static void write(const std::string& name, const base::Bytes& bytes) {
        std::ofstream(name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    static Outcome verify(const std::string& name) { return run({"image", "verify", name.c_str()}); }
    static Outcome inspect(const std::string& name, bool json) {
        return json ? run({"image", "inspect", name.c_str(), "--json"})
                    : run({"image", "inspect", name.c_str()});
    }

  private:
    std::filesystem::path old_, directory_;
};

TEST_F(ImageVerbs, verify_prints_one_line_about_a_valid_image) {
    const base::Bytes bytes = SamplePlant().image(false);
    write("plant.bin", bytes);
    const Outcome outcome = verify("plant.bin");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    const std::regex form("plant\\.bin: valid, format 1\\.0, " + std::to_string(bytes.size()) +
                          " bytes, configuration id a0a1a2a3a4a5a6a7, CRC [0-9a-f]{8}\n");
    EXPECT_TRUE(std::regex_match(outcome.out, form)) << outcome.out;
}

TEST_F(ImageVerbs, refuse_a_damaged_image_with_reason_and_number) {
    base::Bytes bytes = SamplePlant().image();
    bytes[100] ^= 4U;
    write("plant.bin", bytes);
    for (const Outcome& outcome :
         {verify("plant.bin"), inspect("plant.bin", false), inspect("plant.bin", true)}) {
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, "plant.bin: refused: the CRC-32 does not match (status 7)\n");
    }
}

TEST_F(ImageVerbs, refuse_an_empty_file_and_a_region_without_an_image) {
    write("empty.bin", {});
    EXPECT_EQ(verify("empty.bin").err, "empty.bin: refused: too few bytes for an image (status 1)\n");
    write("erased.bin", base::Bytes(100'000, 0xFF));
    EXPECT_EQ(verify("erased.bin").err,
              "erased.bin: refused: erased, all 100000 bytes are 0xFF (status 1)\n");
    write("other.bin", base::Bytes(100'000, 0x33));
    EXPECT_EQ(verify("other.bin").err, "other.bin: refused: it does not begin with \"CGWI\" (status 3)\n");
}

TEST_F(ImageVerbs, say_that_a_file_cannot_be_read) {
    const Outcome outcome = verify("absent.bin");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("absent.bin"), std::string::npos) << outcome.err;
    EXPECT_EQ(inspect("absent.bin", true).exit_code, 3);
}

TEST_F(ImageVerbs, inspect_shows_everything_that_matters) {
    SamplePlant plant;
    plant.set_reference(980, 0.5);
    plant.set_reference(981, 20);
    write("plant.bin", plant.image());
    const Outcome outcome = inspect("plant.bin", false);
    EXPECT_EQ(outcome.exit_code, 0);
    expect_golden("image/inspect.txt", outcome.out);
    const Outcome json = inspect("plant.bin", true);
    EXPECT_EQ(json.exit_code, 0);
    expect_golden("image/inspect.json", json.out);
}

TEST_F(ImageVerbs, inspect_stays_within_80_columns) {
    SamplePlant plant;
    plant.settings.title = std::string(70, 'x') + std::string("\xC3\xBC\xC3\xBC\xC3\xBC");
    plant.speed.name =
        "AVeryLongNameThatSomebodyGaveToAMeasurementInACatalogueOfTheirOwnMakingWithoutAnyNeed";
    write("plant.bin", plant.image());
    std::istringstream lines(inspect("plant.bin", false).out);
    std::string line;
    bool cut = false;
    while (std::getline(lines, line)) {
        std::size_t characters = 0;
        for (std::string_view rest = line; !rest.empty(); ++characters) {
            const std::size_t size = base::utf8_sequence_length(rest);
            ASSERT_NE(size, 0U) << line;
            rest.remove_prefix(size);
        }
        EXPECT_LE(characters, 80U) << line;
        cut = cut || characters == 80;
    }
    EXPECT_TRUE(cut);
}

TEST_F(ImageVerbs, inspect_shows_an_image_without_labels) {
    write("plant.bin", SamplePlant().image(false));
    const Outcome outcome = inspect("plant.bin", false);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out.find("labels\n  none\n"), std::string::npos) << outcome.out;
    EXPECT_NE(inspect("plant.bin", true).out.find(R"("labels":[])"), std::string::npos);
}

}  // namespace
}  // namespace cgw::test
