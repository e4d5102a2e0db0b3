#include "eds/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostic/rules/eds.hpp"
#include "eds/reading.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;

bool is_utf_16(const Document& document) {
    const std::string& text = document.text();
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

bool begins_as_xml(const Document& document) {
    constexpr std::size_t mark = 3;  // bytes of a byte order mark
    const std::string& text = document.text();
    const std::size_t first = text.find_first_not_of(" \t\r\n", document.has_byte_order_mark() ? mark : 0);
    return first != std::string::npos && text[first] == '<';
}

// False where the bytes are no text of which anything can be read.
bool judge_bytes(Reading& reading) {
    const Document& document = reading.document;
    if (is_utf_16(document)) {
        reading.report_whole_file(rules::eds_text, "the file is UTF-16; an EDS has one byte per character");
        return false;
    }
    if (is_sheet(document)) {
        return true;
    }
    if (begins_as_xml(document)) {
        reading.report_whole_file(rules::eds_text,
                                  "the file is XML, no EDS; cgw convert makes an EDS of one of CiA 311");
        return false;
    }
    reading.report_whole_file(
        rules::eds_text, document.sections().empty()
                             ? std::string("the file has no section: it is no EDS")
                             : fmt::format("none of the sections is one of CiA 306, such as {}: it is no EDS",
                                           reading.quoted(document.sections().front())));
    return false;
}

void judge_lines(Reading& reading) {
    const Document& document = reading.document;
    const auto count = static_cast<std::uint32_t>(document.lines().size());
    const std::uint32_t preamble_end = document.preamble_end();
    const std::span<const Line> lines = document.lines();
    for (std::uint32_t line = 0; line < count; ++line) {
        const Line& each = lines[line];
        if (each.kind == LineKind::entry && line >= preamble_end) {
            continue;
        }
        if (each.kind == LineKind::other) {
            reading.report(rules::eds_line, document.line_span(line),
                           "this line is no section, no entry and no comment; it is passed over");
        } else if (each.kind == LineKind::section && each.mark == each.end) {
            reading.report(rules::eds_header, document.line_span(line),
                           "the name of this section is not closed by ]");
        } else if (each.kind == LineKind::entry && line < preamble_end) {
            reading.report(rules::eds_line, document.line_span(line),
                           "this entry stands before the first section; it is passed over");
        }
    }
}

void judge_nul(Reading& reading) {
    const Document& document = reading.document;
    const std::size_t nul = document.text().find('\0');
    if (nul == std::string::npos) {
        return;
    }
    std::uint32_t line = 0;
    while (line + 1 < document.lines().size() && document.lines()[line + 1].begin <= nul) {
        ++line;
    }
    const auto at = static_cast<std::uint32_t>(nul);
    reading.report(rules::eds_text, {line, at, at + 1}, "a byte 0 stands in the text");
}

void judge_names(Reading& reading) {
    const Document& document = reading.document;
    const std::span<const std::uint32_t> order = document.sections_by_name();
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Section& section = reading.section(order[i]);
        if (i > 0 && document.same_name(order[i - 1], order[i])) {
            reading.report(
                rules::eds_section_twice, document.name_span(section),
                fmt::format("{} stands in the file already; this one is not read", reading.quoted(section)),
                "", {{reading.location(document.name_span(reading.section(first))), "the one that is read"}});
        } else {
            first = order[i];
        }
        const SectionName& name = reading.sections.name(order[i]);
        if (name.misspelt && reading.sections.find(name.kind) == order[i]) {
            reading.report(rules::eds_spelling, document.name_span(section),
                           fmt::format("{} is no section of CiA 306; it is read as [{}]",
                                       reading.quoted(section), standard_name(name.kind)));
        }
    }
}

}  // namespace

bool is_sheet(const Document& document) {
    const std::span<const Section> sections = document.sections();
    return !is_utf_16(document) && std::any_of(sections.begin(), sections.end(), [&](const Section& section) {
        return parse_section_name(document.name(section)).kind != SectionKind::unknown;
    });
}

Sheet read(const Document& document, const std::string& path, diagnostic::Findings& findings,
           std::size_t most) {
    Sheet sheet{{}, {}, SectionTable(document)};
    Reading reading(document, sheet.sections, path, findings, most);
    if (!judge_bytes(reading)) {
        return sheet;
    }
    judge_nul(reading);
    judge_lines(reading);
    judge_names(reading);
    judge_free_keys(reading);
    dictionary::Dictionary& dictionary = sheet.dictionary;
    read_file_information(reading, dictionary.file);
    read_device_information(reading, dictionary.device);
    sheet.commissioning = read_commissioning(reading);
    read_dummy_usage(reading, dictionary.supported_dummies);
    if (const auto comments = sheet.sections.find(SectionKind::comments)) {
        read_comments(reading, *comments, dictionary.comments);
    }
    dictionary.objects = read_objects(reading, 0);
    add_compact_pdos(dictionary.device, dictionary.objects);
    read_modules(reading, dictionary.modules);
    reading.finish();
    return sheet;
}

}  // namespace cgw::eds
