// The lines of the source texts, for caret lines.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/location.hpp"

namespace cgw::diagnostic {

class SourceLines {
  public:
    // The texts must outlive this object.
    explicit SourceLines(const std::map<std::string, std::string>& sources) : sources_(sources) {}

    // Two lines, the source and the marks below it, each ending in a newline; "" when the text is not known
    // or the location means the whole file. A long line is cut around the marks, control characters
    // print as blanks, bytes that are not UTF-8 as '?'.
    std::string excerpt(const Location& where, char mark, std::string_view mark_start,
                        std::string_view mark_end);

    // Without its line end; "" when the text or the line is not known.
    std::string_view line(const std::string& path, std::uint32_t number);

  private:
    const std::map<std::string, std::string>& sources_;
    std::map<std::string, std::vector<std::size_t>> starts_;  // offset of each line, filled on demand
};

// Columns in UTF-16 code units, which editors and SARIF count. Ask for places in ascending order: the count
// goes on from the last one, so that a line as long as the file stays cheap.
class Utf16Columns {
  public:
    explicit Utf16Columns(SourceLines& lines) : lines_(lines) {}

    Range convert(const Location& where);

  private:
    SourceLines& lines_;
    std::string path_;
    std::string_view line_;
    Position bytes_;           // where the count stands, in bytes
    std::uint32_t units_ = 1;  // the same column in code units
};

// `path:line:column`, or the path alone for a whole file.
std::string to_text(const Location& where);

}  // namespace cgw::diagnostic
