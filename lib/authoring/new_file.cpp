#include "authoring/new_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "authoring/toml_text.hpp"
#include "base/ascii.hpp"
#include "input/parameter_file.hpp"
#include "input/sections.hpp"
#include "parameter/value_text.hpp"

namespace cgw::authoring {
namespace {

using parameter::Device;
using parameter::Row;
using enum Start::How;

// Times are whole main cycles of their device (D8), so that nothing is rounded: 125 and 500 ms are 8 and 32
// times 15.625 ms; 800 and 2000 ms are 50 and 125 times 16 ms. Node numbers are those of the manual's
// example.
constexpr Start table[] = {
    {Device::governor, 401, preset, "1", "the HEINZMANN CAN bus between governor and gateway"},
    {Device::governor, 403, preset, "1"},
    {Device::governor, 416, fill_in},
    {Device::governor, 4406, preset, "1"},
    {Device::governor, 400, preset, "1.0"},
    {Device::governor, 14401, preset, "1", "what the plant reads"},
    {Device::governor, 14402, preset, "1"},
    {Device::governor, 16400, preset, "[2000, 2031, 2300]"},
    {Device::governor, 16460, preset, "[125]"},
    {Device::governor, 827, example, "1",
     "what the plant commands: switch functions and sensors over CANopen"},
    {Device::governor, 4827, example, "3"},
    {Device::governor, 900, example, "1"},
    {Device::governor, 4900, example, "3"},
    {Device::governor, 16480, example, "[500, 500]"},
    {Device::gateway, 401, preset, "1", "the HEINZMANN CAN bus between gateway and governor"},
    {Device::gateway, 402, preset, "1"},
    {Device::gateway, 416, fill_in},
    {Device::gateway, 4400, preset, "1"},
    {Device::gateway, 400, preset, "1.0"},
    {Device::gateway, 426, fill_in, "", "the CANopen network"},
    {Device::gateway, 427, fill_in},
    {Device::gateway, 428, fill_in, "", "", "without a partner write 0 here and at 430"},
    {Device::gateway, 429, preset, "800"},
    {Device::gateway, 430, preset, "2000", "", "without a partner (428 = 0) write 0 here as well"},
    {Device::gateway, 16404, example, "[0x282]"},
};

std::ptrdiff_t count_to_fill_in() {
    return std::count_if(std::begin(table), std::end(table),
                         [](const Start& start) { return start.how == fill_in; });
}

std::string key_of(const Row& row, bool is_list) {
    return toml_string(is_list ? fmt::format("{} {}", row.number, parameter::array_name(row))
                               : parameter::label(row));
}

// "2000 Speed, 2031 SpeedSetp": the measurements that a list of numbers names; empty for other lists.
std::string measurements(std::string_view list, const parameter::Catalogue& catalogue) {
    std::string names;
    while (!list.empty()) {
        const std::size_t digits = list.find_first_of(base::digits);
        list.remove_prefix(std::min(digits, list.size()));
        const std::size_t end = std::min(list.find_first_not_of(base::digits), list.size());
        unsigned number = 0;
        for (const char digit : list.substr(0, end)) {
            number = number * 10 + static_cast<unsigned>(digit - '0');
        }
        list.remove_prefix(end);
        const Row* row = catalogue.find(Device::governor, static_cast<std::uint16_t>(number));
        if (row != nullptr && !row->settable()) {
            names += (names.empty() ? "" : ", ") + parameter::label(*row);
        }
    }
    return names;
}

std::string text_of(const Start& start, const parameter::Catalogue& catalogue) {
    const Row& row = *catalogue.find(start.device, start.number);
    const bool is_list = start.value.starts_with('[');
    std::string text = start.heading.empty() ? "\n" : fmt::format("\n# --- {} ---\n\n", start.heading);
    text += fmt::format("# {}{}\n", start.how == fill_in ? "FILL IN: " : "", row.text);
    text += fmt::format("# {}\n", parameter::range_text(row));
    if (const std::string names = is_list ? measurements(start.value, catalogue) : ""; !names.empty()) {
        text += fmt::format("# {}\n", names);
    }
    text += start.remark.empty() ? "" : fmt::format("# {}\n", start.remark);
    const std::string_view comment = start.how == preset ? "" : "# ";
    const std::string_view blank = start.value.empty() ? "" : " ";
    return text + fmt::format("{}{} ={}{}\n", comment, key_of(row, is_list), blank, start.value);
}

std::string table_text(Device device, const parameter::Catalogue& catalogue) {
    std::string text = fmt::format("\n[{}.parameters]\n", parameter::to_text(device));
    for (const Start& start : table) {
        text += start.device == device ? text_of(start, catalogue) : "";
    }
    return text;
}

// What a key of a table with fixed keys means.
std::string_view meaning(const input::Table& keys, std::string_view name) {
    const auto key = std::find_if(keys.keys.begin(), keys.keys.end(),
                                  [&](const input::Key& candidate) { return candidate.name == name; });
    return key->text;
}

const input::Table& table_below(std::string_view name) {
    const input::Table& top = input::file_table();
    return *std::find_if(top.keys.begin(), top.keys.end(), [&](const input::Key& key) {
                return key.name == name;
            })->below;
}

}  // namespace

std::span<const Start> starts() {
    return table;
}

std::string new_file_text(std::string_view title, const parameter::Catalogue& catalogue) {
    std::string text = fmt::format(
        "# A HEINZMANN governor and its CANopen gateway: a start, written by cgw new.\n"
        "#\n"
        "# {} values cannot be guessed. Each is marked FILL IN: write the value behind\n"
        "# the = and remove the # in front of the line. Then run cgw check on this file.\n"
        "# Whatever is not set is 0, that is, off; cgw explain tells about a parameter.\n"
        "\n"
        "format = {}\n\n# {}\n",
        count_to_fill_in(), input::parameter_file_format, meaning(input::file_table(), "title"));
    text += title.empty() ? "# title = \"\"\n" : fmt::format("title = {}\n", toml_string(title));
    text += table_text(Device::governor, catalogue);
    text += table_text(Device::gateway, catalogue);
    text += fmt::format("\n# {}\n# [network]\n# nodes = [2, 3]\n", meaning(table_below("network"), "nodes"));
    return text;
}

}  // namespace cgw::authoring
