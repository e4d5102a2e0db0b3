// Inside the xdd room: the parts of the writer, each in the file of its name.
#pragma once

#include <optional>

#include "dictionary/data_types.hpp"
#include "dictionary/dictionary.hpp"
#include "xdd/xml_printer.hpp"

namespace cgw::xdd {

// Attributes of both profile bodies.
Attributes body_attributes(std::string_view type, const dictionary::FileInformation& file);

// `node` is nullptr for a device description.

void device_body(XmlPrinter& out, const dictionary::Dictionary& dictionary,
                 const dictionary::Commissioning* node);  // write_device.cpp
void network_body(XmlPrinter& out, const dictionary::Dictionary& dictionary,
                  const dictionary::Commissioning* node);  // write_network.cpp

// The identifier that links an object to its parameter.
std::string parameter_id(const dictionary::Object& object, const dictionary::Variable& variable);

// Adds an attribute unless its value is "".
void add(Attributes& attributes, std::string_view name, std::string value);

// What a value is written as; nothing where an empty text would say that there is none. An empty string is
// one.
std::optional<std::string> written(const dictionary::Value& value, const dictionary::TypeRow& type);

}  // namespace cgw::xdd
