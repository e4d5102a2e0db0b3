// What a verification found, for people and for programs.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/configuration.hpp"
#include "live/run.hpp"
#include "live/verification.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::live {

// What was compared with what; everything outlives the report.
struct Subject {
    std::string path;              // of the parameter file
    std::string configuration_id;  // 16 hexadecimal digits
    std::string channel;           // as it was written
    bool wrote = true;             // PlanOptions::write
    const parameter::Settings& settings;
    const config::Configuration& configuration;
    const parameter::Catalogue& catalogue;
};

struct Format {
    std::string_view name;
    std::string_view summary;
    std::string (*render)(const Subject&, const Verification&, const Connection&);
};

// "human" is the first one.
std::span<const Format> formats();

// "value", "missing", …: stable words of the JSON document (docs/command-line.md).
std::string_view to_text(DifferenceKind kind);
std::string_view to_text(Ending ending);

// Why it could not be finished and what to look at, one thought each; empty when it was.
std::vector<std::string> diagnosis(const Subject& subject, const Verification& verification,
                                   const Connection& connection);

// What a value of a configured object says, "sent as 282h"; empty where the number says it all.
std::string meaning_of(const Question& question, std::uint32_t value);

// One sentence without the object: "the device has no such object (0x06020000)"; of a value nothing.
std::string sentence_of(const Question& question, const Difference& difference);

std::string value_text(std::uint32_t value, std::uint8_t length);  // "0x0102"

std::string render_text(const Subject& subject, const Verification& verification,
                        const Connection& connection);
std::string render_json(const Subject& subject, const Verification& verification,
                        const Connection& connection);

}  // namespace cgw::live
