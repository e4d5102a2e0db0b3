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

#include <string>

#include "dictionary/dictionary.hpp"

namespace cgw::eds {

std::string write(const dictionary::Dictionary& dictionary);
std::string write(const dictionary::Dictionary& dictionary, const dictionary::Commissioning& node);

}  // namespace cgw::eds
