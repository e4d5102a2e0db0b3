// What is no device description of CiA 311, and what it is instead.
#include <gtest/gtest.h>

#include "xdd/reader.hpp"
#include "xdd/reading_result.hpp"

namespace cgw::xdd {
namespace {

std::string message_of(std::string_view text) {
    return test::XddResult(text).message();
}

}  // namespace

TEST(XddKinds, tells_files_of_other_systems) {
    EXPECT_EQ(message_of("set_property PACKAGE_PIN W5 [get_ports clk]\n"),
              "this is a file of FPGA design constraints (.xdc of Xilinx), no CANopen configuration");
    EXPECT_EQ(message_of("<ISO15745ProfileContainer xmlns=\"http://www.ethernet-powerlink.org\"/>"),
              "this is a device description for Ethernet POWERLINK, not for CANopen");
    EXPECT_EQ(message_of("<X><Profile><ProfileBody/></Profile></X>"),
              "this is a device description of maxon's own form, not of CiA 311");
    EXPECT_EQ(message_of("<EtherCATInfo/>"),
              "this is a device description for EtherCAT (ESI), not for CANopen");
    EXPECT_EQ(message_of("<OpenEDSProject/>"),
              "this is a project of several devices; each of them needs a file of its own");
    EXPECT_EQ(message_of("<html/>"),
              "the file begins with <html>; a device description of CiA 311 begins with "
              "<ISO15745ProfileContainer>");
    EXPECT_EQ(message_of("<ISO15745ProfileContainer/>"),
              "the file has no CANopenObjectList: it describes no object of a CANopen device");
    EXPECT_EQ(message_of("[FileInfo]\n"), "this is an EDS or DCF, no XML");
}

TEST(XddKinds, knows_utf_16_and_says_so) {
    for (const std::string_view begin :
         {std::string_view("\xFF\xFE<\0", 4), std::string_view("\xFE\xFF\0<", 4),
          std::string_view("<\0?\0", 4), std::string_view("\0<\0?", 4)}) {
        EXPECT_TRUE(is_xml(begin));
        EXPECT_EQ(message_of(begin), "the file is UTF-16; save it as UTF-8");
    }
    EXPECT_FALSE(is_xml(std::string_view("\xFF\xFE[\0", 4)));
    EXPECT_FALSE(is_xml("\xFF\xFE"));
}

TEST(XddKinds, knows_xml_when_it_sees_it) {
    EXPECT_TRUE(is_xml("\xEF\xBB\xBF\n <?xml"));
    EXPECT_TRUE(is_xml("<a/>"));
    EXPECT_FALSE(is_xml(""));
    EXPECT_FALSE(is_xml("[FileInfo]\n; <a>"));
}

}  // namespace cgw::xdd
