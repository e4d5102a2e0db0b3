#include <fmt/format.h>

#include "base/text_cells.hpp"
#include "page/html_parts.hpp"

namespace cgw::page {
namespace {

using base::html_text;

std::string marked(Tone tone, std::string_view text) {
    if (tone == Tone::plain) {
        return html_text(text);
    }
    return fmt::format(R"(<span class="{}"><span class="mark">{}:</span> {}</span>)", class_of(tone),
                       mark_of(tone), html_text(text));
}

std::string cell_html(const Cell& cell, const Column& column, bool heads_row) {
    const std::string_view tag = heads_row ? "th scope=\"row\"" : "td";
    const std::string_view style = column.number ? " class=\"number\"" : "";
    // In a cell the mark would drown the number: the colour has its words in a column of its own.
    std::string text = html_text(cell.text);
    if (cell.tone != Tone::plain) {
        text = fmt::format("<span class=\"{}\">{}</span>", class_of(cell.tone), text);
    }
    return fmt::format("<{}{}>{}{}</{}>", tag, style, text, cell.bar ? bar_svg(*cell.bar, cell.tone) : "",
                       heads_row ? "th" : "td");
}

// Numbers the headings, so that the list at the top can lead to them.
class Html {
  public:
    std::string body;

    void operator()(const Heading& heading) {
        const std::string id = heading.level == 2 ? fmt::format(" id=\"s{}\"", ++sections_) : "";
        body += fmt::format("<h{0}{1}>{2}</h{0}>\n", heading.level, id, html_text(heading.text));
    }

    void operator()(const Paragraph& paragraph) {
        body += fmt::format("<p>{}</p>\n", marked(paragraph.tone, paragraph.text));
    }

    void operator()(const Verdict& verdict) {
        body += fmt::format("<div class=\"verdict {}\">\n<strong>{}{}{}</strong>\n", class_of(verdict.tone),
                            mark_of(verdict.tone), verdict.tone == Tone::plain ? "" : ": ",
                            html_text(verdict.text));
        list(verdict.reasons, "ul");
        body += "</div>\n";
    }

    void operator()(const Table& table) {
        // Scrolls by itself where it is wider than the page, also by keyboard.
        body += fmt::format(
            "<div class=\"wide\" tabindex=\"0\" role=\"region\" "
            "aria-label=\"{0}\">\n<table>\n<caption>{0}</caption>\n<thead><tr>",
            html_text(table.caption));
        for (const Column& column : table.columns) {
            body += fmt::format("<th scope=\"col\"{}>{}</th>",
                                column.number      ? " class=\"number\""
                                : column.empty_box ? " class=\"box\""
                                                   : "",
                                html_text(column.title));
        }
        body += "</tr></thead>\n<tbody>\n";
        for (const std::vector<Cell>& row : table.rows) {
            body += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i) {
                body += cell_html(row[i], table.columns[i], i == 0);
            }
            body += "</tr>\n";
        }
        body += "</tbody>\n</table>\n</div>\n";
    }

    void operator()(const Items& items) { list(items.lines, items.numbered ? "ol" : "ul"); }

    void operator()(const Frame& frame) { figure(frame.caption, frame_svg(frame)); }

    void operator()(const Strip& strip) { figure(strip.caption, strip_svg(strip)); }

  private:
    void list(const std::vector<std::string>& lines, std::string_view tag) {
        if (lines.empty()) {
            return;
        }
        body += fmt::format("<{}>\n", tag);
        for (const std::string& line : lines) {
            body += fmt::format("<li>{}</li>\n", html_text(line));
        }
        body += fmt::format("</{}>\n", tag);
    }

    void figure(std::string_view caption, std::string_view svg) {
        body += fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", svg, html_text(caption));
    }

    int sections_ = 0;
};

std::string contents(const Page& page) {
    std::string text;
    int section = 0;
    for (const Block& block : page.blocks) {
        const auto* const heading = std::get_if<Heading>(&block);
        if (heading != nullptr && heading->level == 2) {
            ++section;
            text += fmt::format("<li><a href=\"#s{}\">{}</a></li>\n", section, html_text(heading->text));
        }
    }
    return text.empty() ? "" : fmt::format("<nav aria-label=\"Contents\">\n<ul>\n{}</ul>\n</nav>\n", text);
}

}  // namespace

std::string_view mark_of(Tone tone) {
    constexpr std::string_view marks[] = {"", "OK", "Warning", "Error"};
    return marks[static_cast<std::size_t>(tone)];
}

std::string render_html(const Page& page) {
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{0}</title>\n"
        "<style>\n{1}</style>\n</head>\n<body>\n<header>\n<h1>{0}</h1>\n",
        html_text(page.title), style_sheet);
    for (const std::string& line : page.subtitle) {
        text += fmt::format("<p class=\"subtitle\">{}</p>\n", html_text(line));
    }
    text += "</header>\n";
    Html html;
    // What comes before the first heading is what everybody must see: the contents stand behind it.
    bool listed = false;
    for (const Block& block : page.blocks) {
        if (!listed && std::holds_alternative<Heading>(block)) {
            html.body += contents(page);
            listed = true;
        }
        std::visit(html, block);
    }
    return text + "<main>\n" + html.body + "</main>\n</body>\n</html>\n";
}

}  // namespace cgw::page
