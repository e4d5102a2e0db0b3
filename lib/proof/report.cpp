#include <fmt/format.h>

#include <array>

#include "base/json.hpp"
#include "base/utf8.hpp"
#include "proof/proof.hpp"

namespace cgw::proof {
namespace {

constexpr int format_version = 1;
constexpr std::size_t line_width = 80;
constexpr std::size_t most_shown = 50;  // differences of one artefact; the JSON document has all

std::string shown(std::string_view text) {
    return text.empty() ? "nothing" : base::printable(text);
}

std::string difference_text(const dictionary::Difference& difference) {
    const std::string subject = base::printable(subject_text(difference));
    const std::string what =
        fmt::format("{}{}{}", subject, subject.empty() ? "" : ", ", difference.aspect_text);
    std::string line = fmt::format("  {}: {}, not {}\n", what, shown(difference.b), shown(difference.a));
    if (base::width_of(line) > line_width + 1) {
        line = fmt::format("  {}\n      is      {}\n      not     {}\n", what, shown(difference.b),
                           shown(difference.a));
    }
    return line;
}

std::string proof_text(const Proof& proof) {
    const dictionary::Differences& found = proof.differences;
    std::string text = fmt::format("\n{} ({}): ", base::printable(proof.path), proof.kind);
    text += found.same()
                ? fmt::format("the same; {}\n", proof.compared)
                : fmt::format("{} difference{}\n", found.all.size(), found.all.size() == 1 ? "" : "s");
    if (proof.strict_errors != 0) {
        text += fmt::format("  strict importers refuse it: {} error{}\n", proof.strict_errors,
                            proof.strict_errors == 1 ? "" : "s");
    }
    for (std::size_t i = 0; i < std::min(found.all.size(), most_shown); ++i) {
        text += difference_text(found.all[i]);
    }
    if (found.all.size() > most_shown) {
        text += fmt::format("  and {} more; --format json has all\n", found.all.size() - most_shown);
    }
    if (!found.not_compared.empty()) {
        text +=
            fmt::format("  not compared, for they are left out: {}\n", fmt::join(found.not_compared, ", "));
    }
    return text;
}

std::string render_text(const Subject& subject, std::span<const Proof> proofs) {
    std::string text = fmt::format("{}: configuration {}, node {}\n", base::printable(subject.path),
                                   subject.configuration_id, subject.node_id);
    for (const Proof& proof : proofs) {
        text += proof_text(proof);
    }
    text +=
        all_same(proofs)
            ? "\nAll describe the device that the parameter file makes.\n"
            : "\nNot the device that the parameter file makes: write the artefacts again with cgw build.\n";
    return text;
}

std::string render_json(const Subject& subject, std::span<const Proof> proofs) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("same").boolean(all_same(proofs));
    json.key("path").string(subject.path);
    json.key("configuration_id").string(subject.configuration_id);
    json.key("node_id").integer(subject.node_id);
    json.key("artefacts").begin_array();
    for (const Proof& proof : proofs) {
        json.begin_object();
        json.key("path").string(proof.path);
        json.key("kind").string(proof.kind);
        json.key("same").boolean(proof.differences.same());
        json.key("strict_errors").integer(static_cast<std::int64_t>(proof.strict_errors));
        json.key("differences").begin_array();
        for (const dictionary::Difference& difference : proof.differences.all) {
            write_json(json, difference, "expected", "found");
        }
        json.end_array();
        json.key("not_compared").begin_array();
        for (const std::string_view what : proof.differences.not_compared) {
            json.string(what);
        }
        json.end_array();
        json.end_object();
    }
    json.end_array();
    json.end_object();
    return json.take();
}

constexpr std::array all_formats{
    Format{"human", "for people", render_text},
    Format{"json", "one JSON document", render_json},
};

}  // namespace

std::span<const Format> formats() {
    return all_formats;
}

}  // namespace cgw::proof
