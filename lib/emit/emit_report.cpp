// The report of a plant: what people read who sign for it.
#include <fmt/format.h>

#include "emit/artefacts.hpp"
#include "emit/renderings.hpp"
#include "emit/report_parts.hpp"

namespace cgw::emit {
namespace {

constexpr std::array renderings{Rendering<page::Page>{{"html", "report.html"}, page::render_html},
                                Rendering<page::Page>{{"md", "report.md"}, page::render_markdown}};
constexpr std::array formats = formats_of(renderings);

constexpr std::string_view verdicts[] = {"", "valid", "valid, with warnings",
                                         "valid by itself, but it will not work on this bus"};

// The dictionary has it as an EDS prints it, mm-dd-yyyy.
std::string date_text(std::string_view date) {
    constexpr std::size_t length = 10;
    return date.size() == length
               ? fmt::format("{}-{}-{}", date.substr(6, 4), date.substr(0, 2), date.substr(3, 2))
               : std::string(date);
}

}  // namespace

void Judgement::add(page::Tone worse, std::string reason) {
    tone = std::max(tone, worse);
    reasons.push_back(std::move(reason));
}

page::Page report_page(const Plant& plant) {
    Judgement judgement;
    Blocks sections;
    add_devices(plant, sections);
    const network::Judged bus = judge_network(plant);
    add_findings(plant, bus, sections, judgement);
    add_network(bus, sections, judgement);
    add_not_verified(plant, sections, judgement);
    add_changes(plant, sections);
    add_pdos(plant, sections);
    add_times(plant, sections);
    add_entry_sheets(plant, sections);

    page::Page page;
    const parameter::Settings& settings = plant.settings;
    page.title = settings.title.empty() ? "CANopen gateway" : settings.title;
    page.subtitle = {
        fmt::format("Configuration {}, node {}", plant.configuration_id_text, plant.configuration.node_id),
        fmt::format("{}{}{}, cgw {}", date_text(plant.dictionary.file.creation_date),
                    settings.document.author.empty() ? "" : ", ", settings.document.author,
                    plant.tool_version_text)};
    page.blocks.emplace_back(page::Verdict{
        judgement.tone,
        fmt::format("the configuration is {}", verdicts[static_cast<std::size_t>(judgement.tone)]),
        std::move(judgement.reasons)});
    page.blocks.insert(page.blocks.end(), std::make_move_iterator(sections.begin()),
                       std::make_move_iterator(sections.end()));
    return page;
}

std::span<const Format> report_formats() {
    return formats;
}

base::Bytes emit_report(const Plant& plant, const Options& options) {
    return base::to_bytes(find_rendering(renderings, options.format).render(report_page(plant)));
}

}  // namespace cgw::emit
