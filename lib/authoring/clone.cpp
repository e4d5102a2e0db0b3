#include "authoring/clone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "authoring/toml_text.hpp"
#include "config/numbers.hpp"
#include "toml/document.hpp"

namespace cgw::authoring {
namespace {

namespace gateway = config::gateway;
using parameter::Assignment;

constexpr std::uint32_t node_bits = 0x7F;
constexpr std::uint32_t base_bits = 0x780;

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

// `value` in the notation of what stood there: hexadecimal with as many digits, or decimal.
std::string in_notation_of(std::string_view literal, std::uint32_t value) {
    if (!literal.starts_with("0x")) {
        return fmt::format("{}", value);
    }
    const std::size_t digits = literal.size() - 2;
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

void replace_identifiers(Edits& edits, const parameter::Settings& settings,
                         const config::Configuration& configuration, std::uint32_t node_id,
                         diagnostic::Findings& findings) {
    constexpr int first_tpdo = 5;
    for (int tpdo = first_tpdo; tpdo <= config::tpdo_count; ++tpdo) {
        const auto number = static_cast<std::uint16_t>(gateway::tpdo_identifier + tpdo - first_tpdo);
        const Assignment* assignment = settings.gateway.find(number);
        if (assignment == nullptr || assignment->value == 0) {
            continue;
        }
        const std::uint32_t identifier = settings.gateway.integer(number);
        const bool follows_node =
            (identifier & node_bits) == configuration.node_id && (identifier & base_bits) != 0;
        if (follows_node) {
            replace_number(edits, *assignment, (identifier & base_bits) | node_id);
        } else if (configuration.tpdo(tpdo).active) {
            findings.report(
                {&diagnostic::rules::clone_identifier,
                 fmt::format("TPDO{} would be sent under {:03X}h by both gateways; {} is not of the "
                             "form base + node id {}",
                             tpdo, identifier, parameter::label(*assignment->row), configuration.node_id),
                 assignment->where,
                 {},
                 "give the original an identifier that ends in its node id, or use "
                 "--keep-identifiers for a copy on another network"});
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
        replace_identifiers(edits, settings, configuration, request.node_id, findings);
    }
    if (findings.has_errors()) {
        return std::nullopt;
    }
    return edits.result();
}

}  // namespace cgw::authoring
