#include "toml/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/utf8.hpp"
#include "diagnostic/rules/files.hpp"
#include "toml/judge.hpp"
#include "toml/scanner.hpp"
#include "toml/source.hpp"

namespace cgw::toml {
namespace {

void report(Complaint complaint, const std::string& path, diagnostic::Findings& findings) {
    diagnostic::Diagnostic finding{complaint.rule, std::move(complaint.message), {path, complaint.where}};
    finding.help = std::move(complaint.help);
    if (complaint.related) {
        finding.related.push_back({{path, *complaint.related}, std::move(complaint.related_message)});
    }
    findings.report(std::move(finding));
}

}  // namespace

std::string_view to_text(Kind kind) {
    switch (kind) {
        case Kind::string:
            return "a string";
        case Kind::integer:
            return "an integer";
        case Kind::real:
            return "a decimal number";
        case Kind::boolean:
            return "a boolean";
        case Kind::local_date:
            return "a date";
        case Kind::other_time:
            return "a date with time";
        case Kind::array:
            return "a list";
        case Kind::table:
            return "a table";
    }
    return "";
}

const Entry* Node::find(std::string_view key) const {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

std::string quoted(std::string_view key) {
    constexpr std::size_t longest = 80;
    std::size_t length = 0;
    while (length < key.size() && length < longest) {
        length += std::max<std::size_t>(base::utf8_sequence_length(key.substr(length)), 1);
    }
    std::string text(key.substr(0, length));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }, '?');
    return fmt::format("`{}{}`", text, length < key.size() ? "..." : "");
}

std::optional<Node> parse(std::string_view text, const std::string& path, diagnostic::Findings& findings) {
    if (text.size() > maximum_file_size) {
        report({&diagnostic::rules::file_too_large,
                {},
                fmt::format("the file has {} bytes; the limit is {}", text.size(), maximum_file_size)},
               path, findings);
        return std::nullopt;
    }
    const Source source(text);
    if (auto complaint = check_characters(source)) {
        report(std::move(*complaint), path, findings);
        return std::nullopt;
    }
    try {
        ScanResult scanned = scan(source);
        for (Complaint& complaint : scanned.out_of_range) {
            report(std::move(complaint), path, findings);
        }
        if (!scanned.out_of_range.empty()) {
            return std::nullopt;
        }
        if (auto complaint = judge(scanned.text_for_judge, scanned.document)) {
            report(std::move(*complaint), path, findings);
            return std::nullopt;
        }
        return std::move(scanned.document);
    } catch (Complaint& complaint) {
        report(std::move(complaint), path, findings);
        return std::nullopt;
    }
}

}  // namespace cgw::toml
