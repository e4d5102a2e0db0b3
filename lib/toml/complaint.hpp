// The one mistake at which the reading of a TOML text ends; thrown inside this room only.
#pragma once

#include <optional>
#include <string>

#include "diagnostic/diagnostic.hpp"
#include "diagnostic/rules/files.hpp"

namespace cgw::toml {

struct Complaint {
    const diagnostic::Rule* rule = &diagnostic::rules::toml_syntax;
    diagnostic::Range where;
    std::string message;
    std::string help{};
    std::optional<diagnostic::Range> related{};
    std::string related_message{};
};

}  // namespace cgw::toml
