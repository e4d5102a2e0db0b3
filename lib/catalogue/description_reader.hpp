// Reads schemas/errors/*.toml and schemas/objects/*.toml at build time. Their cells are described at the top
// of the canopen-gateway.toml in each directory.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/errors.hpp"
#include "catalogue/objects.hpp"
#include "diagnostic/diagnostic.hpp"

namespace cgw::catalogue {

// The descriptions of several files, and what they refer to.
class Descriptions {
  public:
    // False after a finding.
    bool read_errors(std::string_view text, const std::string& path, diagnostic::Findings& findings);
    bool read_objects(std::string_view text, const std::string& path, diagnostic::Findings& findings);

    // In the order of shipped_errors() and shipped_objects().
    std::vector<ErrorDescription> errors() const;
    std::vector<ObjectDescription> objects() const;

  private:
    friend class TableReader;

    std::deque<std::string> texts_;
    std::deque<std::vector<std::string_view>> text_lists_;
    std::deque<std::vector<std::uint16_t>> number_lists_;
    std::deque<std::vector<parameter::NamedBit>> bit_lists_;
    std::vector<ErrorDescription> errors_;
    std::vector<ObjectDescription> objects_;
};

}  // namespace cgw::catalogue
