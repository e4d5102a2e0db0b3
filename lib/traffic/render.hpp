// A log as it is read, line by line, and what was counted at its end.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "media/logged_frame.hpp"
#include "traffic/audit.hpp"
#include "traffic/decoder.hpp"

namespace cgw::traffic {

// A frame with what it means.
struct Told {
    const media::LoggedFrame& logged;
    const Meaning& meaning;
    std::uint64_t number = 0;  // line or record; 0: typed in
    bool has_time = true;
    std::uint64_t start_us = 0;  // of the first frame of the log: text shows times from there on
};

// How a log is printed. Every function returns whole lines, or "".
struct Format {
    std::string_view name;
    std::string_view summary;
    std::string (*head)(const Subject& subject);
    std::string (*frame)(const Told& told);
    // `findings` are those of the audit; formats for people leave them to the caller.
    std::string (*foot)(const Audit& audit, std::span<const diagnostic::Diagnostic> findings);
};

// text, json, csv
std::span<const Format> formats();

// One frame that was typed in, signal by signal, for people.
std::string explain_frame(const frame::Frame& frame, const Meaning& meaning);

}  // namespace cgw::traffic
