// What is fuzzed: one target for each reader of files that come from elsewhere. A target takes any bytes for
// such a file, demands of the reader what must hold for every file, and ends the program when it does not.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "driver/check_file.hpp"

namespace cgw::fuzz {

using Input = std::span<const std::uint8_t>;

void image(Input input);           // a configuration image, for both readers, the annotation and a gateway
void decompile(Input input);       // a configuration image, back to a parameter file
void firmware(Input input);        // an ELF, Intel HEX or S-record file that an image is put into
void parameter_file(Input input);  // behind the line "#### catalogue" the text of every catalogue it names
void table(Input input);           // of the governor; behind the line "#### gateway" of the gateway
void scenario(Input input);        // a scenario file, for the plant of samples/genset.toml

struct Target {
    std::string_view name;  // also of its corpus
    void (*run)(Input input);
};

inline constexpr Target targets[] = {
    {"image", image}, {"decompile", decompile}, {"firmware", firmware}, {"parameter_file", parameter_file},
    {"table", table}, {"scenario", scenario},
};

// Ends the program, and says what did not hold, unless `holds`.
void demand(bool holds, std::string_view what);

// True for one input in `n`, always the same ones: for what would make a target slow if it were done each
// time.
bool sometimes(Input input, unsigned n);

// Every finding has a message and stands in one of the texts it may point into; every renderer takes them.
void demand_sound(const diagnostic::FileReport& report, const std::map<std::string, std::string>& sources);

// Text before and behind the first line that is `separator`; without one the second is empty.
struct Parts {
    std::string first;
    std::string second;
    bool separated = false;
};
Parts split(Input input, std::string_view separator);

// The image of a valid file.
base::Bytes image_of(const driver::CheckedFile& file, bool labels);

}  // namespace cgw::fuzz
