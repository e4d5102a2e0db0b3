// The generic face of the EDS (D40): what the manual prints, in the rows of the configured one.
#include "facts/communication.hpp"
#include "facts/gateway.hpp"
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

namespace objects = facts::object;

// TPDO5..16
constexpr std::uint16_t first_parameter_identifier = objects::tpdo_communication + facts::predefined_pdos;
constexpr std::uint16_t last_parameter_identifier = objects::tpdo_communication + facts::tpdo_count - 1;

config::Configuration nothing_configured() {
    return config::resolve(parameter::Settings{}, parameter::Catalogue({}));
}

bool is_mapping(const Object& object) {
    const auto is_one_of = [&object](std::uint16_t first, unsigned count) {
        return object.index >= first && object.index < first + count;
    };
    return is_one_of(objects::rpdo_mapping, facts::rpdo_count) ||
           is_one_of(objects::tpdo_mapping, facts::tpdo_count);
}

// D30: the generic EDS keeps the printed form of identifiers that a parameter sets. D43: its mapping objects
// have the one entry that is printed.
void as_printed(Object& object) {
    if (object.index >= first_parameter_identifier && object.index <= last_parameter_identifier) {
        object.variables[objects::cob_id_sub].default_value = {facts::pdo_not_valid, true};
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
