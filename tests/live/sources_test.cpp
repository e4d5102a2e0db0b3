#include "live/sources.hpp"

#include "live_test.hpp"

namespace cgw::live {
namespace {

class SourcesOfObjects : public testing::Test {
  protected:
    std::string text(std::uint16_t index, std::uint8_t sub_index) const {
        return sources(index, sub_index).text;
    }
    Sources sources(std::uint16_t index, std::uint8_t sub_index) const {
        return sources_of(index, sub_index, built_.file.settings, *built_.file.catalogue);
    }
    test::Built built_{test::small_plant()};
};

TEST_F(SourcesOfObjects, name_the_parameter_with_its_value) {
    EXPECT_EQ(text(0x1804, 1),
              "gateway 16404 CanOpTPDO5-16ID(0)=0x282; assignment and cycle time in the governor decide "
              "whether it "
              "is active");
    EXPECT_EQ(text(0x1804, 5), "governor 16461 CanOpTPDO4-16Cyc(1)=100");
    EXPECT_EQ(text(0x1017, 0), "gateway 429 CanOpHeartBeatTxTime=1008");
}

TEST_F(SourcesOfObjects, list_the_parameters) {
    const Sources found = sources(0x1016, 1);
    ASSERT_EQ(found.parameters.size(), 2U);
    EXPECT_EQ(found.parameters[0].row->number, 428);
    EXPECT_EQ(found.parameters[0].row->device, parameter::Device::gateway);
    EXPECT_EQ(found.parameters[1].value, 0);
}

TEST_F(SourcesOfObjects, leave_ranges_as_they_are) {
    EXPECT_EQ(text(0x2001, 0), "governor 16400..16451");
    EXPECT_TRUE(sources(0x2001, 0).parameters.empty());
    EXPECT_EQ(text(0x1A04, 1), "the governor's CanOpTPDO5Assign(0..3)");
}

TEST_F(SourcesOfObjects, are_empty_for_what_no_parameter_decides) {
    EXPECT_EQ(text(0x1018, 1), "");
    EXPECT_EQ(text(0x6000, 0), "");
}

}  // namespace
}  // namespace cgw::live
