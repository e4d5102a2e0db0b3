// Questions and answers.
#include "explain/explain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "catalogue/catalogue.hpp"
#include "catalogue/errors.hpp"
#include "catalogue/objects.hpp"
#include "diagnostic/rules.hpp"
#include "explain/text.hpp"
#include "support/golden.hpp"

namespace {

using cgw::explain::Answer;
using cgw::explain::Entry;
using cgw::explain::Field;
using cgw::parameter::Catalogue;

class Explain : public testing::Test {
  protected:
    Answer ask(std::string_view question) const { return cgw::explain::explain(question, catalogue); }

    std::string titles(std::string_view question) const {
        std::string text;
        for (const Entry& entry : ask(question).entries) {
            text += (text.empty() ? "" : " | ") + entry.title;
        }
        return text;
    }

    // Lines of a field of the answer's entry number `at`, joined by " / "; "-" when there is no such field.
    std::string field(std::string_view question, std::string_view label, std::size_t at = 0) const {
        const Answer answer = ask(question);
        if (at >= answer.entries.size()) {
            return "no entry";
        }
        for (const Field& one : answer.entries[at].fields) {
            if (one.label == label) {
                std::string text;
                for (const std::string& line : one.lines) {
                    text += (text.empty() ? "" : " / ") + line;
                }
                return text;
            }
        }
        return "-";
    }

