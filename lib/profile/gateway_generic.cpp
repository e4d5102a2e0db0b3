// The generic face of the EDS (D40): what the manual prints, in the rows of the configured one.
#include "config/numbers.hpp"
#include "parameter/catalogue.hpp"
#include "profile/gateway.hpp"

namespace cgw::profile {
namespace {

using dictionary::Dictionary;
using dictionary::Object;

constexpr std::string_view printed_author = "Heinzmann GmbH & Co. KG";
constexpr std::string_view printed_date = "05-19-2004";
constexpr std::string_view origin =
    "From the manual DG 04005-e, chapter 10, with the faults of the print mended";

constexpr std::uint32_t pdo_not_valid = 0x80000000;
constexpr std::uint16_t first_parameter_identifier = 0x1800 + config::first_analogue_tpdo;  // TPDO5
constexpr std::uint16_t last_parameter_identifier = 0x1800 + config::tpdo_count - 1;
constexpr std::size_t cob_id_position = 1;

config::Configuration nothing_configured() {
    return config::resolve(parameter::Settings{}, parameter::Catalogue({}));
}

bool is_mapping(const Object& object) {
    return (object.index >= 0x1600 && object.index < 0x1600 + config::rpdo_count) ||
           (object.index >= 0x1A00 && object.index < 0x1A00 + config::tpdo_count);
}

// D30: the generic EDS keeps the printed form of identifiers that a parameter sets. D43: its mapping objects
// have the one entry that is printed.
void as_printed(Object& object) {
    if (object.index >= first_parameter_identifier && object.index <= last_parameter_identifier) {
        object.variables[cob_id_position].default_value = {pdo_not_valid, true};
    } else if (is_mapping(object)) {
        object.variables.resize(1);
    }
}

}  // namespace

Dictionary generic_gateway_dictionary(const GatewayDocument& document) {
    Dictionary dictionary = gateway_dictionary(nothing_configured(), document);
    dictionary.file.created_by = printed_author;  // modified by cgw, on the date of the document
    dictionary.file.creation_date = printed_date;
    dictionary.comments = {std::string(origin)};
    for (Object& object : dictionary.objects) {
        as_printed(object);
    }
    return dictionary;
}

}  // namespace cgw::profile
