// What the benchmarks of EDS measure: stages that a generated file goes through.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "dictionary/dictionary.hpp"

namespace cgw::bench {

struct EdsSample {
    explicit EdsSample(unsigned objects);

    dictionary::Dictionary dictionary;
    std::string text;    // the file that is written of it
    std::string broken;  // the same with counts and formulas to be repaired in every fourth and second object
};

struct EdsStage {
    std::string_view name;
    std::size_t (*run)(const EdsSample& sample);  // gives a number that depends on all of the work
};

// document: lines, sections and entries. read, check: that and all before. fix: of the broken text, written
// again until nothing is left to repair. write: from the dictionary.
std::span<const EdsStage> eds_stages();

}  // namespace cgw::bench
