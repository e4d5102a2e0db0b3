#include "driver/prove.hpp"

#include <gtest/gtest.h>

#include "dbc/read.hpp"
#include "eds/reader.hpp"
#include "eds_check/checks.hpp"
#include "support/image_bytes.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::driver {
namespace {

class Prove : public testing::Test {
  protected:
    CheckedFile file = check_file(CGW_SAMPLES "/genset.toml");
    base::Result<Plant> plant = Plant::make(file);
    test::ScratchDirectory directory;

    base::Bytes artefact(const std::string& emitter) {
        return emit::find_emitter(emitter)->emit(plant->view(), {});
    }
    std::string text_of(const std::string& emitter) {
        const base::Bytes bytes = artefact(emitter);
        return {bytes.begin(), bytes.end()};
    }
    std::string path_of(const std::string& emitter) { return directory.write(emitter, text_of(emitter)); }

    std::size_t differences_of_sheet(const std::string& text) {
        diagnostic::Findings findings;
        const eds::Document document(text);
        const eds::Sheet sheet = eds::read(document, "a.eds", findings);
        eds_check::check(document, sheet, "a.eds", {.file_name = "CANopenGateway.eds"}, findings);
        if (!findings.all().empty()) {
            return 1;  // told already
        }
        return proof::prove_description(plant->view(), {sheet.dictionary}).differences.all.size();
    }

    dictionary::Differences differences_of_database(const std::string& text) {
        diagnostic::Findings findings;
        const dbc::Database database = dbc::read(text, "a.dbc", findings);
        EXPECT_TRUE(findings.all().empty());
        return proof::prove_database(plant->view(), database).differences;
    }
};

}  // namespace

TEST_F(Prove, all_artefacts_of_the_plant_are_the_same) {
    const Proofs proofs =
        prove(plant->view(), {{path_of("eds"), path_of("dcf"), path_of("xdd"), path_of("xdc")},
                              {path_of("image")},
                              {path_of("dbc")}});
    EXPECT_FALSE(proofs.unreadable);
    EXPECT_FALSE(proofs.has_errors);
    EXPECT_FALSE(proofs.has_errors);
    ASSERT_EQ(proofs.all.size(), 6U);
    EXPECT_TRUE(proof::all_same(proofs.all)) << proof::formats()[0].render({"f", "id", 12}, proofs.all);
    EXPECT_EQ(proofs.all[1].kind, "DCF");
}

TEST_F(Prove, every_artefact_of_another_plant_differs) {
    const CheckedFile other = check_file(CGW_SAMPLES "/minimal.toml");
    const auto other_plant = Plant::make(other);
    const Proofs proofs =
        prove(other_plant->view(), {{path_of("eds"), path_of("dcf")}, {path_of("image")}, {path_of("dbc")}});
    ASSERT_EQ(proofs.all.size(), 4U);
    for (const proof::Proof& each : proofs.all) {
        EXPECT_FALSE(each.differences.same()) << each.path;
    }
}

// A change of one digit anywhere behind [FileInfo] and outside of [Comments].
TEST_F(Prove, every_changed_number_of_a_data_sheet_is_told) {
    const std::string text = text_of("eds");
    const std::size_t first = text.find("[DeviceInfo]");
    const std::size_t comments = text.find("[Comments]");
    const std::size_t behind_comments = text.find("\r\n[", comments);
    std::size_t tried = 0;
    for (std::size_t at = text.find('=', first); at != std::string::npos; at = text.find('=', at + 1)) {
        const std::size_t end = text.find('\r', at);
        const char last = text[end - 1];
        const bool is_comment = at > comments && at < behind_comments;
        // The reader does not keep the object type of a sub-object, and no check looks at it yet.
        const bool is_type_of_sub = text.substr(text.rfind('[', at), 9).find("sub") != std::string::npos &&
                                    text.substr(at - 10, 10) == "ObjectType";
        if (is_comment || is_type_of_sub || last < '0' || last > '8' || ++tried % 3 != 0) {
            continue;
        }
        std::string changed = text;
        changed[end - 1] = static_cast<char>(last + 1);
        EXPECT_NE(differences_of_sheet(changed), 0U) << text.substr(at - 20, end - at + 20);
    }
    EXPECT_GT(tried, 500U);
}

TEST_F(Prove, every_changed_byte_of_an_image_is_refused_or_told) {
    const base::Bytes bytes = artefact("image");
    constexpr std::size_t version_begin = image::header::tool_version;
    constexpr std::size_t version_end = version_begin + 6;
    std::size_t told = 0;
    for (std::size_t at = 0; at + image::crc_size < bytes.size(); at += 5) {
        base::Bytes changed = bytes;
        changed[at] ^= 0x01U;
        test::sign(changed);
        image::Image image;
        const bool version = at >= version_begin && at < version_end;
        if (version || image::Image::open(changed, image) != image::Status::ok) {
            continue;
        }
        ++told;
        EXPECT_FALSE(proof::prove_image(plant->view(), image).differences.same()) << at;
    }
    EXPECT_GT(told, 100U);
}

TEST_F(Prove, an_image_without_labels_is_the_same_and_says_what_was_not_compared) {
    emit::Options options;
    options.labels = false;
    const base::Bytes bytes = emit::find_emitter("image")->emit(plant->view(), options);
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), image::Status::ok);
    const dictionary::Differences found = proof::prove_image(plant->view(), image).differences;
    EXPECT_TRUE(found.same());
    EXPECT_EQ(found.not_compared.size(), 3U);
}

