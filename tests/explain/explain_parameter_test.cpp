// Questions and answers about parameters and errors.
#include "explain/answers.hpp"

namespace cgw::explain {
namespace {

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

TEST_F(Explain, every_settable_parameter_of_the_gateway_feeds_something) {
    for (const parameter::Row& row : catalogue::shipped_rows()) {
        if (row.device == parameter::Device::gateway && row.settable()) {
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

TEST_F(Explain, a_wrong_name_behind_a_number_leads_to_the_right_one) {
    EXPECT_EQ(complaint("427 CanCommBaud"),
              "nothing is known about `427 CanCommBaud` | there is 427 CanOpenMyNodeID of the gateway");
    EXPECT_EQ(complaint("node-id-dup"),
              "nothing is known about `node-id-dup` | did you mean `node-id-duplicate`?");
    EXPECT_EQ(complaint("xyz 9"), "nothing is known about `xyz 9`");
}

}  // namespace
}  // namespace cgw::explain
