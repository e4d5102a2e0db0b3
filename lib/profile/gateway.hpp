// The CANopen Gateway's object dictionary for a configuration (manual, chapters 5 and 10; D20–D43).
#pragma once

#include <string>

#include "config/configuration.hpp"
#include "dictionary/dictionary.hpp"
#include "parameter/settings.hpp"

namespace cgw::profile {

// What stands in the dictionary's file information beside the configuration.
struct GatewayDocument {
    std::string file_name = "CANopenGateway.eds";
    std::string title;
    parameter::Date created;
    std::string author;
    unsigned revision = 0;
    std::string configuration_id;  // 16 hexadecimal digits
    std::string tool_version;      // "0.1.0"
};

// What the description says where the plant has no title, without the configuration id.
std::string untitled_description();

// `configuration` comes from config::resolve().
dictionary::Dictionary gateway_dictionary(const config::Configuration& configuration,
                                          const GatewayDocument& document);

// D40: the dictionary of the EDS that the manual prints (chapter 10), faults mended, for a Gateway of which
// nothing is known: the document has no title, author and configuration id. `created` is the date on which
// cgw mended it.
dictionary::Dictionary generic_gateway_dictionary(const GatewayDocument& document);

}  // namespace cgw::profile
