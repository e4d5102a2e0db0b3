// Questions and answers about values: bits, ranges, times.
#include "explain/answers.hpp"

namespace cgw::explain {
namespace {

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
    EXPECT_EQ(field("1018h:3=104", "number"), "104 (0x68)");
    EXPECT_EQ(field("1018h:4=0x09170005", "number"), "3844 is 2327, 3845 is 5");
    EXPECT_EQ(field("1200h:1=0x601", "identifier"), "601h (1537)");
    EXPECT_EQ(field("1800h:2=254", "number"), "254");
    EXPECT_EQ(field("1800h:2=1", "number"), "1, which the gateway never has");
    EXPECT_TRUE(field("2001h:1=100", "word").starts_with("100; what it means depends on the configuration"));
    EXPECT_TRUE(field("2002h:1=0xFFFF", "word").starts_with("-1; "));
    for (const char* question : {"1017h=800", "1018h:3=104", "1800h:5=100", "1200h:1=0x601", "2001h:1=100"}) {
        EXPECT_EQ(render_text(std::vector{ask(question)}).find("no meaning"), std::string::npos) << question;
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

TEST_F(Explain, values_that_cannot_be_are_refused) {
    EXPECT_EQ(complaint("2000h=3"), "2000h has several entries | say which: 2000h:1=3");
    EXPECT_EQ(complaint("2005h=0x10000"), "0x10000 does not fit 2005h, which has 16 bits");
    EXPECT_EQ(complaint("1001h=256"), "0x100 does not fit 1001h, which has 8 bits");
    EXPECT_EQ(complaint("2000h:1=0x10000"), "0x10000 does not fit 2000h:1, which has 16 bits");
    EXPECT_EQ(complaint("1010h=1"), "the gateway has no object 1010h");
    EXPECT_EQ(complaint("2005h=many"), "`many` is no value: write 5, 0x0102 or 102h");
    EXPECT_EQ(complaint("2005h="), "`` is no value: write 5, 0x0102 or 102h");
    EXPECT_EQ(complaint("2999=1"), "nothing is known about `2999`");
    EXPECT_EQ(complaint("CanOpenMyNodID=1"),
              "nothing is known about `CanOpenMyNodID` | did you mean `CanOpenMyNodeID`?");
}

TEST_F(Explain, a_switch_value_is_a_bit_and_a_sensor_value_a_channel) {
    EXPECT_EQ(field("827=-5", "means"), "with 4827 = 3: bit 5 of RPDO1 word 1, low-active");
    EXPECT_EQ(field("827=16", "means"), "with 4827 = 3: bit 16 of RPDO1 word 1, high-active");
    EXPECT_EQ(field("835=17", "means"), "with 4835 = 3: refused, RPDO1 word 1 has bits 1..16 (E0210)");
    EXPECT_EQ(field("835=0", "means"), "with 4835 = 3: no bit, it does not come over CANopen (D27)");
    EXPECT_EQ(field("900=6", "means"), "with 4900 = 3: word 2 of RPDO3, 2004h:6");
    EXPECT_EQ(field("900=13", "means"), "with 4900 = 3: refused, there are channels 1..12 (E0211)");
    EXPECT_EQ(field("900=-1", "means"), "with 4900 = 3: refused, there are channels 1..12 (E0211)");
}

TEST_F(Explain, an_assigned_number_is_a_measurement) {
    EXPECT_TRUE(field("16400=2000", "means").starts_with("sends 2000 Speed: "))
        << field("16400=2000", "means");
    EXPECT_EQ(field("16400=0", "means"), "nothing is sent; words behind it close up (D23)");
    EXPECT_EQ(field("16400=2999", "means"),
              "refused, unless 2999 is declared: no catalogue knows it (E0213)");
    EXPECT_TRUE(field("16451=2810", "means").starts_with("refused, 2810 "));
    EXPECT_EQ(field("16400=30000", "means"), "-");  // outside its range already
}

TEST_F(Explain, a_value_of_a_misprinted_number_is_one_of_the_number_meant) {  // D2
    EXPECT_EQ(titles("409=250"), "governor 416 CanBaudrate = 250 kbit/s");
}

TEST_F(Explain, parameters_take_signs_and_fractions) {
    EXPECT_EQ(titles("978=0.5"), "governor 978 CoolPressSensorLow = 0.5 bar");
    EXPECT_EQ(titles("978=0,5"), "governor 978 CoolPressSensorLow = 0.5 bar");  // D12
    EXPECT_EQ(field("429=1.5", "range"), "no whole number, and it takes no other");
    EXPECT_EQ(field("427=-1", "range"), "outside 1..127");
    EXPECT_EQ(complaint("427=1e3"),
              "`1e3` is no value: write 5, 0x0102 or 102h, for a parameter also -5 or 1.5");
    EXPECT_EQ(complaint("2005h=-1"), "`-1` is no value: write 5, 0x0102 or 102h");
    EXPECT_EQ(complaint("427=--1").substr(0, 5), "`--1`");
}

}  // namespace
}  // namespace cgw::explain
