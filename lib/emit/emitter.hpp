// Every artefact behind one interface. An emitter is pure: same plant and options, same bytes; it opens
// no file and asks no clock.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "config/configuration.hpp"
#include "dictionary/dictionary.hpp"
#include "parameter/settings.hpp"

namespace cgw::emit {

// A checked configuration with everything the emitters need.
struct Plant {
    const parameter::Settings& settings;
    const config::Configuration& configuration;
    const dictionary::Dictionary& dictionary;
    std::array<std::uint8_t, 32> configuration_id{};
    std::string configuration_id_text;  // first 8 bytes, 16 hexadecimal digits
    std::array<std::uint16_t, 3> tool_version{};
    std::string tool_version_text;  // "0.1.0"
};

struct Options {
    std::string format;                       // one of the emitter's formats; "" is its first
    std::string section = ".cgw_config";      // --section: linker section
    unsigned alignment = 8;                   // --align: bytes, a power of two
    std::string symbol = "cgw_config_image";  // --symbol: C identifier
};

struct Format {
    std::string_view name;       // "md"
    std::string_view file_name;  // what `build` calls it: "pdo-table.md"; "" when build leaves it out
};

struct Emitter {
    std::string_view name;  // "pdo-table"
    std::string_view summary;
    std::span<const Format> formats;
    base::Bytes (*emit)(const Plant&, const Options&);
    std::span<const std::string_view> options{};  // what it takes beside --format: "--section"
};

std::span<const Emitter> all_emitters();
const Emitter* find_emitter(std::string_view name);  // nullptr: there is none

// The emitter's format of that name, its first for ""; nullptr when it has none of that name.
const Format* find_format(const Emitter& emitter, std::string_view name);

}  // namespace cgw::emit
