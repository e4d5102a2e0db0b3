// Every artefact behind one interface. An emitter is pure: same plant and options, same bytes; it opens
// no file and asks no clock.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "compare/compare.hpp"
#include "config/configuration.hpp"
#include "diagnostic/diagnostic.hpp"
#include "dictionary/dictionary.hpp"
#include "parameter/settings.hpp"

namespace cgw::emit {

inline constexpr std::string_view default_eds_name = "CANopenGateway.eds";
inline constexpr std::string_view default_image_file = "gateway-config.bin";

// A checked configuration with everything the emitters need.
struct Plant {
    const parameter::Settings& settings;
    const parameter::Catalogue& catalogue;
    const config::Configuration& configuration;
    const dictionary::Dictionary& dictionary;
    std::array<std::uint8_t, 32> configuration_id{};
    std::string configuration_id_text;  // first 8 bytes, 16 hexadecimal digits
    std::array<std::uint16_t, 3> tool_version{};
    std::string tool_version_text;  // "0.1.0"

    // For the report: what the checks found, what they cannot know, and what has changed.
    std::span<const diagnostic::Diagnostic> findings{};
    std::span<const std::string> not_verified{};
    const compare::Comparison* against = nullptr;  // side A the earlier plant, side B this one
    std::string against_name{};
};

// What an artefact that needs no configuration still says about itself.
struct Origin {
    parameter::Date date;
    std::string tool_version_text;
};

struct Options {
    std::string format;                       // one of the emitter's formats; "" is its first
    std::string section = ".cgw_config";      // --section: linker section
    unsigned alignment = 8;                   // --align: bytes, a power of two
    std::string symbol = "cgw_config_image";  // --symbol: C identifier
    std::string image_file = std::string(default_image_file);  // --incbin: what the assembler includes
    std::uint32_t base = 0;  // --base: address of the image, which ends below 2^32 with it
    std::string eds_name = std::string(default_eds_name);  // --eds-name: as eds_file_name() returns it
    bool labels = true;                                    // --no-labels: names and units are left out
};

struct Format {
    std::string_view name;          // "md"
    std::string_view file_name;     // what `build` calls it: "pdo-table.md"; "" when build leaves it out
    bool follows_eds_name = false;  // `file_name` is an ending, ".dcf", behind the stem of Options::eds_name
    std::span<const std::string_view> options{};  // what this format takes beside those of the emitter
};

struct Emitter {
    std::string_view name;  // "pdo-table"
    std::string_view summary;
    std::span<const Format> formats;
    base::Bytes (*emit)(const Plant&, const Options&);
    std::span<const std::string_view> options{};  // what it takes beside --format: "--section"
    base::Bytes (*emit_generic)(const Origin&, const Options&) = nullptr;  // nullptr: needs a configuration
};

std::span<const Emitter> all_emitters();
const Emitter* find_emitter(std::string_view name);  // nullptr: there is none

// The emitter's format of that name, its first for ""; nullptr when it has none of that name.
const Format* find_format(const Emitter& emitter, std::string_view name);

// Name of the file that `build` writes for a format; "" when it writes none.
std::string file_name(const Format& format, const Options& options);

// The name a user gave the data sheets, with ".eds" behind it where that was left out. A failure says what is
// wrong: such a name goes into FileInfo and through other people's tools, so letters, digits, blanks and . _
// - only, beginning with a letter or digit, at most 64 characters.
base::Result<std::string> eds_file_name(std::string_view name);

}  // namespace cgw::emit
