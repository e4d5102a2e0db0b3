#include "cli/cgw/man_page.hpp"

#include <fmt/format.h>

#include "base/ascii.hpp"
#include "cli/cgw/help.hpp"

namespace cgw::cli {
namespace {

// What troff would take for a request or an escape, as itself; a "-" that people may want to copy.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') {
            out += "\\e";
        } else if (c == '-') {
            out += "\\-";
        } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
            out += fmt::format("\\&{}", c);
        } else {
            out += c;
        }
    }
    std::string ascii;
    for (std::size_t at = 0; at < out.size();) {
        constexpr std::string_view ellipsis = "…";
        const bool found = std::string_view(out).substr(at).starts_with(ellipsis);
        ascii += found ? "..." : out.substr(at, 1);
        at += found ? ellipsis.size() : 1;
    }
    return ascii;
}

std::string header(std::string_view name, std::string_view version, std::string_view summary) {
    std::string upper(name);
    for (char& c : upper) {
        c = base::upper(c);
    }
    return fmt::format(".TH {} 1 \"\" \"cgw {}\"\n.nh\n.ad l\n.SH NAME\n{} \\- {}\n", escaped(upper), version,
                       escaped(name), escaped(summary));
}

std::string option_paragraphs(const Verb& verb, bool positional) {
    std::string text;
    for (const Option& option : verb.options) {
        if (option.positional() == positional) {
            text += fmt::format(".TP\n.B {}\n{}\n", escaped(option_heading(option)),
                                escaped(option_text(option)));
        }
    }
    return text;
}

std::string exit_status(std::span<const ExitCodeText> rows) {
    std::string text = ".SH EXIT STATUS\n";
    for (const ExitCodeText& row : rows) {
        text += fmt::format(".TP\n.B {}\n{}\n", row.code, escaped(row.meaning));
    }
    return text;
}

// From the synopsis to the options of the table.
std::string body(const Verb& verb, std::string_view call) {
    std::string text = fmt::format(".SH SYNOPSIS\n.B {}\n", escaped(synopsis(call, verb)));
    if (!verb.details.empty()) {
        text += fmt::format(".SH DESCRIPTION\n{}", escaped(verb.details));
    }
    if (const std::string arguments = option_paragraphs(verb, true); !arguments.empty()) {
        text += ".SH ARGUMENTS\n" + arguments;
    }
    return text + ".SH OPTIONS\n" + option_paragraphs(verb, false);
}

}  // namespace

std::string man_page_name(const Verb& verb) {
    std::string name = fmt::format("cgw-{}", verb.name);
    for (char& c : name) {
        c = c == ' ' ? '-' : c;
    }
    return name;
}

std::string program_man_page(std::string_view version) {
    std::string text = header("cgw", version, "configuration compiler for HEINZMANN CANopen gateways");
    text += ".SH SYNOPSIS\n.B cgw\n.I VERB\n[\\fIARGUMENT\\fR ...]\n.br\n.B cgw \\-\\-version\n";
    text +=
        ".SH DESCRIPTION\nOne parameter file holds the parameters of a Digital Governor and of the CANopen "
        "Gateway\n"
        "that joins it to a CANopen network. cgw checks both against each other and makes what everybody\n"
        "downstream needs: electronic data sheet, PDO tables, entry sheets, configuration image.\n";
    text += ".SH VERBS\n";
    for (const Verb* verb : all_verbs()) {
        text += fmt::format(".TP\n.B {}\n{}; see\n.BR {} (1)\n", escaped(verb->name), escaped(verb->summary),
                            escaped(man_page_name(*verb)));
    }
    return text + exit_status(exit_code_texts()) +
           ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nif not empty, no colours unless asked for by option\n"
           ".TP\n.B SOURCE_DATE_EPOCH\ndate of the artefacts, in seconds since 1970, for files that carry "
           "none\n";
}

std::string verb_man_page(const Verb& verb, std::string_view version) {
    return header(man_page_name(verb), version, verb.summary) + body(verb, fmt::format("cgw {}", verb.name)) +
           ".TP\n.B \\-h, \\-\\-help\nprint a short help\n" + exit_status(exit_code_texts()) +
           ".SH SEE ALSO\n.BR cgw (1)\n";
}

std::string command_man_page(const Verb& command, std::span<const ExitCodeText> exit_codes,
                             std::string_view related, std::string_view version) {
    return header(command.name, version, command.summary) + body(command, command.name) +
           exit_status(exit_codes) + fmt::format(".SH SEE ALSO\n.BR {} (1)\n", escaped(related));
}

}  // namespace cgw::cli
