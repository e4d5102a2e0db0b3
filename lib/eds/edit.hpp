// Changes of a document, made all at once: every byte that no change names stays as it is.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eds/document.hpp"

namespace cgw::eds {

class Edits {
  public:
    // The document must outlive this object and stays as it is; apply() makes the new text. Of each line one
    // replacement or removal, in any order. Texts have no line ends.
    explicit Edits(const Document& document) : document_(document) {}

    // A name, key or value, or a whole line (Document::…_span).
    void replace(const Span& span, std::string_view text);

    // The line with its line end.
    void remove(std::uint32_t line);

    // Lines that follow `line` (in the order of the calls), with the line end that it has; one that ends the
    // text without a line end gets one as the line before has, LF in a text of one line.
    void insert_after(std::uint32_t line, std::string_view text);

    bool empty() const { return changes_.empty(); }

    std::string apply() const;

  private:
    struct Change {
        std::uint32_t begin = 0;  // offsets into the text
        std::uint32_t end = 0;
        std::string text;
    };

    std::uint32_t behind(std::uint32_t line) const;  // offset behind its line end

    const Document& document_;
    std::vector<Change> changes_;
};

}  // namespace cgw::eds
