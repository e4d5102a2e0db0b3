// The table of checks over EDS and DCF of any device: what CiA 306 and CiA 301 demand beyond what the reader
// (eds/reader.hpp) reports itself, and what real files make of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "diagnostic/diagnostic.hpp"
#include "eds/reader.hpp"
#include "eds_check/repair.hpp"

namespace cgw::eds_check {

struct Options {
    // 1..127, for values that follow the node number; else that of the configuration file, else any node.
    std::optional<std::uint8_t> node_id{};
    bool strict = false;                             // what strict importers refuse is an error
    std::string file_name{};                         // the real one, without directories; "": not known
    std::size_t most_findings = eds::most_findings;  // of one rule that are told one by one
};

struct Context;

struct Check {
    const diagnostic::Rule* rule;
    void (*run)(const Context&);  // reports under its rule; nullptr: the reader does
    bool strict = false;          // strict importers refuse such a file

    // Mends what the finding at `place` is about; nothing where that is not safe there. After it the finding
    // is gone, and the device that the file describes is the same.
    std::optional<Repair> (*repair)(const Context&, const eds::Span& place) = nullptr;

    bool doubtful = false;  // what the file says is not certain: nothing is repaired in it
};

std::span<const Check> all_checks();

// nullptr when the rule is none of EDS files that need a row.
const Check* find_check(const diagnostic::Rule* rule);

// Runs the whole table over a sheet that eds::read() made of the document. With `strict` the findings that
// are in `findings` already, the reader's, are promoted as well. Linear in the length of the text.
void check(const eds::Document& document, const eds::Sheet& sheet, const std::string& path,
           const Options& options, diagnostic::Findings& findings);

}  // namespace cgw::eds_check
