#include <fmt/format.h>

#include "base/text_cells.hpp"
#include "page/page.hpp"

namespace cgw::page {
namespace {

using base::markdown_cell;

std::string marked(Tone tone, std::string_view text) {
    return tone == Tone::plain ? markdown_cell(text)
                               : fmt::format("**{}:** {}", mark_of(tone), markdown_cell(text));
}

class Markdown {
  public:
    std::string text;

    void operator()(const Heading& heading) {
        text += fmt::format("{} {}\n\n", std::string(static_cast<std::size_t>(heading.level), '#'),
                            markdown_cell(heading.text));
    }

    void operator()(const Paragraph& paragraph) { text += marked(paragraph.tone, paragraph.text) + "\n\n"; }

    void operator()(const Verdict& verdict) {
        text += marked(verdict.tone, verdict.text) + "\n\n";
        list(verdict.reasons, false);
    }

    void operator()(const Table& table) {
        text += markdown_cell(table.caption) + "\n\n|";
        for (const Column& column : table.columns) {
            text += fmt::format(" {} |", markdown_cell(column.title));
        }
        text += "\n|";
        for (const Column& column : table.columns) {
            text += column.number ? "---:|" : "---|";
        }
        text += '\n';
        for (const std::vector<Cell>& row : table.rows) {
            text += '|';
            for (const Cell& cell : row) {
                text += fmt::format(" {} |", markdown_cell(cell.text));
            }
            text += '\n';
        }
        text += '\n';
    }

    void operator()(const Items& items) { list(items.lines, items.numbered); }

    // The table of its signals says the same.
    void operator()(const Frame&) {}

    void operator()(const Strip&) {}

  private:
    void list(const std::vector<std::string>& lines, bool numbered) {
        int number = 0;
        for (const std::string& line : lines) {
            text += numbered ? fmt::format("{}. {}\n", ++number, markdown_cell(line))
                             : fmt::format("- {}\n", markdown_cell(line));
        }
        text += lines.empty() ? "" : "\n";
    }
};

}  // namespace

std::string render_markdown(const Page& page) {
    Markdown markdown;
    markdown.text = fmt::format("# {}\n\n", markdown_cell(page.title));
    for (const std::string& line : page.subtitle) {
        markdown.text += markdown_cell(line) + "\n\n";
    }
    for (const Block& block : page.blocks) {
        std::visit(markdown, block);
    }
    while (markdown.text.ends_with("\n\n")) {
        markdown.text.pop_back();
    }
    return markdown.text;
}

}  // namespace cgw::page