    std::string complaint(std::string_view question) const {
        const Answer answer = ask(question);
        EXPECT_FALSE(answer.understood()) << question;
        return answer.complaint + (answer.help.empty() ? "" : " | " + answer.help);
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

// --- parameters ---

TEST_F(Explain, a_number_is_explained_in_both_devices) {
    EXPECT_EQ(titles("416"), "governor 416 CanBaudrate | gateway 416 HzmCanBaudrate");
    EXPECT_EQ(field("416", "range"), "125, 250, 500 or 1000 kbit/s");
    EXPECT_EQ(field("416", "default"), "none, it must be set unless 4416 is 1");
    EXPECT_EQ(field("416", "list", 1), "parameter, level 6");
    EXPECT_EQ(titles("427"), "gateway 427 CanOpenMyNodeID");
    EXPECT_EQ(field("427", "default"), "none, it must be set");
    EXPECT_EQ(field("429", "default"), "0");
    EXPECT_EQ(field("1800", "default"), "none; the device keeps what it has");
}

TEST_F(Explain, a_number_of_the_bootloader_is_one_of_its_own) {  // D1
    EXPECT_EQ(titles("3076"),
              "error 3076 ErrParamStore (gateway) | error 3076 ErrEEPROM (gateway bootloader) | "
              "gateway 3076 ErrParamStore | gateway bootloader 3076 ErrEEPROM");
}

TEST_F(Explain, a_name_is_matched_ignoring_case_and_by_alias) {
    EXPECT_EQ(titles("canopenmynodeid"), "gateway 427 CanOpenMyNodeID");
    EXPECT_EQ(titles("CanOpSegmentOrBaurdate"), "gateway 4426 CanOpSegmOrBaudrate");
    EXPECT_EQ(titles("CanMyNodeNumber"), "governor 401 CanMyNodeNumber | gateway 401 CanMyNodeNumber");
    EXPECT_EQ(titles("416 CanBaudrate"), "governor 416 CanBaudrate");
    EXPECT_EQ(titles("  CanOpTPDO5-16ID (3) "), "gateway 16407 CanOpTPDO5-16ID(3)");
}

TEST_F(Explain, a_misprint_leads_to_what_is_meant) {  // D2
    EXPECT_EQ(titles("409"), "governor 416 CanBaudrate");
    EXPECT_EQ(field("409", "note"), "the manual prints 409 for it in places");
    EXPECT_EQ(titles("409 CanBaudrate"), "governor 416 CanBaudrate");
}

TEST_F(Explain, a_parameter_says_where_it_is_used_and_what_belongs_to_it) {
    EXPECT_EQ(field("16407", "feeds", 1), "1807h:1, the COB-ID of TPDO8");
    EXPECT_EQ(field("16407", "array", 1), "element 3 of CanOpTPDO5-16ID, 16404..16415");
    EXPECT_EQ(field("16407", "typed", 1), "in hexadecimal, as the manual prints it: write 0x");
    EXPECT_EQ(field("811", "partner"), "4811 Type_IdleSpeed, which says where it comes from");
    EXPECT_EQ(field("4900", "partner"), "900 AssignIn_Setp1Ext, which says which input, bit or channel");
    EXPECT_EQ(field("2401", "tells of"), "3071 ErrCanComm1, 12422 CanOpGWErrCanComm1");
    EXPECT_EQ(field("12412", "seen in", 1), "bit 1 of 2005h");
    EXPECT_EQ(field("3074", "seen in", 1), "bit 10 of 2000h:5");
}

TEST_F(Explain, a_measurement_says_how_it_travels) {
    EXPECT_EQ(field("2907", "word"),
              "16 bits, unsigned: an entry of 2001h while one of TPDO4..16 carries it / "
              "0 is -100 °C, 65535 is 1000 °C");
    EXPECT_EQ(field("2915", "word").substr(73), "0 is 0 1/min, 65535 is the value of 987");
    EXPECT_EQ(field("2330", "word").substr(73), "0..65535, what they mean is not printed");
    EXPECT_EQ(field("2810", "word"), "a single bit: TPDO4..16 do not carry it");
}

TEST_F(Explain, bits_that_differ_in_a_number_share_a_line) {
    EXPECT_EQ(field("2411", "bits"), "bit 1..15, Node1..15: the governor with node number 1..15 is heard");
    EXPECT_NE(field("3099", "bits", 1).find("bit 5, ParameterPages: "), std::string::npos);
}

// --- errors ---

TEST_F(Explain, an_error_has_cause_response_action_and_how_it_clears) {
    EXPECT_EQ(titles("12412"),
              "error 12412 CanOpInitErr (governor and gateway) | governor 12412 CanOpInitErr | "
              "gateway 12412 CanOpInitErr");
    for (const char* label : {"cause", "response", "action", "clears", "source"}) {
        EXPECT_NE(field("12412", label), "-") << label;
    }
}

TEST_F(Explain, error_and_counter_lead_to_each_other) {
    EXPECT_EQ(titles("3172"), "error 3072 ErrCanBus2 (gateway) | gateway 3172 SErrCanBus2");
    EXPECT_EQ(field("3072", "counter"), "3172 SErrCanBus2 counts it in the permanent error memory");
    EXPECT_EQ(field("3072", "see also"), "12423 CanOpGWErrCanBus2");
}

TEST_F(Explain, an_error_that_no_document_names_is_a_bit_all_the_same) {  // D21
    EXPECT_EQ(titles("3002"), "error 3002");
    EXPECT_EQ(field("3002", "seen in"), "bit 2 of 2000h:1");
    EXPECT_EQ(complaint("3097x").find("nothing is known"), 0U);
}

TEST_F(Explain, errors_without_a_number_have_a_word) {
    EXPECT_EQ(titles("Sensor-Error"), "error 3005 ErrSetpointExtern (governor)");
    EXPECT_EQ(titles("switch-error"), "error switch-error (governor)");
    EXPECT_EQ(titles("bootloader-silent"), "error bootloader-silent (gateway bootloader)");
}

// --- objects ---

TEST_F(Explain, an_object_has_type_source_and_bits) {
    EXPECT_EQ(titles("1018h"), "object 1018h Identity Object");
    EXPECT_EQ(field("1018h", "entries"),
              "0 Number of entries, 1 Vendor ID, 2 Product Code, 3 Revision Number, 4 Serial Number");
    EXPECT_EQ(field("0x1018:2", "value"), "7001 (1B59h)");
    EXPECT_EQ(field("1018h:3", "comes from"), "gateway 3842");
    EXPECT_EQ(titles("2003h:1"), "object 2003h:1 Digital Inputs, Switch Functions");
    EXPECT_EQ(field("2003h:1", "type"), "UNSIGNED16, read by SDO, written by RPDO only");
    EXPECT_EQ(titles("2000h07"), "object 2000h:7 Digital Outputs, Engine State");
    EXPECT_EQ(field("2005h", "type"), "UNSIGNED16, read by SDO, cannot be written");
    EXPECT_EQ(field("2001h:52", "type"), "UNSIGNED16, read by SDO, cannot be written");
    EXPECT_EQ(field("2002h:1", "type"), "INTEGER16, read by SDO, cannot be written");
    EXPECT_EQ(field("1804h:1", "comes from").substr(0, 13), "gateway 16404");
    EXPECT_EQ(titles("2004h:0"), "object 2004h:0 Analog Inputs");
}

TEST_F(Explain, every_described_object_exists_and_every_object_is_described) {
    for (const cgw::catalogue::ObjectDescription& object : cgw::catalogue::shipped_objects()) {
        const std::string name =
            fmt::format("0x{:04X}{}", object.index, object.whole ? "" : fmt::format(":{}", object.last_sub));
        EXPECT_TRUE(ask(name).understood()) << name;
    }
    constexpr unsigned blocks[] = {0x1000, 0x1010, 0x1200, 0x1280, 0x1400, 0x1600, 0x1800, 0x1A00, 0x2000};
    for (const unsigned block : blocks) {
        for (unsigned index = block; index < block + 0x10; ++index) {
            const bool described = cgw::catalogue::find_object(static_cast<std::uint16_t>(index)) != nullptr;
            EXPECT_EQ(ask(fmt::format("0x{:04X}", index)).understood(), described) << index;
        }
    }
}

TEST_F(Explain, an_object_that_is_not_there_is_refused) {
    EXPECT_EQ(
        complaint("1010h"),  // D42
        "the gateway has no object 1010h | a number of four decimal digits without 0x or h is a parameter");
    EXPECT_EQ(complaint("1018h:5"), "the gateway has no object 1018h:5");
    EXPECT_EQ(complaint("2001h:53"), "the gateway has no object 2001h:53");
}

// --- values ---

TEST_F(Explain, bits_of_2005h_are_taken_apart) {
    EXPECT_EQ(titles("2005h=0x0102"), "2005h CanOpen Errors = 0x0102");
    EXPECT_TRUE(field("2005h=0x0102", "bit 1").starts_with("12412 CanOpInitErr / cause: "));
    EXPECT_TRUE(field("2005h=0x0102", "bit 8").starts_with("12419 CanOpGWResetErr / cause: "));
    EXPECT_NE(field("2005h=0x0102", "bit 8").find("clears: "), std::string::npos);
    EXPECT_EQ(field("2005h=0x0102", "bit 0"), "-");
    EXPECT_EQ(field("2005h=0x0020", "bit 5"), "no meaning is known: free, or not printed");
    EXPECT_EQ(field("2005h = 0", "bits"), "none is set");
}

TEST_F(Explain, error_bits_name_the_errors_of_both_devices) {
    const std::string bus = field("2000h:5=0x40", "bit 6");
    EXPECT_NE(bus.find("governor 3070 ErrCanBus"), std::string::npos) << bus;
    EXPECT_NE(bus.find("gateway 3070 ErrCanBus1"), std::string::npos) << bus;
    EXPECT_EQ(field("2000h:1=4", "bit 2"), "error 3002: no document names it, see the governor's own manual");
    EXPECT_EQ(titles("3001=1"), "error 3001 = 1");
    EXPECT_EQ(field("3001=1", "this value"), "the error is there");
    EXPECT_EQ(field("3001=0", "this value"), "the error is not there");
    EXPECT_EQ(field("3001=2", "range"), "outside 0..1");
    EXPECT_EQ(field("3001=1", "seen in"), "bit 1 of 2000h:1");
    EXPECT_TRUE(field("2000h:5=0x400", "bit 10").starts_with("3074 ErrCanOpen / cause: "));
}

TEST_F(Explain, bits_of_words_have_their_names) {
    EXPECT_TRUE(field("2003h:1=0b100", "bit 2").starts_with("Switch3: "));
    EXPECT_TRUE(field("2003h:2=0x800", "bit 11").starts_with("SensorError12: "));
    EXPECT_TRUE(field("2000h:7=1", "bit 0").starts_with("EngineState0: "));
    EXPECT_TRUE(field("1001h=0x11", "bit 4").starts_with("CommunicationError: "));
    EXPECT_EQ(field("2411=2", "bit 1"), "Node1: the governor with node number 1 is heard");
    EXPECT_EQ(field("2411=1", "bit 0"), "no meaning is known");
    EXPECT_EQ(field("CanDCNodeState15to01=0", "bits"), "none is set");
    EXPECT_EQ(field("3099=0x20", "bit 5").substr(0, 15), "ParameterPages:");
}

TEST_F(Explain, values_with_a_meaning_say_it) {
    EXPECT_EQ(titles("3800=9"), "gateway bootloader 3800 TestStatus = 9");
    EXPECT_NE(field("3800=9", "this value").find("check sum wrong"), std::string::npos);
    EXPECT_NE(field("3095=3", "this value").find("watchdog"), std::string::npos);
    EXPECT_EQ(field("4416=1", "this value"), "bit timing registers 410..414");
    EXPECT_NE(field("12412=1", "cause"), "-");
    EXPECT_EQ(field("12412=0", "cause"), "-");
}

TEST_F(Explain, a_value_is_held_against_its_range) {
    EXPECT_EQ(field("426=300", "range"), "outside 125, 250, 500 or 1000 kbit/s");
    EXPECT_EQ(field("426=250", "range"), "within 125, 250, 500 or 1000 kbit/s");
    EXPECT_EQ(field("427=0", "range"), "outside 1..127");
    EXPECT_EQ(titles("429=100"), "gateway 429 CanOpHeartBeatTxTime = 100 ms");
}

TEST_F(Explain, words_that_are_no_bits_are_decoded) {
    EXPECT_EQ(field("1804h:1=0x80000282", "identifier"), "282h (642)");
    EXPECT_EQ(field("1804h:1=0x80000282", "active"), "no, bit 31 is set");
    EXPECT_EQ(field("1400h:1=0x201", "active"), "yes, bit 31 is 0");
    EXPECT_EQ(field("1A03h:1=0x20010110", "maps"), "2001h:1, 16 bits");
    EXPECT_EQ(field("1A03h:2=0", "maps"), "nothing");
    EXPECT_EQ(field("1016h:1=0x007F0060", "partner"), "node 127");
    EXPECT_EQ(field("1016h:1=0x007F0060", "time"), "96 ms, effective");
    EXPECT_EQ(field("1016h:1=0", "partner"), "nobody is monitored");
}

TEST_F(Explain, numbers_are_not_taken_for_bits) {
    EXPECT_EQ(field("1017h=800", "time"), "800 ms, effective");
    EXPECT_EQ(field("1017h=0", "time"), "0: none");
    EXPECT_EQ(field("1800h:5=100", "time"), "100 ms, effective");
    EXPECT_EQ(field("1018h:3=104", "number"), "104 (68h)");
    EXPECT_EQ(field("1018h:4=0x09170005", "number"), "3844 is 2327, 3845 is 5");
    EXPECT_EQ(field("1200h:1=0x601", "identifier"), "601h (1537)");
    EXPECT_EQ(field("1800h:2=254", "number"), "254");
    EXPECT_EQ(field("1800h:2=1", "number"), "1, which the gateway never has");
    EXPECT_TRUE(field("2001h:1=100", "word").starts_with("100; what it means depends on the configuration"));
    EXPECT_TRUE(field("2002h:1=0xFFFF", "word").starts_with("-1; "));
    for (const char* question : {"1017h=800", "1018h:3=104", "1800h:5=100", "1200h:1=0x601", "2001h:1=100"}) {
        EXPECT_EQ(cgw::explain::render_text(std::vector{ask(question)}).find("no meaning"), std::string::npos)
            << question;
    }
}

TEST_F(Explain, a_time_says_what_the_device_makes_of_it) {  // D8, D9
    EXPECT_EQ(field("16460=100", "effective"), "93.75 ms: 6 main cycles of 15.625 ms, the default");
    EXPECT_EQ(field("16460=100", "monitoring"), "-");
    EXPECT_EQ(field("16480=100", "monitoring"),
              "a sender that keeps to 100 ms is missed after 93.75 ms already (D9) / "
              "110 ms is the next time that works: 7 main cycles, 109.375 ms");
    EXPECT_EQ(field("430=100", "effective"), "96 ms: 6 main cycles of 16 ms");
    EXPECT_EQ(field("430=100", "monitoring"),
              "a sender that keeps to 100 ms is missed after 96 ms already (D9) / "
              "112 ms is the next time that works: 7 main cycles, 112 ms");
    EXPECT_EQ(field("430=112", "monitoring"), "-");
    EXPECT_EQ(field("16480=3990", "monitoring"),
              "a sender that keeps to 3990 ms is missed after 3984.375 ms already (D9) / "
              "no longer time is possible: let the sender send more often");
    EXPECT_EQ(field("16460=5000", "effective"),
              "none: the device counts at most 255 main cycles of 15.625 ms");
    EXPECT_EQ(field("429=0", "effective"), "-");
}

TEST_F(Explain, every_settable_parameter_of_the_gateway_feeds_something) {
    for (const cgw::parameter::Row& row : cgw::catalogue::shipped_rows()) {
        if (row.device == cgw::parameter::Device::gateway && row.settable()) {
            EXPECT_FALSE(row.used.empty()) << row.number;
        }
    }
    EXPECT_EQ(field("426", "feeds"), "no object; the bit rate of CAN2 while 4426 is 0, Baudrate of the DCF");
}

TEST_F(Explain, parameters_that_both_devices_hold_name_each_other) {
    EXPECT_EQ(field("402", "partner"), "governor 401 CanMyNodeNumber: they must agree");
    EXPECT_EQ(field("401", "partner", 0), "gateway 402 CanDCNodeNumber: they must agree");
    EXPECT_EQ(field("401", "partner", 1), "governor 403 CanCMNodeNumber: they must agree");
    EXPECT_EQ(field("416", "partner", 1), "governor 416 CanBaudrate: one bus, one bit rate");
    EXPECT_EQ(field("400", "partner", 1), "governor 400 CanStartTimeOutDelay: set both alike");
    EXPECT_EQ(field("427", "partner"), "-");
}

TEST_F(Explain, a_parameter_names_the_pages_of_its_manual) {
    EXPECT_EQ(field("400", "pages", 1), "27, 29 of GWM");
    EXPECT_EQ(field("1800", "pages"), "-");
}

TEST_F(Explain, values_that_cannot_be_are_refused) {
    EXPECT_EQ(complaint("2000h=3"), "2000h has several entries | say which: 2000h:1=3");
    EXPECT_EQ(complaint("2005h=0x10000"), "10000h does not fit 2005h, which has 16 bits");
    EXPECT_EQ(complaint("1001h=256"), "100h does not fit 1001h, which has 8 bits");
    EXPECT_EQ(complaint("2000h:1=0x10000"), "10000h does not fit 2000h:1, which has 16 bits");
    EXPECT_EQ(complaint("1010h=1"), "the gateway has no object 1010h");
    EXPECT_EQ(complaint("2005h=many"), "`many` is no value: write 5, 0x0102 or 102h");
    EXPECT_EQ(complaint("2005h="), "`` is no value: write 5, 0x0102 or 102h");
    EXPECT_EQ(complaint("2999=1"), "nothing is known about `2999`");
    EXPECT_EQ(complaint("CanOpenMyNodID=1"),
              "nothing is known about `CanOpenMyNodID` | did you mean `CanOpenMyNodeID`?");
}

// --- codes ---

TEST_F(Explain, a_rule_says_why_and_shows_itself) {
    EXPECT_EQ(titles("e0203"), "E0203 node-id-duplicate (error)");
    EXPECT_EQ(titles("Node-ID-duplicate"), "E0203 node-id-duplicate (error)");
    for (const char* label : {"demands", "why", "bad", "good", "source"}) {
        EXPECT_NE(field("E0203", label), "-") << label;
    }
}

TEST_F(Explain, every_rule_is_explained_by_code_and_by_name) {
    for (const cgw::diagnostic::Rule* rule : cgw::diagnostic::all_rules()) {
        EXPECT_EQ(titles(rule->code), titles(rule->name)) << rule->code;
        EXPECT_NE(field(rule->code, "why"), "-") << rule->code;
        const bool can_be_hidden = rule->level != cgw::diagnostic::Level::error;
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
    for (const cgw::explain::QuestionForm& form : cgw::explain::question_forms()) {
        EXPECT_TRUE(ask(form.example).understood()) << form.example;
    }
}

// --- rendering ---

TEST_F(Explain, no_answer_is_wider_than_a_terminal) {
    std::vector<Answer> answers;
    for (const cgw::parameter::Row& row : cgw::catalogue::shipped_rows()) {
        answers.push_back(ask(fmt::format("{}", row.number)));
    }
    for (const char* question : {"2005h=0x3FFF", "2000h:5=0xFFFF", "sensor-error", "2003h:1", "1A03h"}) {
        answers.push_back(ask(question));
    }
    std::istringstream lines(render_text(answers));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(cgw::explain::width_of(line), 80U) << line;
    }
}

TEST_F(Explain, answers_look_as_they_did) {
    const std::vector<Answer> answers = {ask("12412"), ask("2005h=0x0102"), ask("16404"), ask("2003h:1"),
                                         ask("E0203"), ask("0x06010002"),   ask("3800=9")};
    cgw::test::expect_golden("explain/answers.txt", render_text(answers));
    cgw::test::expect_golden("explain/answers.json", render_json(answers));
}

}  // namespace
