#include "driver/import_data_sheet.hpp"

#include <fmt/format.h>

#include "authoring/from_data_sheet.hpp"
#include "base/utf8.hpp"
#include "base/wrap.hpp"
#include "dictionary/ascii.hpp"
#include "profile/gateway.hpp"
#include "proof/configuration_id.hpp"

namespace cgw::driver {
namespace {

constexpr std::size_t comment_width = 90;

void add_remark(std::vector<std::string>& remarks, std::string_view text) {
    const std::vector<std::string> lines = base::wrap(text, comment_width);
    remarks.insert(remarks.end(), lines.begin(), lines.end());
}

// The title stands before the configuration id in what cgw writes (profile/gateway.cpp); other descriptions
// are of the kind of device, not of the plant.
std::string stated_title(const DeviceDescription& sheet) {
    const proof::Identified parts = proof::split_id(sheet.dictionary.file.description);
    const std::string title(parts.id.empty() ? "" : parts.text);
    return title == profile::untitled_description() ? "" : base::printable(title);
}

// Of option, data sheet and plant the first that has one. A data sheet has the plant's in ASCII.
std::string title_of(const DeviceDescription& sheet, const ImportOptions& options,
                     std::vector<std::string>& contradictions) {
    std::string of_plant = options.plant != nullptr ? options.plant->settings.title : "";
    std::string of_sheet = stated_title(sheet);
    if (!options.title.empty()) {
        return options.title;
    }
    if (of_sheet.empty() || dictionary::to_ascii(of_plant) == of_sheet) {
        return of_plant;
    }
    if (!of_plant.empty()) {
        contradictions.push_back(fmt::format("title: {}, not {}", of_sheet, of_plant));
    }
    return of_sheet;
}

void add_list(std::vector<std::string>& remarks, std::string_view heading,
              const std::vector<std::string>& list) {
    if (!list.empty()) {
        add_remark(remarks, heading);
        for (const std::string& each : list) {
            add_remark(remarks, "- " + each);
        }
    }
}

std::vector<std::string> remarks_of(const ImportedDataSheet& imported, const ImportOptions& options) {
    std::vector<std::string> remarks;
    add_remark(remarks, "From a data sheet, by cgw import eds.");
    if (options.plant != nullptr) {
        add_remark(remarks,
                   fmt::format("What it cannot say is from {}.", base::printable(options.plant->path)));
    }
    add_list(remarks, options.plant != nullptr ? "What neither says:" : "What it does not say:",
             imported.undetermined);
    add_list(remarks,
             "Where the two contradict each other, this is as in the data sheet:", imported.contradictions);
    const std::size_t points = imported.differences.all.size();
    add_remark(remarks, points == 0
                            ? "The gateway of this file has exactly the objects and values of the data sheet."
                            : fmt::format("The gateway of this file differs from the data sheet in {} {}.",
                                          points, points == 1 ? "point" : "points"));
    return remarks;
}

}  // namespace

ImportedDataSheet import_data_sheet(const DeviceDescription& sheet, const std::string& path,
                                    const ImportOptions& options) {
    std::optional<authoring::PlantSource> plant;
    if (options.plant != nullptr) {
        plant.emplace(authoring::PlantSource{options.plant->settings, options.plant->configuration});
    }
    const authoring::DataSheetSource source{sheet.dictionary,
                                            sheet.commissioning ? &*sheet.commissioning : nullptr,
                                            options.node_id, plant ? &*plant : nullptr};
    ImportedDataSheet imported;
    const std::string title = title_of(sheet, options, imported.contradictions);
    authoring::FileFromDataSheet made = authoring::file_from_data_sheet(source, {}, title);
    imported.undetermined = std::move(made.undetermined);
    imported.contradictions.insert(imported.contradictions.end(), made.contradictions.begin(),
                                   made.contradictions.end());
    const CheckedFile plain = check_text(path, made.text);
    const dictionary::Dictionary gateway = profile::gateway_dictionary(plain.configuration, {});
    const std::uint8_t node_id = plain.configuration.node_id;
    const std::optional<std::uint8_t> known = node_id != 0 ? std::optional(node_id) : std::nullopt;
    imported.differences = dictionary::differences({sheet.dictionary}, {gateway}, {.node_id = known});
    // Comments change nothing of what the text means, only the lines of findings.
    imported.text = options.first_line +
                    authoring::file_from_data_sheet(source, remarks_of(imported, options), title).text;
    imported.file = check_text(path, imported.text);
    return imported;
}

}  // namespace cgw::driver
