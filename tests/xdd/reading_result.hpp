// A text read as XDD or XDC, with what the reader told.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "xdd/reader.hpp"

namespace cgw::test {

struct XddResult {
    explicit XddResult(std::string_view text) : sheet(xdd::read(text, "a.xdd", findings)) { findings.sort(); }

    // "line:column name" of each finding.
    std::string told() const {
        std::string text;
        for (const diagnostic::Diagnostic& finding : findings.all()) {
            text += fmt::format("{}:{} {}\n", finding.where.range.start.line,
                                finding.where.range.start.column, finding.rule->name);
        }
        return text;
    }
    std::string message() const {
        return findings.all().size() == 1 ? findings.all().front().message
                                          : fmt::format("{} findings", findings.all().size());
    }
    const dictionary::Variable& variable(std::uint16_t index, std::uint8_t sub = 0) const {
        static const dictionary::Variable none;
        const dictionary::Variable* const found = sheet.dictionary.find(index, sub);
        EXPECT_NE(found, nullptr) << fmt::format("{:04X}:{}\n{}", index, sub, told());
        return found != nullptr ? *found : none;
    }

    diagnostic::Findings findings;
    xdd::Sheet sheet;
};

// A device description of these parameters and objects, without prefixes, as many tools write it: the
// parameters begin in line 2, the objects behind them.
inline std::string device_description(std::string_view parameters, std::string_view objects,
                                      std::string_view network = "", std::string_view device = "") {
    return fmt::format(
        "<ISO15745ProfileContainer xmlns=\"http://www.canopen.org/xml/1.0\"><ISO15745Profile><ProfileBody>"
        "{}<ApplicationProcess><parameterList>\n"
        "{}</parameterList></ApplicationProcess></ProfileBody></"
        "ISO15745Profile><ISO15745Profile><ProfileBody>"
        "<ApplicationLayers><CANopenObjectList>\n"
        "{}</CANopenObjectList></ApplicationLayers>{}</ProfileBody></ISO15745Profile>"
        "</ISO15745ProfileContainer>\n",
        device, parameters, objects, network);
}

}  // namespace cgw::test
