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

Range Utf16Columns::convert(const Location& where) {
    const auto advance = [](std::string_view line, std::uint32_t from, std::uint32_t to,
                            std::uint32_t units) {
        for (std::size_t at = from - 1; at < line.size() && at + 1 < to;) {
            const std::size_t length = base::utf8_sequence_length(line.substr(at));
            units += length == 4 ? 2 : 1;
            at += std::max<std::size_t>(length, 1);
        }
        // Behind the end of what is known a column is a column.
        const auto known = static_cast<std::uint32_t>(line.size() + 1);
        return units + (to > known ? to - std::max(known, from) : 0);
    };
    const auto& [start, end] = where.range;
    const bool goes_on = where.path == path_ && start.line == bytes_.line && start.column >= bytes_.column;
    if (!goes_on) {
        path_ = where.path;
        line_ = lines_.line(where.path, start.line);
        bytes_ = {start.line, 1};
        units_ = 1;
    }
    units_ = advance(line_, bytes_.column, start.column, units_);
    bytes_.column = std::max(start.column, 1U);
    Range range{{start.line, units_}, {end.line, 0}};
    range.end.column = end.line == start.line ? advance(line_, bytes_.column, end.column, units_)
                                              : advance(lines_.line(where.path, end.line), 1, end.column, 1);
    return range;
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
