// Inside the xdd room: the parts of the reader, each in the file of its name.
#pragma once

#include <string_view>
#include <unordered_map>

#include "xdd/reader.hpp"
#include "xdd/source.hpp"

namespace cgw::xdd {

// What the profile bodies of a file hold; an empty node is not there.
struct Parts {
    pugi::xml_node device_body;
    pugi::xml_node network_body;
    pugi::xml_node objects;  // CANopenObjectList
};

// The parameters of a file by their uniqueID, and what they refer to. Any number of objects may refer to one
// long parameter: what is looked through for them all is bounded, and what is beyond is a finding.
class Parameters {
  public:
    Parameters(Source& source, pugi::xml_node device_body);

    // The parameter that an object names; empty when it names none, or after a finding, one that is not
    // there.
    pugi::xml_node of(pugi::xml_node object);

    // A child element of the parameter, or of its template.
    pugi::xml_node child(pugi::xml_node parameter, std::string_view name) const;
    std::string_view access(pugi::xml_node parameter) const;  // "" where it is not stated: then it is read

    // Nothing for a parameter without a type that is a data type of CANopen by itself, BITSTRING above all.
    const dictionary::TypeRow* type(pugi::xml_node parameter) const;

    bool is_bit_string(pugi::xml_node parameter) const;
    bool names_type(pugi::xml_node parameter) const;  // by a dataTypeIDRef, whether it can be read or not

  private:
    pugi::xml_node template_of(pugi::xml_node parameter) const;
    pugi::xml_node find(const char* id) const;
    void charge(const char* id) const;  // an object has what this names looked through
    std::size_t length_of(pugi::xml_node element) const;
    const dictionary::TypeRow* type_in(pugi::xml_node element, unsigned depth) const;

    struct Named {
        pugi::xml_node element;
        std::size_t length = 0;  // characters of its text, about
    };

    Source& source_;
    std::unordered_map<std::string_view, Named> by_id_;  // of all elements that have a uniqueID
    mutable std::size_t looked_through_ = 0;             // characters of what was referred to
};

void read_information(Source& source, const Parts& parts, dictionary::Dictionary& dictionary);
std::optional<dictionary::Commissioning> read_commissioning(Source& source, const Parts& parts);

// One object or sub-object with its parameter.
struct Element {
    pugi::xml_node object;
    pugi::xml_node parameter;  // may be empty
};

std::string name_of(const Element& here);
std::string denotation_of(const Parameters& parameters, const Element& here);

// Nothing after a finding, when type or access cannot be read.
std::optional<dictionary::Variable> read_variable(Source& source, const Parameters& parameters,
                                                  const Element& here, object::ObjectCode code);

std::vector<dictionary::Object> read_objects(Source& source, const Parts& parts, Parameters& parameters);

// find_unread.cpp: elements by name, then attributes by name, then comments.
std::vector<Unread> find_unread(pugi::xml_node root);

// The text of the first `label` of an element; "" when it has none.
std::string label_of(pugi::xml_node element);

}  // namespace cgw::xdd
