// What is listed, and that nothing is lost between people's and programs' forms.
#include "explain/lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/abort_codes.hpp"
#include "catalogue/catalogue.hpp"
#include "catalogue/errors.hpp"
#include "diagnostic/rules.hpp"
#include "object/vocabulary.hpp"

namespace {

using cgw::explain::Table;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;

class ExplainLists : public testing::Test {
  protected:
    static std::size_t column(const Table& table, std::string_view key) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            if (table.columns[i].key == key) {
                return i;
            }
        }
        ADD_FAILURE() << "no column " << key;
        return 0;
    }
    // The row with this cell; empty when there is none.
    static std::vector<std::string> row(const Table& table, std::string_view key, std::string_view cell) {
        const std::size_t at = column(table, key);
        for (const auto& one : table.rows) {
            if (one[at] == cell) {
                return one;
            }
        }
        return {};
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

TEST_F(ExplainLists, every_row_has_a_cell_for_every_column) {
    for (const Table& table : {cgw::explain::parameter_list(catalogue, {}, true),
                               cgw::explain::parameter_list(catalogue, {}, false), cgw::explain::check_list(),
                               cgw::explain::code_list(catalogue, {}), cgw::explain::assumption_list()}) {
        EXPECT_FALSE(table.rows.empty()) << table.name;
        for (const auto& one : table.rows) {
            EXPECT_EQ(one.size(), table.columns.size()) << table.name;
        }
    }
}

TEST_F(ExplainLists, programs_get_every_number_of_the_catalogue) {
    const Table table = cgw::explain::parameter_list(catalogue, {}, false);
    EXPECT_EQ(table.rows.size(), cgw::catalogue::shipped_rows().size());
    EXPECT_EQ(row(table, "name", "CanOpTPDO5-16ID(3)")[column(table, "number")], "16407");
    EXPECT_EQ(row(table, "name", "CanOpTPDO5-16ID(3)")[column(table, "maximum")], "2047");
    EXPECT_EQ(row(table, "name", "ErrEEPROM")[column(table, "program")], "bootloader");
}

TEST_F(ExplainLists, people_see_an_array_in_one_line) {
    const Table table = cgw::explain::parameter_list(catalogue, {}, true);
    const auto identifiers = row(table, "name", "CanOpTPDO5-16ID(0..11)");
    ASSERT_FALSE(identifiers.empty());
    EXPECT_EQ(identifiers[column(table, "number")], "16404..16415");
    EXPECT_EQ(identifiers[column(table, "range")], "0..0x7FF");
    EXPECT_EQ(identifiers[column(table, "text")],
              "identifier of TPDO5..16; 0 only while the governor does not send it");
    EXPECT_EQ(identifiers[column(table, "used")], "1804h..180Fh:1, the COB-ID of TPDO5..16");
    EXPECT_FALSE(row(table, "number", "812..826").empty());
    EXPECT_FALSE(row(table, "number", "978").empty());
    EXPECT_TRUE(row(table, "number", "978..979").empty());
}

TEST_F(ExplainLists, merged_lines_cover_every_number_once) {
    for (const Device device : {Device::governor, Device::gateway}) {
        const Table all = cgw::explain::parameter_list(catalogue, device, false);
        const Table merged = cgw::explain::parameter_list(catalogue, device, true);
        std::size_t numbers = 0;
        for (const auto& one : merged.rows) {
            const std::string& cell = one[column(merged, "number")];
            const std::size_t dots = cell.find("..");
            numbers += dots == std::string::npos
                           ? 1
                           : static_cast<std::size_t>(std::stoi(cell.substr(dots + 2)) - std::stoi(cell) + 1);
        }
        EXPECT_EQ(numbers, all.rows.size());
    }
}

TEST_F(ExplainLists, a_device_limits_the_list) {
    const Table table = cgw::explain::parameter_list(catalogue, Device::governor, false);
    for (const auto& one : table.rows) {
        EXPECT_EQ(one[column(table, "device")], "governor");
    }
    const Table codes = cgw::explain::code_list(catalogue, Device::governor);
    EXPECT_TRUE(row(codes, "name", "ErrCanBus1").empty());
    EXPECT_TRUE(row(codes, "code", "0x06010002").empty());
    EXPECT_FALSE(row(codes, "code", "switch-error").empty());
}

TEST_F(ExplainLists, checks_are_all_rules) {
    const Table table = cgw::explain::check_list();
    EXPECT_EQ(table.rows.size(), cgw::diagnostic::all_rules().size());
    EXPECT_EQ(row(table, "code", "E0203")[column(table, "name")], "node-id-duplicate");
}

TEST_F(ExplainLists, codes_are_errors_of_both_devices_and_abort_codes) {
    const Table table = cgw::explain::code_list(catalogue, {});
    EXPECT_EQ(row(table, "name", "CanOpInitErr")[column(table, "seen_in")], "2005h bit 1");
    EXPECT_EQ(row(table, "name", "ErrVoltage")[column(table, "seen_in")], "2000h:6 bit 5");
    EXPECT_EQ(row(table, "name", "ErrEEPROM")[column(table, "seen_in")], "");
    EXPECT_EQ(row(table, "code", "0x06010002")[column(table, "name")], "sent by the gateway");
    std::size_t errors = 0;
    for (const cgw::catalogue::ErrorDescription& error : cgw::catalogue::shipped_errors()) {
        errors += (error.governor ? 1U : 0U) + (error.gateway ? 1U : 0U);
    }
    EXPECT_EQ(table.rows.size(), errors + cgw::base::abort_codes().size());
}

TEST(ExplainAbortCodes, those_the_gateway_sends_say_when_and_what_to_do) {  // GWM 5.2, D51
    using cgw::object::AbortCode;
    std::set<std::uint32_t> sent;
    for (const cgw::base::AbortCodeRow& row : cgw::base::abort_codes()) {
        EXPECT_FALSE(row.meaning.empty());
        EXPECT_EQ(row.gateway.empty(), row.action.empty()) << row.code;
        if (!row.gateway.empty()) {
            sent.insert(row.code);
        }
    }
    const auto number = [](AbortCode code) { return static_cast<std::uint32_t>(code); };
    EXPECT_EQ(sent, (std::set<std::uint32_t>{
                        number(AbortCode::command_unknown), number(AbortCode::read_only),
                        number(AbortCode::object_missing), number(AbortCode::length_too_high),
                        number(AbortCode::length_too_low), number(AbortCode::sub_index_missing)}));
}

TEST(ExplainAbortCodes, are_found_by_code) {
    EXPECT_EQ(cgw::base::find_abort_code(0x06090011)->code, 0x06090011U);
    EXPECT_EQ(cgw::base::find_abort_code(0x06090012), nullptr);
}

}  // namespace
