#include "explain/pages.hpp"

#include <array>

#include <fmt/format.h>

#include "base/ascii.hpp"
#include "catalogue/errors.hpp"
#include "catalogue/objects.hpp"
#include "diagnostic/rules.hpp"
#include "explain/entries.hpp"
#include "explain/lists.hpp"
#include "explain/table.hpp"
#include "explain/text.hpp"
#include "explain/wording.hpp"
#include "facts/gateway.hpp"

namespace cgw::explain {

namespace {

using catalogue::ErrorDescription;
using diagnostic::Level;
using diagnostic::Rule;
using parameter::Catalogue;
using parameter::Device;
using parameter::Program;

constexpr std::size_t heading_of_group = 2;

// "D17" becomes a link to its ruling.
std::string with_ruling_links(std::string_view text) {
    const auto is_word = [&](std::size_t at) {
        return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    std::string linked;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        while (end < text.size() && text[end] >= '0' && text[end] <= '9') {
            ++end;
        }
        const bool ruling = text[i] == 'D' && end > i + 1 && !is_word(end) && (i == 0 || !is_word(i - 1));
        if (ruling) {
            const std::string_view number = text.substr(i + 1, end - i - 1);
            linked += fmt::format("[D{}](rulings.md#d{})", number, number);
            i = end;
        } else {
            linked += text[i++];
        }
    }
    return linked;
}

std::string head(std::string_view title, std::string_view table) {
    return fmt::format(
        "<!-- Made from {}. Changes here are lost; see ARCHITECTURE.md, \"Generated pages\". -->\n\n"
        "# {}\n\n",
        table, title);
}

// --- parameters ---

std::string parameters_page(const Catalogue& catalogue) {
    std::string page = head("Parameters and measurements", "schemas/parameters/*.toml");
    page +=
        "What cgw knows of the two devices: numbers, names, levels and ranges as the manuals print them, "
        "meanings\n"
        "in our words. `cgw explain NUMBER` says more about each, `cgw list parameters` prints this list.\n\n"
        "- `0..3` after a name is an array: `CanOpTPDO5-16ID(0..11)` has one element per number.\n"
        "- Numbers without a name are known to exist and named by your governor's own manual only.\n"
        "- \"Feeds\" is the object or the word of a PDO in which a parameter shows on the CANopen bus.\n"
        "- Ranges of the governor are not printed anywhere; ours are an assumption "
        "([D17](rulings.md#d17), [D19](rulings.md#d19)).\n"
        "- Measurements cannot be set. What your governor has beyond this list is declared in the parameter\n"
        "  file ([parameter-file.md](parameter-file.md#declarations)).\n\n";
    return page + with_ruling_links(render_markdown(parameter_list(catalogue, {}, true), heading_of_group));
}

// --- checks ---

std::string example(std::string_view title, diagnostic::Example kind, std::string_view text) {
    return kind == diagnostic::Example::none
               ? ""
               : fmt::format("{}:\n\n```{}\n{}{}```\n\n", title, diagnostic::language_of(kind), text,
                             text.ends_with('\n') ? "" : "\n");
}

std::string rule_section(const Rule& rule) {
    std::string section = fmt::format("### {} {}\n\n", rule.code, rule.name);
    section += fmt::format("Demanded: {}.", rule.summary);
    section += rule.reference.empty() ? "\n\n" : fmt::format(" ({})\n\n", with_ruling_links(rule.reference));
    if (!rule.why.empty()) {
        for (const std::string& line : wrap(rule.why, 100)) {
            section += line + "\n";
        }
        section += "\n";
    }
    return section + example("Broken", rule.example, rule.bad) + example("Kept", rule.example, rule.good);
}

std::string checks_page(const Catalogue&) {
    struct Part {
        Level level;
        std::string_view title;
        std::string_view about;
    };
    constexpr std::array parts{
        Part{Level::error, "Errors",
             "The plant would not work, or nobody can say what it would do. Nothing is built."},
        Part{Level::warning, "Warnings",
             "The plant works, and probably not as it was meant. `-W no-NAME` hides one."},
        Part{Level::note, "Notes", "Worth knowing, nothing is wrong. `-W no-NAME` hides one."},
    };
    std::string page = head("Checks", "lib/diagnostic/rules*.cpp");
    page +=
        "What cgw demands of a parameter file, why, and what it looks like broken and kept. `cgw explain "
        "CODE` prints\n"
        "one of them. Examples are lines on top of a file that is valid otherwise; a line replaces the one "
        "with its\n"
        "key, and `# 427 = 5` stands for a line that is not there. Those about printed tables (E0501 to "
        "E0507) "
        "are whole\n"
        "tables, of E0509 rows of a table that is complete otherwise; that of E0508 is a file that is "
        "copied.\n"
        "Those of E06 are steps of a [scenario](scenarios.md) of `samples/genset.toml` that lasts 10 s;\n"
        "those of E07 are Intel HEX files into which `cgw image embed` puts an image at 0x08010000; those of "
        "E0801\n"
        "to E0817 are sections of an EDS, those of E0820 on lines on top of an EDS that keeps all rules: a "
        "line replaces\n"
        "the one with its key, and `; DefaultValue=` stands for a line, `; [2001sub2]` for a section that "
        "is not there; those of E09 are\n"
        "parameters and objects of an XDD, those of E10 CAN databases.\n\n";
    std::string list = render_markdown(check_list(), heading_of_group);
    for (const Rule* rule : diagnostic::all_rules()) {
        list = replaced(list, fmt::format("| {} |", rule->code),
                        fmt::format("| [{}](#{}-{}) |", rule->code, base::lowered(rule->code), rule->name));
    }
    page += with_ruling_links(list);
    for (const Part& part : parts) {
        std::string sections;
        for (const Rule* rule : diagnostic::all_rules()) {
            sections += rule->level == part.level ? rule_section(*rule) : "";
        }
        if (!sections.empty()) {
            page += fmt::format("\n## {}\n\n{}\n\n{}", part.title, part.about, sections);
            page.pop_back();
        }
    }
    return page;
}

// --- errors ---

// "**Cause:** …", or a list where there are several.
std::string field_text(const Field& field) {
    std::string label = field.label;
    label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
    if (field.lines.size() == 1) {
        return fmt::format("**{}:** {}\n\n", label, field.lines.front());
    }
    std::string text = fmt::format("**{}:**\n\n", label);
    for (const std::string& line : field.lines) {
        text += fmt::format("- {}\n", line);
    }
    return text + "\n";
}

std::string error_section(const ErrorDescription& error, const Catalogue& catalogue) {
    const Entry entry = error_entry(error, catalogue);
    const std::string_view title = std::string_view(entry.title).substr(std::string_view("error ").size());
    std::string section = fmt::format("### {}\n\n", title.substr(0, title.find(" (")));
    const auto bit = catalogue::find_object_bit(error.number);
    if (bit && error.program == Program::application) {
        section += fmt::format("Bit {} of {}. ", bit->bit,
                               bit->sub == 0 ? object_text(bit->index) : object_text(bit->index, bit->sub));
    }
    section += fmt::format("Shown by: {}.\n\n",
                           title.substr(title.find('(') + 1, title.size() - title.find('(') - 2));
    for (const Field& field : entry.fields) {
        section += field_text(field);
    }
    return section;
}

// One group of a page: errors of these devices and this program.
struct Part {
    std::string_view title;
    std::string_view about;
    bool (*holds)(const ErrorDescription& error);
};

constexpr std::array error_parts{
    Part{"CANopen errors",
         "Both devices show them; their bits make up object 2005h, which a master reads by SDO. Each one "
         "sets\n"
         "3074 `ErrCanOpen` as well.",
         [](const ErrorDescription& error) { return error.number >= facts::first_canopen_error; }},
    Part{"Errors of the gateway",
         "Bits of 2000h:1..6. The counter of an error, 100 above it, is kept in the permanent error memory "
         "and\n"
         "changes nothing; the service tool clears it.",
         [](const ErrorDescription& error) {
             return error.program == Program::application && error.gateway &&
                    error.number < facts::first_canopen_error;
         }},
    Part{"Errors of the governor",
         "Those that CANopen causes. Everything else is in your governor's own manual.",
         [](const ErrorDescription& error) {
             return error.program == Program::application && !error.gateway;
         }},
    Part{"Errors of the gateway's bootloader",
         "The bootloader runs for about 200 ms after each start. When it stays, it answers on the serial "
         "interface\n"
         "only, and the same number may mean something else than in the gateway's program (D1).",
         [](const ErrorDescription& error) { return error.program == Program::bootloader; }},
};

// What 3095 and 3800 of the bootloader say.
std::string values_section(const Catalogue& catalogue) {
    std::string section;
    for (const std::uint16_t number : {std::uint16_t{3095}, std::uint16_t{3800}}) {
        const parameter::Row* row = catalogue.find(Device::gateway, Program::bootloader, number);
        section += fmt::format("### Values of {}\n\n| value | meaning |\n| --- | --- |\n", label(*row));
        for (const parameter::NamedValue& value : row->values) {
            section += fmt::format("| {} | {} |\n", value.value, value.text);
        }
        section += "\n";
    }
    return section;
}

std::string abort_section() {
    std::string section =
        "## SDO abort codes\n\n"
        "Those that the gateway sends, and what to do then.\n\n| code | meaning | sent for | what to do |\n"
        "| --- | --- | --- | --- |\n";
    for (const base::AbortCodeRow& row : base::abort_codes()) {
        if (!row.gateway.empty()) {
            section +=
                fmt::format("| 0x{:08X} | {} | {} | {} |\n", row.code, row.meaning, row.gateway, row.action);
        }
    }
    return section;
}

std::string errors_page(const Catalogue& catalogue) {
    std::string page = head("Errors of the devices", "schemas/errors/*.toml");
    page +=
        "What the errors of gateway and governor mean, what the devices do, what to do about it and how they "
        "go away.\n"
        "`cgw explain 12412` prints one of them, `cgw explain 2005h=0x0102` takes a value apart, `cgw list "
        "codes`\n"
        "prints the list.\n\n";
    for (const Part& part : error_parts) {
        page += fmt::format("## {}\n\n{}\n\n", part.title, part.about);
        for (const ErrorDescription& error : catalogue::shipped_errors()) {
            page += part.holds(error) ? error_section(error, catalogue) : "";
        }
    }
    page += values_section(catalogue) + abort_section();
    return with_ruling_links(page);
}

// --- assumptions ---

std::string assumptions_page(const Catalogue&) {
    std::string page = head("Assumptions to check on a device", "lib/explain/assumptions.cpp");
    page +=
        "The documents leave points open that cgw has to decide. Each row is our best reading and may be "
        "wrong on a\n"
        "real device. The ruling behind a row says what the documents print, why that does not settle it, "
        "and "
        "how to\n"
        "measure it. If you measure one, please report the result, whichever way it came out.\n\n"
        "Before an engine depends on one of them, check it on your devices.\n\n"
        "\"Lives in\" is the room of `lib/` or the directory in which one change corrects the "
        "assumption.\n\n";
    return page + with_ruling_links(render_markdown(assumption_list(), heading_of_group));
}

constexpr std::array pages{
    Page{"parameters.md", parameters_page},
    Page{"checks.md", checks_page},
    Page{"errors.md", errors_page},
    Page{"assumptions.md", assumptions_page},
};

}  // namespace

std::span<const Page> generated_pages() {
    return pages;
}

}  // namespace cgw::explain
