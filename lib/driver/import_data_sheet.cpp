#include "driver/import_data_sheet.hpp"

#include <fmt/format.h>

#include "authoring/from_data_sheet.hpp"
#include "base/utf8.hpp"
#include "base/wrap.hpp"
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
std::string title_of(const DeviceDescription& sheet) {
    const std::string& description = sheet.dictionary.file.description;
    const proof::Identified parts = proof::split_id(description);
    const std::string title(parts.id.empty() ? "" : parts.text);
    return title == profile::untitled_description() ? "" : base::printable(title);
}

std::vector<std::string> remarks_of(const std::vector<std::string>& undetermined,
                                    const dictionary::Differences& differences) {
    std::vector<std::string> remarks;
    add_remark(remarks, "From a data sheet, by cgw import eds. What it does not say:");
    for (const std::string& each : undetermined) {
        add_remark(remarks, "- " + each);
    }
    if (differences.same()) {
        add_remark(remarks, "The gateway of this file has exactly the objects and values of the data sheet.");
    } else {
        add_remark(remarks,
                   fmt::format("The gateway of this file differs from the data sheet in {} {}.",
                               differences.all.size(), differences.all.size() == 1 ? "point" : "points"));
    }
    return remarks;
}

}  // namespace

ImportedDataSheet import_data_sheet(const DeviceDescription& sheet, const std::string& path,
                                    const ImportOptions& options) {
    const authoring::DataSheetSource source{
        sheet.dictionary, sheet.commissioning ? &*sheet.commissioning : nullptr, options.node_id};
    const std::string title = options.title.empty() ? title_of(sheet) : options.title;
    ImportedDataSheet imported;
    authoring::FileFromDataSheet made = authoring::file_from_data_sheet(source, {}, title);
    imported.undetermined = std::move(made.undetermined);
    const CheckedFile plain = check_text(path, made.text);
    const dictionary::Dictionary gateway = profile::gateway_dictionary(plain.configuration, {});
    const std::uint8_t node_id = plain.configuration.node_id;
    const std::optional<std::uint8_t> known = node_id != 0 ? std::optional(node_id) : std::nullopt;
    imported.differences = dictionary::differences({sheet.dictionary}, {gateway}, {.node_id = known});
    // Comments change nothing of what the text means, only the lines of findings.
    imported.text =
        options.first_line + authoring::file_from_data_sheet(
                                 source, remarks_of(imported.undetermined, imported.differences), title)
                                 .text;
    imported.file = check_text(path, imported.text);
    return imported;
}

}  // namespace cgw::driver
