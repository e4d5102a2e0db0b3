// A small catalogue made by hand and short ways to read a file and to say what came out.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "input/parameter_file.hpp"

namespace cgw::test {

using parameter::Base;
using parameter::Device;
using parameter::List;
using parameter::Row;

inline constexpr std::array<std::uint32_t, 4> bit_rates{125, 250, 500, 1000};
inline constexpr std::array<std::string_view, 1> misprint_409{"409 CanBaudrate"};
inline constexpr std::array<std::string_view, 1> misprint_4409{"4409 CanSegmentOrBaudrate"};
inline constexpr std::array<std::string_view, 1> misprint_4901{"4901 ChanType_Setp1Ext"};
inline constexpr std::array<std::string_view, 1> alias_4416{"HzmCanSegmentOrBaudrate"};

inline Row row(Device device, std::uint16_t number, std::string_view name, double minimum, double maximum) {
    Row result;
    result.device = device;
    result.number = number;
    result.name = name;
    result.minimum = minimum;
    result.maximum = maximum;
    return result;
}

// Sorted by device and number, as Catalogue wants it.
inline std::vector<Row> make_rows() {
    std::vector<Row> rows;
    const auto add = [&](Row one) -> Row& { return rows.emplace_back(one); };
    const auto bit_rate = [](Row& one) {
        one.choices = bit_rates;
        one.unit = "kbit/s";
    };
    const auto array = [&](Device device, std::uint16_t first, std::string_view name, std::uint16_t size,
                           std::uint16_t list_end, double maximum, Base base) {
        static std::deque<std::string> names;
        for (std::uint16_t i = 0; i < size; ++i) {
            Row& one = add(row(device, static_cast<std::uint16_t>(first + i),
                               names.emplace_back(fmt::format("{}({})", name, i)), 0, maximum));
            one.list = List::curve;
            one.array_first = first;
            one.array_size = size;
            one.list_end = list_end;
            one.base = base;
        }
    };
    const Device governor = Device::governor;
    Row& delay = add(row(governor, 400, "CanStartTimeOutDelay", 0, 100));
    delay.decimal = true;
    delay.unit = "s";
    add(row(governor, 401, "CanMyNodeNumber", 1, 31));
    add(row(governor, 403, "CanCMNodeNumber", 1, 31));
    Row& rate = add(row(governor, 416, "CanBaudrate", 125, 1000));
    bit_rate(rate);
    rate.misprints = misprint_409;
    Row& nameless = add(row(governor, 812, "", -32768, 32767));
    nameless.role = parameter::Role::switch_assignment;
    Row& speed = add(row(governor, 2000, "Speed", 0, 4000));
    speed.list = List::measurement;
    speed.width = 16;
    add(row(governor, 4406, "CanCommCMOn", 0, 1));
    add(row(governor, 4416, "CanSegmentOrBaudrate", 0, 1)).misprints = misprint_4409;
    add(row(governor, 4900, "ChanType_Setp1Ext", 0, 4));
    add(row(governor, 4901, "ChanType_Setp2Ext", 0, 4)).misprints = misprint_4901;
    array(governor, 16400, "CanOpTPDO4Assign", 4, 16407, 29999, Base::decimal);
    array(governor, 16404, "CanOpTPDO5Assign", 4, 16407, 29999, Base::decimal);
    array(governor, 16460, "CanOpTPDO4-16Cyc", 3, 0, 65535, Base::decimal);

    const Device gateway = Device::gateway;
    add(row(gateway, 401, "CanMyNodeNumber", 1, 31));
    add(row(gateway, 402, "CanDCNodeNumber", 1, 31));
    bit_rate(add(row(gateway, 416, "HzmCanBaudrate", 125, 1000)));
    bit_rate(add(row(gateway, 426, "CanOpenBaudrate", 125, 1000)));
    add(row(gateway, 427, "CanOpenMyNodeID", 1, 127));
    add(row(gateway, 429, "CanOpHeartBeatTxTime", 0, 65535)).unit = "ms";
    Row& state = add(row(gateway, 2401, "CanTxBufferState", 0, 65535));
    state.list = List::measurement;
    add(row(gateway, 4400, "HzmCanCommDCon", 0, 1));
    add(row(gateway, 4416, "HzmCanSegmOrBaudrate", 0, 1)).aliases = alias_4416;
    add(row(gateway, 4426, "CanOpSegmOrBaudrate", 0, 1));
    array(gateway, 16404, "CanOpTPDO5-16ID", 12, 0, 0x7FF, Base::hexadecimal);
    return rows;
}

inline const std::vector<Row>& rows() {
    static const std::vector<Row> all = make_rows();
    return all;
}

struct Outcome {
    input::ReadResult result;
    diagnostic::Findings findings;
    std::unique_ptr<parameter::Catalogue> catalogue;  // the settings point into it

    const parameter::Settings& settings() const { return result.file.settings; }
};

using Files = std::map<std::string, std::string>;

inline Outcome read(std::string_view text, const Files& files = {}, std::span<const Row> shipped = rows(),
                    const std::string& path = "f.toml") {
    Outcome outcome;
    outcome.catalogue = std::make_unique<parameter::Catalogue>(shipped);
    const input::CatalogueLoader load = [&](const std::string& name) -> base::Result<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) {
            return base::failure("cannot open " + name);
        }
        return found->second;
    };
    outcome.result = input::read_parameter_file(text, path, *outcome.catalogue, load, outcome.findings);
    outcome.findings.sort();
    return outcome;
}

// "E0111 3:7 message | help" per finding; "fine" when there is none.
inline std::string show(const diagnostic::Findings& findings) {
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const auto& start = finding.where.range.start;
        const std::string path = finding.where.path == "f.toml" ? "" : finding.where.path + ":";
        text += fmt::format("{}{} {}{}:{} {}", text.empty() ? "" : "\n", finding.rule->code, path, start.line,
                            start.column, finding.message);
        for (const diagnostic::Related& related : finding.related) {
            text += fmt::format(" [{} {}:{}]", related.message, related.where.range.start.line,
                                related.where.range.start.column);
        }
        text += finding.help.empty() ? "" : " | " + finding.help;
    }
    return text.empty() ? "fine" : text;
}

// A complete file around the lines under test, which begin at line 3 or 30.
inline const std::string head = "format = 1\ntitle = \"t\"\n";
inline const std::string governor = "[governor.parameters]\n401 = 1\n403 = 1\n416 = 250\n";  // 4 lines
inline const std::string gateway =
    "[gateway.parameters]\n401 = 1\n402 = 1\n416 = 250\n426 = 125\n427 = 1\n";  // 6 lines

// Findings with `lines` in [governor.parameters], from line 13 on.
inline std::string governor_findings(const std::string& lines) {
    return show(read(head + gateway + governor + lines).findings);
}

// Findings with `lines` in [gateway.parameters], from line 13 on.
inline std::string gateway_findings(const std::string& lines) {
    return show(read(head + governor + gateway + lines).findings);
}

// Findings with `lines` at the top of the file, from line 3 on.
inline std::string top_findings(const std::string& lines) {
    return show(read(head + lines + governor + gateway).findings);
}

}  // namespace cgw::test
