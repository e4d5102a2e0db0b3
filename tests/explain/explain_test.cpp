// Questions and answers: codes, what is not known, and how answers look.
#include "explain/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/utf8.hpp"
#include "diagnostic/rules.hpp"
#include "support/golden.hpp"

namespace cgw::explain {
namespace {

// --- codes ---

TEST_F(Explain, a_rule_says_why_and_shows_itself) {
    EXPECT_EQ(titles("e0203"), "E0203 node-id-duplicate (error)");
    EXPECT_EQ(titles("Node-ID-duplicate"), "E0203 node-id-duplicate (error)");
    for (const char* label : {"demands", "why", "bad", "good", "source"}) {
        EXPECT_NE(field("E0203", label), "-") << label;
    }
}

TEST_F(Explain, every_rule_is_explained_by_code_and_by_name) {
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        EXPECT_EQ(titles(rule->code), titles(rule->name)) << rule->code;
        EXPECT_NE(field(rule->code, "why"), "-") << rule->code;
        const bool can_be_hidden = rule->level != diagnostic::Level::error;
        EXPECT_EQ(field(rule->code, "to hide") != "-", can_be_hidden) << rule->code;
    }
}

TEST_F(Explain, an_abort_code_says_when_the_gateway_sends_it) {
    EXPECT_EQ(titles("0x06010002"), "SDO abort code 0x06010002");
    EXPECT_EQ(titles("0601 0002h"), "SDO abort code 0x06010002");
    EXPECT_TRUE(field("0x06010002", "gateway").starts_with("sends it for every write"));
    EXPECT_EQ(field("0x05030000", "gateway"), "does not send it");
    EXPECT_EQ(complaint("0x06010005"), "0x06010005 is no SDO abort code of CiA 301");
}

// --- what is not understood ---

TEST_F(Explain, near_names_are_proposed) {
    EXPECT_EQ(complaint("CanOpHeartBeatTxTimes"),
              "nothing is known about `CanOpHeartBeatTxTimes` | did you mean `CanOpHeartBeatTxTime`?");
    EXPECT_EQ(complaint("node-id-duplicat"),
              "nothing is known about `node-id-duplicat` | did you mean `node-id-duplicate`?");
    EXPECT_EQ(complaint("sensor-eror"),
              "nothing is known about `sensor-eror` | did you mean `sensor-error`?");
}

TEST_F(Explain, what_is_not_known_is_said_so) {
    EXPECT_EQ(complaint("1999"),
              "no parameter, measurement or error with the number 1999 is known | "
              "governor types differ: your governor's own manual may have it");
    EXPECT_EQ(complaint(""), "an empty question");
    EXPECT_EQ(complaint("qqqqqq\x01"), "nothing is known about `qqqqqq?`");
    EXPECT_EQ(complaint(std::string(100, 'q')), "nothing is known about `" + std::string(40, 'q') + "…`");
}

TEST_F(Explain, the_forms_it_proposes_are_all_understood) {
    for (const QuestionForm& form : question_forms()) {
        EXPECT_TRUE(ask(form.example).understood()) << form.example;
    }
}

// --- rendering ---

TEST_F(Explain, no_answer_is_wider_than_a_terminal) {
    std::vector<Answer> answers;
    for (const parameter::Row& row : catalogue::shipped_rows()) {
        answers.push_back(ask(fmt::format("{}", row.number)));
    }
    for (const char* question : {"2005h=0x3FFF", "2000h:5=0xFFFF", "sensor-error", "2003h:1", "1A03h"}) {
        answers.push_back(ask(question));
    }
    std::istringstream lines(render_text(answers));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(base::width_of(line), 80U) << line;
    }
}

TEST_F(Explain, answers_look_as_they_did) {
    const std::vector<Answer> answers = {ask("12412"), ask("2005h=0x0102"), ask("16404"), ask("2003h:1"),
                                         ask("E0203"), ask("0x06010002"),   ask("3800=9")};
    test::expect_golden("explain/answers.txt", render_text(answers));
    test::expect_golden("explain/answers.json", render_json(answers));
}

}  // namespace
}  // namespace cgw::explain
