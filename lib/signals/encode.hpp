// Values as people type them, into the bytes of a frame.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "signals/codec.hpp"
#include "signals/frames.hpp"

namespace cgw::signals {

struct Given {
    const Signal* signal = nullptr;
    std::string asked;  // the value as typed, without its name
    std::int32_t raw = 0;
};

struct Encoded {
    const Frame* frame = nullptr;
    Data data{};                 // what is not given is as in rest_data()
    std::vector<Given> given{};  // in the order of the signals
};

// The frame that `name` means (find_frame); nullptr and a finding when there is none.
const Frame* demand_frame(const std::vector<Frame>& frames, std::string_view name,
                          diagnostic::Findings& findings);

// Each of `assignments` is NAME=VALUE (find_signal). VALUE is a number in the signal's unit, with the unit or
// without: "50%", "1500 1/min"; "on", "off", 0 or 1 for a bit; a raw number with `raw` behind it, decimal or
// hexadecimal: "0x1F40 raw". Physical values are refused beyond the signal's range, raw ones beyond its
// width. A finding's place is the assignment. To be used only when there are no findings.
Encoded encode(const Frame& frame, std::span<const std::string> assignments, diagnostic::Findings& findings);

// As `cansend` takes it: "302#0080000000".
std::string cansend_text(const Frame& frame, const Data& data);

// For people: the frame, then each signal with its bytes; and as JSON, schemas/encoded-frame.schema.json.
std::string render_encoded_text(const Encoded& encoded);
std::string render_encoded_json(const Encoded& encoded);

}  // namespace cgw::signals
