// One frame as people type it.
#pragma once

#include <span>
#include <string>

#include "diagnostic/diagnostic.hpp"
#include "frame/frame.hpp"

namespace cgw::traffic {

// True for what begins a typed frame, and no file name: "0x181", "181h", "181#A00F".
bool begins_frame(std::string_view text);

// `words` are "181#A00F" alone, or an identifier of 11 bits and bytes of two hexadecimal digits each, apart
// or together: "0x181 A0 0F", "181h A00F", "0x70C R". A finding's place is the word that is wrong.
frame::Frame read_typed_frame(std::span<const std::string> words, diagnostic::Findings& findings);

}  // namespace cgw::traffic
