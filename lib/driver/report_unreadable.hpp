// Inside the driver room: what could not be read, as a finding.
#pragma once

#include <string>

#include "base/result.hpp"
#include "diagnostic/diagnostic.hpp"

namespace cgw::driver {

// True when the file could not be read, false when it is too large: that is a finding about what it holds.
inline bool report_unreadable(const std::string& path, const base::Failure& failure,
                              diagnostic::Findings& findings) {
    const diagnostic::Rule& rule =
        failure.too_large ? diagnostic::rules::file_too_large : diagnostic::rules::file_unreadable;
    findings.report({&rule, failure.message, {path, {}}});
    return !failure.too_large;
}

}  // namespace cgw::driver
