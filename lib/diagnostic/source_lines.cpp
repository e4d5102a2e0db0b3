#include "diagnostic/source_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.hpp"

namespace cgw::diagnostic {
namespace {

constexpr std::size_t widest_excerpt = 100;  // characters of a source line that are shown
constexpr std::size_t context_before = 40;   // of them before the mark, when the line is cut

// One character of the line as it prints, with the byte column at which it stands.
struct Glyph {
    std::size_t column;  // 1-based, bytes
    std::string text;
};

std::vector<Glyph> glyphs_of(std::string_view line) {
    std::vector<Glyph> glyphs;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t length = base::utf8_sequence_length(line.substr(at));
        if (length == 0) {
            glyphs.push_back({at + 1, "?"});
        } else if (base::is_control(line.substr(at, length))) {
            glyphs.push_back({at + 1, " "});
        } else {
            glyphs.push_back({at + 1, std::string(line.substr(at, length))});
        }
        at += std::max<std::size_t>(length, 1);
    }
    return glyphs;
}

}  // namespace

std::string to_text(const Location& where) {
    std::string path = where.path == "-" ? "<stdin>" : base::printable(where.path);
    if (where.range.start.line == 0) {
        return path;
    }
    return fmt::format("{}:{}:{}", path, where.range.start.line, where.range.start.column);
}

std::string_view SourceLines::line(const std::string& path, std::uint32_t number) {
    const auto source = sources_.find(path);
    if (source == sources_.end() || number == 0) {
        return {};
    }
    const std::string& text = source->second;
    std::vector<std::size_t>& starts = starts_[path];
    if (starts.empty()) {
        starts.push_back(0);
        for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
            starts.push_back(at + 1);
        }
    }
    if (number > starts.size()) {
        return {};
    }
    const std::size_t begin = starts[number - 1];
    const std::size_t end = number < starts.size() ? starts[number] - 1 : text.size();
    std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

std::string SourceLines::excerpt(const Location& where, char mark, std::string_view mark_start,
                                 std::string_view mark_end) {
    const Range& range = where.range;
    if (range.start.line == 0 || !sources_.contains(where.path)) {
        return {};
    }
    const std::string_view source = line(where.path, range.start.line);
    const std::size_t first = std::max<std::size_t>(range.start.column, 1);
    const std::size_t last = range.end.line == range.start.line ? range.end.column : source.size() + 1;
    // Only the neighbourhood of the mark is looked at: a line may be as long as the file.
    const std::size_t skipped = first > widest_excerpt ? first - context_before : 0;
    const std::vector<Glyph> glyphs =
        glyphs_of(source.substr(std::min(skipped, source.size()), 4 * widest_excerpt));

    std::string shown = skipped > 0 ? "..." : "";
    std::string marks(shown.size(), ' ');
    std::size_t count = 0;
    std::size_t marked = 0;
    for (const Glyph& glyph : glyphs) {
        if (++count > widest_excerpt) {
            shown += "...";
            break;
        }
        shown += glyph.text;
        const std::size_t column = glyph.column + skipped;
        const bool inside = column >= first && (column < last || column == first);
        if (inside) {
            ++marked;
        } else if (marked == 0) {
            marks += ' ';
        }
    }
    const std::string under(std::max<std::size_t>(marked, 1), mark);
    return fmt::format("{:>6} | {}\n       | {}{}{}{}\n", range.start.line, shown, marks, mark_start, under,
                       mark_end);
}

}  // namespace cgw::diagnostic
