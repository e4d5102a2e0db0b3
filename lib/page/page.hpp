// A document as blocks, and its two forms: one self-contained HTML page without script, and Markdown. What is
// said stands in text in both; colours and drawings repeat it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cgw::page {

// How something is judged. The mark that goes with it is part of the text.
enum class Tone { plain, good, warning, bad };

std::string_view mark_of(Tone tone);  // "", "OK", "Warning", "Error"

// A share of a limit as a bar beside the text of a cell: 1 is the limit; more is drawn as full.
struct Bar {
    double share = 0;
    std::string meaning;  // what it shows, for those who do not see it: "43 % of the bus"
};

struct Cell {
    std::string text;
    Tone tone = Tone::plain;
    std::optional<Bar> bar{};

    Cell(std::string cell_text) : text(std::move(cell_text)) {}  // NOLINT(google-explicit-constructor)
    Cell(const char* cell_text) : text(cell_text) {}             // NOLINT(google-explicit-constructor)
    Cell(std::string cell_text, Tone cell_tone, std::optional<Bar> cell_bar = {})
        : text(std::move(cell_text)), tone(cell_tone), bar(std::move(cell_bar)) {}
};

struct Column {
    std::string title;
    bool number = false;     // set to the right
    bool empty_box = false;  // a column to tick by hand; nothing stands in it
};

struct Heading {
    int level = 2;  // 2..4; the page's title is the only one of level 1
    std::string text;
};

struct Paragraph {
    std::string text;
    Tone tone = Tone::plain;
};

// What it comes down to: a line in large letters, and what it rests on.
struct Verdict {
    Tone tone = Tone::plain;
    std::string text;
    std::vector<std::string> reasons;
};

struct Table {
    std::string caption;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;  // as many cells as columns; the first one heads its row
};

struct Items {
    bool numbered = false;
    std::vector<std::string> lines;
};

// The bytes of a CAN frame with what lies in them.
struct Frame {
    struct Part {
        unsigned first_bit = 0;  // 0..63, bit 0 is the lowest of byte 0
        unsigned width = 0;      // 1..64, within the frame
        std::string label;       // "2000 Speed"
        bool used = true;        // false: nothing is there
    };
    std::string caption;
    unsigned bytes = 0;       // 1..8
    std::vector<Part> parts;  // ascending, not overlapping
};

// A line of fields side by side that together are a whole: identifiers 000h..7FFh and who has them.
struct Strip {
    struct Field {
        unsigned first = 0;
        unsigned last = 0;
        std::string label;
        Tone tone = Tone::plain;
    };
    std::string caption;
    unsigned first = 0;
    unsigned last = 0;
    std::vector<Field> fields;  // ascending, not overlapping; gaps are free
};

using Block = std::variant<Heading, Paragraph, Verdict, Table, Items, Frame, Strip>;

struct Page {
    std::string title;
    std::vector<std::string> subtitle;  // lines below the title
    std::vector<Block> blocks;
};

// Whole texts, UTF-8, lines ended by LF; the same page gives the same bytes. Any text is safe in it: no
// markup, no control characters. HTML is well-formed XML as well; headings of level 2 are listed at its top.
std::string render_html(const Page& page);
std::string render_markdown(const Page& page);

}  // namespace cgw::page
