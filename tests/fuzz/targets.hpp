// What is fuzzed: one target for each reader of files that come from elsewhere. A target takes any bytes for
// such a file, demands of the reader what must hold for every file, and ends the program when it does not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace cgw::fuzz {

using Input = std::span<const std::uint8_t>;

void image(Input input);           // a configuration image, for both readers, the annotation and a gateway
void decompile(Input input);       // a configuration image, back to a parameter file
void firmware(Input input);        // an ELF, Intel HEX or S-record file that an image is put into
void parameter_file(Input input);  // behind the line "#### catalogue" the text of every catalogue it names
void table(Input input);           // of the governor; behind the line "#### gateway" of the gateway
void scenario(Input input);        // a scenario file, for the plant of samples/genset.toml
void eds(Input input);             // an EDS or DCF of any device
void xdd(Input input);             // an XDD or XDC
void log(Input input);             // a log of candump or pcap, for the plant of samples/genset.toml

// How inputs are changed so that the change gets past the first check: bytes at random alone would only ever
// show that checksums work. Each takes `size` bytes in `data`, which has room for `limit`, and returns how
// many they are then.
using Mutation = std::size_t (*)(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);

// Sections change their contents and lengths; sizes, configuration id and CRC-32 are made to fit again.
std::size_t mutate_image(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);
// Lines of Intel HEX and S-record files get right checksums.
std::size_t mutate_firmware(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);
// Words of the tables take the place of others; lines are moved, doubled and left out.
std::size_t mutate_text(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);

struct Target {
    std::string_view name;  // also of its corpus
    void (*run)(Input input);
    Mutation mutate;
};

inline constexpr Target targets[] = {
    {"image", image, mutate_image},
    {"decompile", decompile, mutate_image},
    {"firmware", firmware, mutate_firmware},
    {"parameter_file", parameter_file, mutate_text},
    {"table", table, mutate_text},
    {"scenario", scenario, mutate_text},
    {"eds", eds, mutate_text},
    {"xdd", xdd, mutate_text},
    {"log", log, mutate_text},
};

// nullptr: there is none of that name.
constexpr const Target* find_target(std::string_view name) {
    for (const Target& target : targets) {
        if (target.name == name) {
            return &target;
        }
    }
    return nullptr;
}

}  // namespace cgw::fuzz
