#include "authoring/clone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "authoring/toml_text.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/tables.hpp"
#include "toml/document.hpp"

namespace cgw::authoring {
namespace {

namespace gateway = config::gateway;
using parameter::Assignment;

// The text with what is to be replaced in it, by place.
class Edits {
  public:
    explicit Edits(std::string_view text) : text_(text) {
        starts_.push_back(0);
        for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
            starts_.push_back(at + 1);
        }
    }

    std::string_view at(const diagnostic::Range& range) const {
        return text_.substr(offset(range.start), offset(range.end) - offset(range.start));
    }

    void replace(const diagnostic::Range& range, std::string with) {
        edits_.push_back({offset(range.start), offset(range.end), std::move(with)});
    }

    // `line` without a line end; it gets the file's own.
    void insert_below(const diagnostic::Range& range, const std::string& line) {
        const std::size_t below = range.start.line;  // index of the next line
        const bool is_last = below >= starts_.size();
        const std::size_t place = is_last ? text_.size() : starts_[below];
        const bool has_carriage_return = !is_last && place >= 2 && text_[place - 2] == '\r';
        const std::string end = has_carriage_return ? "\r\n" : "\n";
        edits_.push_back({place, place, (is_last ? end : "") + line + end});
    }

    std::string result() {
        std::sort(edits_.begin(), edits_.end(),
                  [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
        std::string text(text_);
        for (const Edit& edit : edits_) {
            text.replace(edit.begin, edit.end - edit.begin, edit.with);
        }
        return text;
    }

  private:
    struct Edit {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::string with;
    };

    std::size_t offset(const diagnostic::Position& position) const {
        return starts_[position.line - 1] + position.column - 1;
    }

    std::string_view text_;
    std::vector<std::size_t> starts_;
    std::vector<Edit> edits_;
};

// `value` in the notation of what stood there: hexadecimal with as many digits, or decimal. TOML's other
// spellings (0b1, 1_665, 0x6_81) become one of these.
std::string in_notation_of(std::string_view literal, std::uint32_t value) {
    if (!literal.starts_with("0x")) {
        return fmt::format("{}", value);
    }
    const auto underscores = std::count(literal.begin(), literal.end(), '_');
    const std::size_t digits = literal.size() - 2 - static_cast<std::size_t>(underscores);
    const bool is_lower = literal.find_first_of("abcdef", 2) != std::string_view::npos;
    return is_lower ? fmt::format("0x{:0{}x}", value, digits) : fmt::format("0x{:0{}X}", value, digits);
}

void replace_number(Edits& edits, const Assignment& assignment, std::uint32_t value) {
    const std::string_view literal = edits.at(assignment.where.range);
    edits.replace(assignment.where.range, in_notation_of(literal, value));
}

void replace_title(Edits& edits, std::string_view text, const std::string& title) {
    diagnostic::Findings none;  // the text was read before
    const std::optional<toml::Node> document = toml::parse(text, "", none);
    if (!document) {
        return;
    }
    if (const toml::Entry* present = document->find("title")) {
        edits.replace(present->value.range, toml_string(title));
    } else if (const toml::Entry* format = document->find("format")) {
        edits.insert_below(format->key_range, fmt::format("title = {}", toml_string(title)));
    }
}

// One identifier of TPDO5..16 and what the copy makes of it.
struct Identifier {
    const Assignment* assignment = nullptr;
    int tpdo = 0;
    std::uint32_t original = 0;
    bool follows_node = false;
    bool active = false;
};

std::vector<Identifier> identifiers_of(const parameter::Settings& settings,
                                       const config::Configuration& configuration) {
    std::vector<Identifier> all;
    for (int tpdo = gateway::first_tpdo_of_own_identifier; tpdo <= config::tpdo_count; ++tpdo) {
        const std::uint16_t number = gateway::tpdo_identifier_of(tpdo);
        const Assignment* assignment = settings.gateway.find(number);
        if (assignment != nullptr && assignment->value != 0) {
            const std::uint32_t identifier = settings.gateway.integer(number);
            const bool follows_node = facts::cob::follows_node(identifier, configuration.node_id);
            all.push_back({assignment, tpdo, identifier, follows_node, configuration.tpdo(tpdo).active});
        }
    }
    return all;
}

// What PDOs of the original and, as far as they follow its node id, of the copy have.
std::set<std::uint32_t> taken_identifiers(const std::vector<Identifier>& identifiers,
                                          const config::Configuration& configuration, std::uint32_t node_id) {
    std::set<std::uint32_t> taken;
    for (const config::Pdo& pdo : configuration.pdos) {
        taken.insert(pdo.cob_id);
    }
    for (const Identifier& identifier : identifiers) {
        taken.insert(identifier.follows_node ? facts::cob::of_other_node(identifier.original, node_id)
                                             : identifier.original);
    }
    return taken;
}

std::string free_help(std::set<std::uint32_t>& taken) {
    std::string text;
    for (std::uint32_t candidate = facts::first_free_identifier; candidate <= facts::last_free_identifier;
         ++candidate) {
        if (taken.insert(candidate).second) {
            text = fmt::format("0x{0:X} is free for the copy: --identifiers-from 0x{0:X}; ", candidate);
            break;
        }
    }
    return text + "--keep-identifiers is for a copy on another network";
}

void report_shared(const Identifier& identifier, const config::Configuration& configuration,
                   std::set<std::uint32_t>& taken, diagnostic::Findings& findings) {
    findings.report({&diagnostic::rules::clone_identifier,
                     fmt::format("TPDO{} would be sent under {:03X}h by both gateways; {} is not of the "
                                 "form base + node id {}",
                                 identifier.tpdo, identifier.original,
                                 parameter::label(*identifier.assignment->row), configuration.node_id),
                     identifier.assignment->where,
                     {},
                     free_help(taken)});
}

// Why `value` is none for the copy, or "".
std::string why_not(std::uint32_t value, const std::set<std::uint32_t>& taken) {
    if (!facts::is_free_identifier(value)) {
        return fmt::format("it is outside {:03X}h to {:03X}h, which CiA 301 leaves free",
                           facts::first_free_identifier, facts::last_free_identifier);
    }
    return taken.contains(value) ? "a PDO of the original or of the copy has it" : "";
}

void replace_identifiers(Edits& edits, const parameter::Settings& settings,
                         const config::Configuration& configuration, const CloneRequest& request,
                         diagnostic::Findings& findings) {
    const std::vector<Identifier> identifiers = identifiers_of(settings, configuration);
    std::set<std::uint32_t> taken = taken_identifiers(identifiers, configuration, request.node_id);
    std::uint32_t next = request.identifiers_from.value_or(0);
    for (const Identifier& identifier : identifiers) {
        if (identifier.follows_node) {
            replace_number(edits, *identifier.assignment,
                           facts::cob::of_other_node(identifier.original, request.node_id));
        } else if (identifier.active && !request.identifiers_from) {
            report_shared(identifier, configuration, taken, findings);
        } else if (identifier.active) {
            const std::uint32_t value = next++;
            if (const std::string why = why_not(value, taken); !why.empty()) {
                findings.report(
                    {&diagnostic::rules::clone_identifier,
                     fmt::format("TPDO{} of the copy cannot have {:03X}h: {}", identifier.tpdo, value, why),
                     identifier.assignment->where,
                     {},
                     free_help(taken)});
            }
            replace_number(edits, *identifier.assignment, value);
        }
    }
}

}  // namespace

std::optional<std::string> clone_text(std::string_view text, const parameter::Settings& settings,
                                      const config::Configuration& configuration, const CloneRequest& request,
                                      diagnostic::Findings& findings) {
    Edits edits(text);
    if (const Assignment* node = settings.gateway.find(gateway::node_id)) {
        replace_number(edits, *node, request.node_id);
    }
    if (request.title) {
        replace_title(edits, text, *request.title);
    }
    if (!request.keep_identifiers) {
        replace_identifiers(edits, settings, configuration, request, findings);
    }
    if (findings.has_errors()) {
        return std::nullopt;
    }
    return edits.result();
}

}  // namespace cgw::authoring
