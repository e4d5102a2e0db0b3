// TOML text to a document in which every key and every value knows where it stands.
// The only room that includes toml11.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"

namespace cgw::toml {

inline constexpr std::size_t maximum_file_size = 4U * 1024U * 1024U;
inline constexpr int maximum_nesting = 64;

enum class Kind { string, integer, real, boolean, local_date, other_time, array, table };

// "a string", "an integer" … for messages.
std::string_view to_text(Kind kind);

enum class Notation { decimal, hexadecimal, octal, binary };

struct Entry;

struct Node {
    Kind kind = Kind::table;
    diagnostic::Range range;  // of the value; of the [header] for a table opened by one; {0, 0} for the root
    std::string text;         // string: its content; local_date: YYYY-MM-DD; numbers: as written
    std::int64_t integer = 0;
    double real = 0;  // also set for an integer
    bool boolean = false;
    Notation notation = Notation::decimal;
    std::vector<Node> elements;  // array, in order
    std::vector<Entry> entries;  // table, in the order of the file

    const Entry* find(std::string_view key) const;  // table: exact key, nullptr when absent
};

struct Entry {
    std::string key;
    diagnostic::Range key_range;  // of the key as written (with quotes); of the header's part for a table
    Node value;
};

// A key for messages: in backticks, control characters as '?', cut short when it is very long.
std::string quoted(std::string_view key);

// nullopt after at least one finding. One syntax error ends the reading; numbers out of range (all of them),
// over-deep nesting, a size over maximum_file_size and bytes that are not UTF-8 are findings of their own.
// A byte order mark is skipped and counts in the columns of the first line.
std::optional<Node> parse(std::string_view text, const std::string& path, diagnostic::Findings& findings);

}  // namespace cgw::toml
