#include <gtest/gtest.h>

#include "base/edit_distance.hpp"
#include "base/json.hpp"
#include "base/sha256.hpp"
#include "base/utf8.hpp"

namespace base = cgw::base;

TEST(EditDistance, counts_single_character_edits_and_swaps) {
    EXPECT_EQ(base::edit_distance("speed", "speed"), 0U);
    EXPECT_EQ(base::edit_distance("Speed", "sPEED"), 0U);
    EXPECT_EQ(base::edit_distance("Sped", "Speed"), 1U);
    EXPECT_EQ(base::edit_distance("Spede", "Speed"), 1U);
    EXPECT_EQ(base::edit_distance("", "abc"), 3U);
}

TEST(NearestName, offers_only_what_is_near) {
    const std::string_view names[] = {"CanMyNodeNumber", "CanCMNodeNumber", "CanBaudrate"};
    EXPECT_EQ(base::nearest_name("CanMyNodNumber", names), "CanMyNodeNumber");
    EXPECT_EQ(base::nearest_name("canbaudrate", names), "CanBaudrate");
    EXPECT_EQ(base::nearest_name("Temperature", names), "");
    EXPECT_EQ(base::nearest_name("", names), "");
    EXPECT_EQ(base::nearest_name(std::string(100000, 'x'), names), "");
}

TEST(Sha256, matches_the_published_vectors) {
    const auto hash = [](const std::string& text) {
        return base::to_hex(base::sha256(std::vector<std::uint8_t>(text.begin(), text.end())));
    };
    EXPECT_EQ(hash(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hash("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hash(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, is_shown_by_its_first_eight_bytes) {
    const base::Sha256 id = base::sha256(std::vector<std::uint8_t>{'a', 'b', 'c'});
    EXPECT_EQ(base::short_id(id), "ba7816bf8f01cfea");
}

TEST(Utf8, accepts_exactly_the_well_formed_sequences) {
    EXPECT_EQ(base::utf8_sequence_length("a"), 1U);
    EXPECT_EQ(base::utf8_sequence_length("\xC3\xA4"), 2U);
    EXPECT_EQ(base::utf8_sequence_length("\xE2\x82\xAC"), 3U);
    EXPECT_EQ(base::utf8_sequence_length("\xF0\x9F\x9A\xA2"), 4U);
    for (const char* bad : {"", "\x80", "\xC0\x80", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80",
                            "\xF4\x90\x80\x80", "\xFF", "\xE2\x82", "\xE2\x82x"}) {
        EXPECT_EQ(base::utf8_sequence_length(bad), 0U) << testing::PrintToString(bad);
    }
}

TEST(Utf8, width_counts_characters_not_bytes) {
    EXPECT_EQ(base::width_of("°C"), 2U);
    EXPECT_EQ(base::width_of(""), 0U);
    EXPECT_EQ(base::width_of("mm³"), 3U);
}

TEST(Printable, lets_nothing_through_that_steers_a_terminal) {
    EXPECT_EQ(base::printable("plain \xC3\xA4 \xE2\x82\xAC"), "plain \xC3\xA4 \xE2\x82\xAC");
    EXPECT_EQ(base::printable("a\x1B[31m\n\x7F"), "a?[31m??");
    EXPECT_EQ(base::printable("\xC2\x9B"
                              "31m"),
              "?31m");  // C1: 8-bit CSI
    EXPECT_EQ(base::printable("\xE2\x80\xAE\xE2\x80\x8B\xEF\xBB\xBF"),
              "???");  // bidi override, zero width, BOM
    EXPECT_EQ(base::printable("\xFF\x9B"), "??");
    EXPECT_TRUE(base::has_control("a\xC2\x85"));
    EXPECT_FALSE(
        base::has_control("Gr\xC3\xB6\xC3\x9F"
                          "e"));
}

TEST(JsonWriter, separates_nests_and_escapes) {
    base::JsonWriter json;
    json.begin_object()
        .key("a")
        .integer(-1)
        .key("b")
        .begin_array()
        .string("x")
        .null()
        .boolean(true)
        .end_array();
    json.key("c").begin_object().end_object().key("d").real(0.5).end_object();
    EXPECT_EQ(json.take(), "{\"a\":-1,\"b\":[\"x\",null,true],\"c\":{},\"d\":0.5}\n");
}

TEST(JsonWriter, stays_valid_whatever_the_bytes) {
    EXPECT_EQ(base::json_quote("a\"b\\c\n\x01\x7F"), "\"a\\\"b\\\\c\\n\\u0001\\u007f\"");
    EXPECT_EQ(base::json_quote("\xC3\xA4"), "\"\xC3\xA4\"");
    EXPECT_EQ(base::json_quote("\xFFx"), "\"\xEF\xBF\xBDx\"");
}

TEST(JsonWriter, takes_finished_values_as_they_are) {
    base::JsonWriter json;
    json.begin_array().json("{\"a\":1}").json("true").end_array();
    EXPECT_EQ(json.take(), "[{\"a\":1},true]\n");
}

TEST(PrettyJson, keeps_on_a_line_what_fits_and_breaks_the_rest) {
    const std::string_view document = R"({"a":[1,2],"b":{"c":"x, y: z","d":[]},"e":{}})";
    EXPECT_EQ(base::pretty_json(document, 60),
              "{\"a\": [1, 2], \"b\": {\"c\": \"x, y: z\", \"d\": []}, \"e\": {}}\n");
    EXPECT_EQ(base::pretty_json(document, 36),
              "{\n"
              "  \"a\": [1, 2],\n"
              "  \"b\": {\"c\": \"x, y: z\", \"d\": []},\n"
              "  \"e\": {}\n"
              "}\n");
    EXPECT_EQ(base::pretty_json(R"(["long",[1,[2]]])", 8),
              "[\n"
              "  \"long\",\n"
              "  [\n"
              "    1,\n"
              "    [2]\n"
              "  ]\n"
              "]\n");
}

TEST(PrettyJson, is_not_led_astray_by_strings) {
    const std::string_view document = R"({"a}\"":"\\","b":"[,\"]"})";
    EXPECT_EQ(base::pretty_json(document, 5),
              "{\n"
              "  \"a}\\\"\": \"\\\\\",\n"
              "  \"b\": \"[,\\\"]\"\n"
              "}\n");
    EXPECT_EQ(base::pretty_json("[]\n"), "[]\n");
    EXPECT_EQ(base::pretty_json("12"), "12\n");
}
