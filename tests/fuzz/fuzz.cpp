#include "fuzz/fuzz.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "diagnostic/renderers.hpp"
#include "diagnostic/source_lines.hpp"
#include "driver/plant.hpp"
#include "emit/emitter.hpp"
#include "image/layout.hpp"
#include "wire/crc32.hpp"

namespace cgw::fuzz {
namespace {

void demand_inside(const diagnostic::Location& where, const std::map<std::string, std::string>& sources,
                   diagnostic::SourceLines& lines) {
    const diagnostic::Range& range = where.range;
    if (range.start.line == 0) {
        return;  // the whole file
    }
    demand(sources.contains(where.path), "a finding points into a text that is there");
    demand(range.start <= range.end && range.start.column >= 1, "a finding's range has an order");
    // Columns count a byte order mark; the end may be that of the line.
    const std::size_t room = lines.line(where.path, range.start.line).size() + 5;
    demand(range.start.column <= room, "a finding stands inside its line");
}

}  // namespace

void demand(bool holds, std::string_view what) {
    if (!holds) {
        std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
        std::abort();
    }
}

bool sometimes(Input input, unsigned n) {
    const std::size_t counted = input.size() - std::min<std::size_t>(input.size(), image::crc_size);
    return wire::crc32(input.first(counted)) % n == 0;
}

void demand_sound(const diagnostic::FileReport& report, const std::map<std::string, std::string>& sources) {
    diagnostic::SourceLines lines(sources);
    for (const diagnostic::Diagnostic& finding : report.findings) {
        demand(finding.rule != nullptr && !finding.message.empty(), "a finding has a rule and a message");
        demand_inside(finding.where, sources, lines);
        for (const diagnostic::Related& related : finding.related) {
            demand_inside(related.where, sources, lines);
        }
    }
    diagnostic::RenderInput input;
    input.files = {report};
    input.sources = sources;
    for (const diagnostic::Renderer& renderer : diagnostic::all_renderers()) {
        const bool tells_every_rule = renderer.name == "sarif";
        if (!tells_every_rule || report.findings.size() % 16 == 7) {
            renderer.render(input);
        }
    }
}

Parts split(Input input, std::string_view separator) {
    const std::string text(input.begin(), input.end());
    const std::string line = "\n" + std::string(separator) + "\n";
    const std::size_t at = text.find(line);
    if (at == std::string::npos) {
        return {text, {}, false};
    }
    return {text.substr(0, at + 1), text.substr(at + line.size()), true};
}

base::Bytes image_of(const driver::CheckedFile& file, bool labels) {
    const auto plant = driver::Plant::make(file);
    demand(plant.has_value(), "a valid file makes a plant");
    emit::Options options;
    options.labels = labels;
    return emit::find_emitter("image")->emit(plant->view(), options);
}

}  // namespace cgw::fuzz
