// Short ways to read a printed table and to say what came out.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "catalogue/catalogue.hpp"
#include "input/parameter_table.hpp"

namespace cgw::input {

using parameter::Device;

struct Read {
    PrintedTable table;
    diagnostic::Findings findings;
};

inline Read read(std::string_view text, Device device = Device::governor) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    Read result;
    result.table = read_parameter_table(text, "t", device, catalogue, result.findings);
    result.findings.sort();
    return result;
}

// "E0501 2:3 message\n"
inline std::string text_of(const diagnostic::Findings& findings) {
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        text += fmt::format("{} {}:{} {}\n", finding.rule->code, finding.where.range.start.line,
                            finding.where.range.start.column, finding.message);
    }
    return text;
}

inline std::string findings_in(std::string_view text, Device device = Device::governor) {
    return text_of(read(text, device).findings);
}

// "401=1 16404=0x282"
inline std::string values_of(const PrintedTable& table) {
    std::string text;
    for (const auto& [number, value] : table.values) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", number, value.literal);
    }
    return text;
}

inline std::string values_in(std::string_view text, Device device = Device::governor) {
    const Read result = read(text, device);
    EXPECT_EQ(text_of(result.findings), "") << text;
    return values_of(result.table);
}

}  // namespace cgw::input
