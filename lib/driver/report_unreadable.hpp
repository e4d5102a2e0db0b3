// Inside the driver room: what could not be read, or is refused as a whole, as a finding.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/result.hpp"
#include "diagnostic/diagnostic.hpp"
#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/firmware.hpp"
#include "image/image.hpp"

namespace cgw::driver {

// True when the file could not be read, false when it is too large: that is a finding about what it holds.
inline bool report_unreadable(const std::string& path, const base::Failure& failure,
                              diagnostic::Findings& findings) {
    const diagnostic::Rule& rule =
        failure.too_large ? diagnostic::rules::file_too_large : diagnostic::rules::file_unreadable;
    findings.report({&rule, failure.message, {path, {}}});
    return !failure.too_large;
}

inline void report_refused(const std::string& path, image::Status status, diagnostic::Findings& findings) {
    findings.report({&diagnostic::rules::image_refused,
                     fmt::format("the image is refused: {} (status {})", image::to_text(status),
                                 static_cast<unsigned>(status)),
                     {path, {}}});
}

}  // namespace cgw::driver
