// What is wrong with a firmware file, or with the place of an image in it. The first thing found ends the
// work: nobody mends such a file by hand. The path is put in by whoever opened the file.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "diagnostic/diagnostic.hpp"

namespace cgw::firmware_file {

template <typename T>
using Outcome = tl::expected<T, diagnostic::Diagnostic>;

tl::unexpected<diagnostic::Diagnostic> refuse(const diagnostic::Rule& rule, std::string message,
                                              diagnostic::Range where = {}, std::string help = {});

// An address as firmware people write it: at least eight hexadecimal digits.
std::string address_text(std::uint64_t address);

}  // namespace cgw::firmware_file
