// A text with its line starts, so that an offset becomes line and column without counting again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "diagnostic/location.hpp"
#include "toml/complaint.hpp"

namespace cgw::toml {

class Source {
  public:
    // The text is not copied.
    explicit Source(std::string_view text);

    std::string_view text() const { return text_; }

    // Offsets up to and including the end of the text.
    diagnostic::Position position(std::size_t offset) const;
    diagnostic::Range range(std::size_t begin, std::size_t end) const;

    // Bytes of the line that holds `offset` and of the comment lines directly above it.
    std::size_t line_and_comments(std::size_t offset) const;

  private:
    std::size_t line_index(std::size_t offset) const;

    std::string_view text_;
    std::vector<std::uint32_t> starts_;
    std::vector<std::uint32_t> comments_;  // bytes of the comment lines that end with this line
};

// The first byte that is not UTF-8, or a control character other than tab and line end.
std::optional<Complaint> check_characters(const Source& source);

}  // namespace cgw::toml
