// A dictionary as an electronic data sheet (CiA 306), or as the device configuration file of one node: CRLF,
// ASCII, only the keys that strict importers know.
//
// Sections: FileInfo, DeviceInfo, DummyUsage, Comments, then MandatoryObjects, OptionalObjects and
// ManufacturerObjects, each list followed by the sections of its objects in ascending order, sub-objects
// after their object.
//
// Numbers: default values and limits are hexadecimal in the full width of their type (0x04, 0x0006,
// 0x00000161; negative ones as two's complement), values that follow the node number $NODEID+0x180. Object
// codes are 0x7, 0x8, 0x9, data types and indices four digits. Counts, flags and versions are decimal.
//
// A configuration file differs in these: LastEDS, [DeviceComissioning] (the standard's own spelling), every
// $NODEID resolved, and a ParameterValue, equal to the default, wherever the value does not change at run
// time.
//
// Texts: brought to ASCII, ';' becomes ',' (importers cut values there), cut where the line would exceed 255
// characters, which is where each length limit of CiA 306 for a text comes from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "dictionary/dictionary.hpp"
#include "eds/document.hpp"

namespace cgw::eds {

// What a configuration file says about its one node.
struct Commissioning {
    std::string last_eds;      // file name of the data sheet
    std::uint8_t node_id = 0;  // 1..127
    std::string node_name;
    std::optional<std::uint32_t> bit_rate_kbit;  // the key is left out when it is not known
    std::uint32_t net_number = 0;
    std::string network_name;
    bool canopen_manager = false;
    std::uint32_t serial_number = 0;  // 1018h:4
};

Document to_document(const dictionary::Dictionary& dictionary);
Document to_document(const dictionary::Dictionary& dictionary, const Commissioning& node);

// to_document() and print() in one.
std::string write(const dictionary::Dictionary& dictionary);
std::string write(const dictionary::Dictionary& dictionary, const Commissioning& node);

}  // namespace cgw::eds