TEST_F(Prove, every_part_of_a_signal_counts) {
    const std::string text = text_of("dbc");
    const std::pair<std::string, std::string> changes[] = {
        {"BO_ 396 GW12_TPDO1: 8", "BO_ 397 GW12_TPDO1: 8"},
        {"BO_ 396 GW12_TPDO1: 8", "BO_ 396 GW12_TPDO1: 7"},
        {"SG_ Error_3001 :", "SG_ Other :"},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 2|1@1+ (1,0) [0|1] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|2@1+ (1,0) [0|1] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|1@0+ (1,0) [0|1] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|1@1- (1,0) [0|1] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|1@1+ (2,0) [0|1] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|1@1+ (1,1) [0|1] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|1@1+ (1,0) [0|2] \"\""},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\"", "SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"V\""},
        {"SG_ Error_3001 : 1|1", "SG_ Error_3001 m1 : 1|1"},
        {"BA_ \"GenMsgCycleTime\" BO_ 1164 ", "BA_ \"GenMsgCycleTime\" BO_ 1164 9"},
        {"BA_ \"GenMsgSendType\" BO_ 1164 0", "BA_ \"GenMsgSendType\" BO_ 1164 1"},
        {"BO_ 396 GW12_TPDO1: 8", "BO_ 396 GW12_TPDO2: 8"},
        {"BO_ 396 GW12_TPDO1: 8 GW12", "BO_ 396 GW12_TPDO1: 8 Node1"},
        {"SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\" Node1", "SG_ Error_3001 : 1|1@1+ (1,0) [0|1] \"\" GW12"},
    };
    for (const auto& [before, after] : changes) {
        const std::size_t at = text.find(before);
        ASSERT_NE(at, std::string::npos) << before;
        std::string changed = text;
        changed.replace(at, before.size(), after);
        EXPECT_FALSE(differences_of_database(changed).same()) << after;
    }
}

TEST_F(Prove, messages_of_other_nodes_do_not_count_and_those_of_the_gateway_do) {
    const std::string text = text_of("dbc");
    EXPECT_TRUE(differences_of_database(text + "BO_ 500 Other: 8 Node1\r\n").same());
    EXPECT_FALSE(differences_of_database(text + "BO_ 500 Other: 8 GW12\r\n").same());
}

TEST_F(Prove, another_configuration_id_in_a_database_is_told_and_none_is_not_compared) {
    std::string text = text_of("dbc");
    const std::size_t id = text.find("configuration ") + std::string("configuration ").size();
    ASSERT_EQ(text.substr(id, 16), plant->view().configuration_id_text);
    std::string other = text;
    other[id] = other[id] == '0' ? '1' : '0';
    const dictionary::Differences differing = differences_of_database(other);
    ASSERT_EQ(differing.all.size(), 1U);
    EXPECT_EQ(differing.all[0].aspect, "configuration-id");
    EXPECT_EQ(differing.all[0].a, plant->view().configuration_id_text);
    const dictionary::Differences unknown = differences_of_database(text.erase(id, 16));
    EXPECT_TRUE(unknown.same());
    EXPECT_EQ(unknown.not_compared, std::vector<std::string_view>{"configuration id"});
}

// What importers refuse fails, though the device that it describes is the same.
TEST_F(Prove, a_data_sheet_that_strict_importers_refuse_has_errors) {
    const std::pair<std::string, std::string> changes[] = {
        {"AccessType=rww", "AccessType=rw"},
        {"AccessType=ro", "AccessType=RO"},
        {"[DeviceInfo]\r\n", "[DeviceInfo]\r\nUnit=1\r\n"},
    };
    for (const auto& [before, after] : changes) {
        std::string text = text_of("eds");
        const std::size_t at = text.find(before);
        ASSERT_NE(at, std::string::npos) << before;
        text.replace(at, before.size(), after);
        const Proofs proofs = prove(plant->view(), {{directory.write("strict.eds", text)}, {}, {}});
        EXPECT_TRUE(proofs.has_errors) << after;
        ASSERT_EQ(proofs.all.size(), 1U) << after;
        EXPECT_EQ(proofs.all[0].strict_errors, 1U) << after;
        EXPECT_NE(proof::formats()[0].render({"f", "id", 12}, proofs.all).find("strict importers refuse it"),
                  std::string::npos);
    }
}

TEST_F(Prove, another_node_number_in_a_dcf_is_told) {
    std::string text = text_of("dcf");
    const std::string before = "NodeID=12";
    text.replace(text.find(before), before.size(), "NodeID=13");
    const Proofs proofs = prove(plant->view(), {{directory.write("other.dcf", text)}, {}, {}});
    ASSERT_EQ(proofs.all.size(), 1U);
    ASSERT_FALSE(proofs.all[0].differences.same());
    EXPECT_EQ(proofs.all[0].differences.all[0].aspect, "node-id");
}

TEST_F(Prove, what_cannot_be_read_is_a_finding_and_the_rest_is_proved) {
    const Proofs proofs = prove(plant->view(), {{"/nonexistent.eds"},
                                                {directory.write("cut.bin", "CGWI")},
                                                {directory.write("no.dbc", "nothing"), path_of("dbc")}});
    EXPECT_TRUE(proofs.unreadable);
    EXPECT_TRUE(proofs.has_errors);
    EXPECT_EQ(proofs.reports.size(), 3U);
    EXPECT_EQ(proofs.all.size(), 1U);
}

}  // namespace cgw::driver
