// Tables of the file whose keys are fixed: each key is a row with its type and range.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "input/context.hpp"

namespace cgw::input {

// What the limits of a key count.
enum class Limit : std::uint8_t {
    none,
    value,     // of a number
    bytes,     // of a string, which holds no control characters then
    elements,  // of a list
};

enum class Presence : std::uint8_t {
    optional,
    required,
    split,  // optional, and spread over the file by its headers: a second one under a misspelt name is likely
};

struct Table;

struct Key {
    std::string_view name;
    toml::Kind kind;  // real: a whole number as well
    Presence presence = Presence::optional;
    Limit limit = Limit::none;
    std::int64_t minimum = 0;
    std::int64_t maximum = 0;
    // Called when type and limits hold; without it the table `below` is read.
    void (*read)(Context&, const toml::Entry&) = nullptr;
    std::string_view text{};                    // what it means, one line, for editors
    std::string_view preset{};                  // its value when it is absent, as TOML and JSON write it
    const Table* below = nullptr;               // of a table: its keys, where they are fixed
    const Key* element = nullptr;               // of a list: what its elements are; one that is no table
                                                // stands there once
    std::span<const std::string_view> words{};  // of a string: the values it may have
};

struct Table {
    std::string_view name;  // for messages; "" for the top of the file
    std::span<const Key> keys;
    std::optional<parameter::Device> device{};  // whose parameters users may have put here by mistake
    std::span<const Key>
        joined{};  // "a.b" of tables below, whose header is a key of this one when its dot is lost
};

// A slip in a key is one finding: the key that was probably meant does not count as missing, and a table is
// read as the one that was meant unless that one is there as well.
void read_table(Context& context, const toml::Node& node, const Table& table);

// The key of `node` that was probably meant to be `name`, under a name the table does not have; nullptr when
// there is none.
const toml::Entry* misspelt(const toml::Node& node, const Table& table, std::string_view name);

// False after a finding. `what` names the value in messages.
bool check_value(Context& context, const toml::Node& value, const Key& key, std::string_view what);
bool check_type(Context& context, const toml::Node& value, toml::Kind kind, std::string_view what);
bool check_integer(Context& context, const toml::Node& value, std::int64_t minimum, std::int64_t maximum,
                   std::string_view what);
bool check_text(Context& context, const toml::Node& value, std::int64_t minimum, std::int64_t maximum,
                std::string_view what);

}  // namespace cgw::input
