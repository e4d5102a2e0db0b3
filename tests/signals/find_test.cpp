// Frames and signals by the names that people use.
#include <gtest/gtest.h>

#include "signal_support.hpp"
#include "signals/find.hpp"

namespace cgw::signals {
namespace {

class Find : public testing::Test {
  protected:
    std::string found(std::string_view frame, std::string_view name) const {
        const FoundSignal result = find_signal(test::frame_named(frames, frame), name);
        return result.ambiguous ? "ambiguous" : result.signal != nullptr ? result.signal->name : "";
    }

    std::vector<Frame> frames = test::frames_of(test::manual_configuration());
};

}  // namespace

TEST_F(Find, frames_by_name_and_identifier) {
    for (const char* const name : {"RPDO2", "rpdo2", "0x301", "301h", "301H"}) {
        ASSERT_NE(find_frame(frames, name), nullptr) << name;
        EXPECT_EQ(find_frame(frames, name)->name, "RPDO2");
    }
    for (const char* const name : {"", "RPDO5", "TPDO3", "301", "0x", "h", "0x302"}) {
        EXPECT_EQ(find_frame(frames, name), nullptr) << name;
    }
}

TEST_F(Find, sensors_by_all_their_names) {
    for (const char* const name :
         {"AssignIn_Setp1Ext", "assignin_setp1ext", "Setp1Ext", "900", "900 AssignIn_Setp1Ext"}) {
        EXPECT_EQ(found("RPDO2", name), "AssignIn_Setp1Ext") << name;
    }
    EXPECT_EQ(found("RPDO2", "Setp3Ext"), "");
    EXPECT_EQ(found("RPDO2", ""), "");
}

TEST_F(Find, switches_and_flags_of_one_frame) {
    EXPECT_EQ(found("RPDO1", "LoadEnable"), "FunctLoadEnable");
    EXPECT_EQ(found("RPDO1", "835"), "FunctLoadEnable");
    EXPECT_EQ(found("RPDO1", "Setp1Ext_Error"), "AssignIn_Setp1Ext_Error");
    EXPECT_EQ(found("RPDO1", "900"), "");
}

TEST_F(Find, refuses_a_name_that_two_signals_have) {
    config::Configuration configuration = test::empty_configuration();
    test::add_output(configuration, 4, test::row::speed);
    test::add_output(configuration, 4, test::row::speed);
    frames = test::frames_of(configuration);
    EXPECT_EQ(found("TPDO4", "2000"), "ambiguous");
    EXPECT_EQ(found("TPDO4", "Speed"), "Speed");
    EXPECT_EQ(found("TPDO4", "speed_2"), "Speed_2");
}

TEST_F(Find, the_nearest_name) {
    EXPECT_EQ(nearest_signal(test::frame_named(frames, "RPDO2"), "Setp1Exd"), "AssignIn_Setp1Ext");
    EXPECT_EQ(nearest_signal(test::frame_named(frames, "TPDO4"), "Sped"), "Speed");
    EXPECT_EQ(nearest_signal(test::frame_named(frames, "TPDO4"), "zzzzzzzz"), "");
}

}  // namespace cgw::signals
