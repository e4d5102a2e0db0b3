// What two dictionaries say differently: who the device is, its objects, their types, access, mapping and
// values. File names, dates, versions and comments of the files do not count.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.hpp"
#include "dictionary/dictionary.hpp"

namespace cgw::dictionary {

struct Side {
    const Dictionary& dictionary;
    const Commissioning* commissioning = nullptr;  // of a configuration file
    std::optional<std::uint8_t> node_id{};         // of the one device that it describes
    // It says only what a device knows of itself: no names, limits, object types, flags and no [DeviceInfo].
    bool bare = false;
};

struct DifferenceOptions {
    // To resolve $NODEID with; without it the node number of either side, and where neither has one, formulas
    // are compared as they stand.
    std::optional<std::uint8_t> node_id{};
};

// `aspect` is a stable word of the JSON document (docs/command-line.md); `a` and `b` are texts for people.
struct Difference {
    std::string_view aspect;
    std::string_view aspect_text;  // "default value"
    std::optional<std::uint16_t> index{};
    std::optional<std::uint8_t> sub_index{};  // of an object with sub-objects
    std::string name{};                       // of the object or sub-object
    std::string a{};
    std::string b{};
};

// "2003h:1 Switch Functions"; of the device nothing.
std::string subject_text(const Difference& difference);

// As one object of JSON; the texts under these keys.
void write_json(base::JsonWriter& json, const Difference& difference, std::string_view key_a,
                std::string_view key_b);

struct Differences {
    std::vector<Difference> all;                 // device, objects by index and sub-index, modules
    std::vector<std::string_view> not_compared;  // texts of the aspects that one side does not state

    bool same() const { return all.empty(); }
};

Differences differences(const Side& a, const Side& b, const DifferenceOptions& options = {});

// How a side is called in a report.
struct SideName {
    std::string path;
    std::string_view kind;  // "EDS"
};

struct DifferenceFormat {
    std::string_view name;  // "text"
    std::string_view summary;
    std::string (*render)(const Differences& differences, const SideName& a, const SideName& b);
};

// text (80 columns as far as names allow), json (schemas/eds-diff-report.schema.json), md.
std::span<const DifferenceFormat> difference_formats();

}  // namespace cgw::dictionary
