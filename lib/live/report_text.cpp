#include <fmt/format.h>
#include <algorithm>

#include "base/utf8.hpp"
#include "explain/text.hpp"
#include "facts/communication.hpp"
#include "live/report.hpp"
#include "live/sources.hpp"

namespace cgw::live {
namespace {

using Kind = Question::Kind;

constexpr std::size_t most_shown = 25;  // differences; the JSON document has all

// Wrapped, further lines further in.
std::string paragraph(std::string_view first, std::string_view text) {
    std::string result;
    const std::string shown = base::printable(text);
    for (const std::string& line : explain::wrap(shown, explain::page_width - first.size())) {
        result += result.empty() ? std::string(first) : std::string(first.size(), ' ');
        result += line + "\n";
    }
    return result;
}

bool is_about_content(DifferenceKind kind) {
    return kind == DifferenceKind::value || kind == DifferenceKind::missing ||
           kind == DifferenceKind::unexpected;
}

std::string side(std::string_view who, const Question& question, std::uint32_t value, std::uint8_t length) {
    const std::string meaning = meaning_of(question, value);
    return fmt::format("    {:<8}{}{}{}\n", who, value_text(value, length), meaning.empty() ? "" : "  ",
                       meaning);
}

std::string difference_text(const Subject& subject, const Question& question, const Difference& difference) {
    const std::string separator = question.name.empty() ? "" : " ";
    std::string text = paragraph("", question.object_text() + separator + question.name);
    if (difference.kind == DifferenceKind::value) {
        text += side("file", question, question.expected, question.length);
        text += side("device", question, *difference.value, difference.length);
    } else {
        text += paragraph("    ", sentence_of(question, difference));
    }
    const Sources sources =
        sources_of(question.index, question.sub_index, subject.settings, subject.catalogue);
    if (is_about_content(difference.kind) && !sources.text.empty()) {
        text += paragraph("    from    ", sources.text);
    }
    return text;
}

std::string differences_text(const Subject& subject, const Verification& verification) {
    const std::vector<Difference>& differences = verification.result().differences;
    std::string text;
    for (std::size_t i = 0; i < std::min(differences.size(), most_shown); ++i) {
        text += difference_text(subject, verification.plan()[differences[i].question], differences[i]) + "\n";
    }
    if (differences.size() > most_shown) {
        text += fmt::format("and {} more differences, all of which are in --format json\n\n",
                            differences.size() - most_shown);
    }
    return text;
}

struct Tally {
    std::size_t asked = 0;
    std::size_t wrong = 0;
};

Tally tally(const Verification& verification, std::initializer_list<Kind> kinds) {
    const auto counts = [&](std::size_t question) {
        return std::find(kinds.begin(), kinds.end(), verification.plan()[question].kind) != kinds.end();
    };
    Tally result;
    for (std::size_t i = 0; i < verification.result().asked; ++i) {
        result.asked += counts(i) ? 1U : 0U;
    }
    for (const Difference& difference : verification.result().differences) {
        result.wrong += counts(difference.question) ? 1U : 0U;
    }
    return result;
}

std::string tally_line(std::string_view what, Tally tally) {
    const std::string wrong = tally.wrong == 0   ? "as expected"
                              : tally.wrong == 1 ? "1 is not as expected"
                                                 : fmt::format("{} are not as expected", tally.wrong);
    return fmt::format("  {:>4} {:<47}{}\n", tally.asked, what, wrong);
}

std::string summary(const Subject& subject, const Verification& verification) {
    std::string text = tally_line("values of the configuration", tally(verification, {Kind::value}));
    text += tally_line("process values, by type", tally(verification, {Kind::type}));
    if (subject.wrote) {
        text += tally_line("writes that must be refused", tally(verification, {Kind::not_writable}));
    }
    text += tally_line("objects and sub-indexes that must not exist",
                       tally(verification, {Kind::no_sub_index, Kind::no_object}));
    return text;
}

std::string agreement(const Subject& subject) {
    std::string text = "\nThe device has the configuration of the file, as far as CANopen shows it.\n";
    text +=
        paragraph("- ",
                  "not to be seen, and so not compared: which measurement of the same sign a word carries, "
                  "bits and channels of switches and sensors, the HEINZMANN bus");
    if (subject.wrote) {
        text +=
            paragraph("- ",
                      "the EDS calls 2003h and 2004h writable (rww), and the device refuses to write them: "
                      "that is as it should be (D29)");
    }
    return text;
}

std::string verdict(const Subject& subject, const Verification& verification) {
    const Result& result = verification.result();
    if (result.same()) {
        return agreement(subject);
    }
    if (result.ending != Ending::complete) {
        return {};
    }
    std::string text = fmt::format("\nThe device differs from the file in {} point{}.\n",
                                   result.differences.size(), result.differences.size() == 1 ? "" : "s");
    if (std::any_of(result.differences.begin(), result.differences.end(),
                    [](const Difference& difference) { return is_about_content(difference.kind); })) {
        text += paragraph("- ",
                          "a device takes a new configuration over when it is reset: save the parameters in "
                          "governor and gateway, then reset both (GWM 7)");
    }
    return text;
}

std::string device_line(const Verification& verification) {
    std::string text;
    for (std::size_t i = 0; i < verification.plan().size(); ++i) {
        const Question& question = verification.plan()[i];
        const std::optional<std::uint32_t>& value = verification.result().values[i];
        if (question.index == facts::object::identity && question.sub_index != 0 && value &&
            question.kind != Kind::not_writable) {
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                                question.name.substr(question.name.find(',') + 2),
                                value_text(*value, question.length));
        }
    }
    return text.empty() ? "" : paragraph("device  ", text);
}

}  // namespace

std::string render_text(const Subject& subject, const Verification& verification,
                        const Connection& connection) {
    std::string text =
        paragraph("file    ", fmt::format("{}, configuration {}", subject.path, subject.configuration_id));
    text += paragraph("node    ", fmt::format("{} on {}", subject.configuration.node_id, subject.channel));
    text += device_line(verification) + "\n";
    if (verification.result().ending != Ending::other_device) {
        text += differences_text(subject, verification);
    }
    const std::vector<std::string> lines = diagnosis(subject, verification, connection);
    for (const std::string& line : lines) {
        text += paragraph("- ", line);
    }
    if (verification.result().answers != 0 && verification.result().ending != Ending::other_device) {
        text += (lines.empty() ? "" : "\n") + summary(subject, verification);
    }
    if (verification.result().heard.other_client) {
        text += paragraph(
            "", fmt::format("Somebody else also asks node {} by SDO: answers may have been mixed up.",
                            subject.configuration.node_id));
    }
    return text + verdict(subject, verification);
}

}  // namespace cgw::live
