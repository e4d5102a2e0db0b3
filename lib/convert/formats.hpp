// What a description of a device can be converted to: one row each. `cgw convert`, its help and
// docs/conversions.md list them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "convert/description.hpp"
#include "convert/losses.hpp"
#include "convert/unread.hpp"

namespace cgw::convert {

struct Format {
    std::string_view name;         // "dcf"
    std::string_view summary;      // one line
    std::string_view ending;       // ".dcf"
    std::optional<Medium> medium;  // what it loses; nothing: all, or what a node is given and no more
    // What it is about: a kind of device, one node, or either.
    enum class About : std::uint8_t { device, node, either } about;
    base::Bytes (*write)(const Description& description);
};

std::span<const Format> formats();
const Format* find_format(std::string_view name);          // nullptr: there is none
const Format* format_of_file(std::string_view file_name);  // by its ending, whatever the case

struct Request {
    const Format& format;
    std::optional<std::uint8_t> node_id{};  // 1..127; of a description that says none
    std::string file_name{};  // of the product, where it states its name; "" keeps that of the source
};

struct Product {
    base::Bytes bytes;
    std::vector<Loss> losses;
    std::vector<Unread> lost_sections;
    std::size_t resolved = 0;  // values that followed the node number, and do no more
    std::uint8_t node_id = 0;  // for which they are resolved
    bool no_entries = false;   // of a concise DCF: every value is the default
};

// Why there is no product: the request does not fit the description, or a formula with the node number makes
// too large a number, at this sub-object.
struct Refusal {
    std::string why;  // lower case, no final period
    std::optional<std::uint16_t> index{};
    std::uint8_t sub_index = 0;
};

tl::expected<Product, Refusal> convert(Description description, const Request& request);

}  // namespace cgw::convert
