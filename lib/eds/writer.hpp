// A dictionary as an electronic data sheet (CiA 306), or as the device configuration file of one node: CRLF,
// only the keys that strict importers know. What is written reads back as the same dictionary, but for what
// docs/conversions.md lists.
//
// Sections: FileInfo, DeviceInfo, DummyUsage, Comments, then MandatoryObjects, OptionalObjects and
// ManufacturerObjects, each list followed by the sections of its objects in ascending order, sub-objects
// after their object; then the modules of a modular device. A key that is optional and says nothing is left
// out.
//
// Values of objects: eds/value_text.hpp. Object codes are 0x7, 0x8, 0x9, data types and indices four digits.
// Counts, flags and versions are decimal.
//
// A configuration file differs in these: LastEDS, [DeviceComissioning] (the standard's own spelling),
// [ConnectedModules], and of each object ParameterValue, Denotation, UploadFile and DownloadFile. Values that
// follow the node number stay so; dictionary/node.hpp resolves them.
//
// Texts: brought to ASCII, ';' becomes ',' (importers cut values there), cut where the line would exceed 255
// characters, which is where each length limit of CiA 306 for a text comes from. Values that are strings are
// neither cut nor changed, but for line ends, which become blanks.
#pragma once

#include <string>

#include "dictionary/dictionary.hpp"

namespace cgw::eds {

std::string write(const dictionary::Dictionary& dictionary);
std::string write(const dictionary::Dictionary& dictionary, const dictionary::Commissioning& node);

}  // namespace cgw::eds
