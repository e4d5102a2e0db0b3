#include "authoring/parameter_file_text.hpp"

#include <gtest/gtest.h>

#include "catalogue/catalogue.hpp"

namespace cgw::authoring {
namespace {

using parameter::Device;

class ParameterFileText : public testing::Test {
  protected:
    WrittenValue value(Device device, std::uint16_t number, std::string literal) const {
        return {catalogue_.find(device, number), std::move(literal)};
    }

    std::string text(const Draft& draft) const { return parameter_file_text(draft, catalogue_); }

    parameter::Catalogue catalogue_{catalogue::shipped_rows()};
};

TEST_F(ParameterFileText, begins_with_remarks_format_and_title) {
    Draft draft;
    draft.title = "a \"b\"";
    draft.remarks = {"one", "two"};
    EXPECT_EQ(text(draft),
              "# one\n# two\nformat = 1\ntitle = \"a "
              "\\\"b\\\"\"\n\n[governor.parameters]\n\n[gateway.parameters]\n");
}

TEST_F(ParameterFileText, names_parameters_with_text_and_unit) {
    Draft draft;
    draft.governor = {value(Device::governor, 400, "1.0"), value(Device::governor, 902, "2")};
    draft.gateway = {value(Device::gateway, 16405, "0x682")};
    const std::string written = text(draft);
    EXPECT_NE(written.find(
                  "counts as an error; set all devices alike\n\"400 CanStartTimeOutDelay\" = 1.0    # s\n"),
              std::string::npos)
        << written;
    EXPECT_NE(written.find("\n902 = 2\n"), std::string::npos) << written;
    EXPECT_NE(written.find("\"16405 CanOpTPDO5-16ID(1)\" = 0x682\n"), std::string::npos) << written;
}

TEST_F(ParameterFileText, writes_a_list_only_for_a_short_array_that_is_whole) {
    Draft draft;
    const std::vector<std::uint16_t> numbers = {16400, 16401, 16402, 16403, 16404, 16405, 16460, 16461};
    for (const std::uint16_t number : numbers) {
        draft.governor.push_back(value(Device::governor, number, number == 16401 ? "2031" : "0"));
    }
    const std::string written = text(draft);
    EXPECT_NE(written.find("\"16400 CanOpTPDO4Assign\" = [0, 2031, 0, 0]    # -, SpeedSetp, -, -\n"),
              std::string::npos)
        << written;
    EXPECT_NE(written.find("\"16404 CanOpTPDO5Assign(0)\" = 0\n"), std::string::npos) << written;
    EXPECT_NE(written.find("\"16461 CanOpTPDO4-16Cyc(1)\" = 0    # ms\n"), std::string::npos) << written;
}

}  // namespace
}  // namespace cgw::authoring
