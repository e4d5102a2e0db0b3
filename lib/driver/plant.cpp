#include "driver/plant.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "base/sha256.hpp"
#include "driver/dates.hpp"
#include "profile/gateway.hpp"

namespace cgw::driver {
namespace {

constexpr std::array<std::uint16_t, 3> version_numbers = {CGW_VERSION_MAJOR, CGW_VERSION_MINOR,
                                                          CGW_VERSION_PATCH};
}  // namespace

std::string tool_version() {
    return fmt::format("{}.{}.{}", version_numbers[0], version_numbers[1], version_numbers[2]);
}

base::Result<emit::Origin> origin() {
    base::Result<parameter::Date> date = artefact_date(std::nullopt, std::getenv("SOURCE_DATE_EPOCH"));
    if (!date) {
        return tl::unexpected(date.error());
    }
    return emit::Origin{*date, tool_version()};
}

std::string short_configuration_id(const parameter::Settings& settings) {
    return base::short_id(parameter::configuration_id(settings));
}

base::Result<Plant> Plant::make(const CheckedFile& file) {
    const parameter::Settings& settings = file.settings;
    base::Result<parameter::Date> date =
        artefact_date(settings.document.created, std::getenv("SOURCE_DATE_EPOCH"));
    if (!date) {
        return tl::unexpected(date.error());
    }
    Plant plant(file);
    plant.configuration_id_ = parameter::configuration_id(settings);
    profile::GatewayDocument document;
    document.title = settings.title;
    document.created = *date;
    document.author = settings.document.author;
    document.revision = settings.document.revision;
    document.configuration_id = base::short_id(plant.configuration_id_);
    document.tool_version = tool_version();
    plant.dictionary_ = profile::gateway_dictionary(file.configuration, document);
    return plant;
}

emit::Plant Plant::view() const {
    return {.settings = file_->settings,
            .catalogue = *file_->catalogue,
            .configuration = file_->configuration,
            .dictionary = dictionary_,
            .configuration_id = configuration_id_,
            .configuration_id_text = base::short_id(configuration_id_),
            .tool_version = version_numbers,
            .tool_version_text = tool_version(),
            .findings = file_->findings.all(),
            .not_verified = file_->not_verified};
}

}  // namespace cgw::driver
