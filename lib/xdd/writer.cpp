#include "xdd/writer.hpp"

#include <fmt/format.h>

#include "eds/value_text.hpp"
#include "xdd/dates.hpp"
#include "xdd/words.hpp"
#include "xdd/writing.hpp"

namespace cgw::xdd {
namespace {

using dictionary::Commissioning;
using dictionary::Dictionary;

struct Header {
    std::string_view name;
    std::string_view profile_class;
};
constexpr Header device_header{"CANopen device profile", "Device"};
constexpr Header network_header{"CANopen communication network profile", "CommunicationNetwork"};

// Outside the name space (see writer.hpp).
void header(XmlPrinter& out, const Header& of) {
    out.open("ProfileHeader", {{"xmlns", ""}});
    out.leaf("ProfileIdentification", of.name);
    out.leaf("ProfileRevision", "1.1");
    out.leaf("ProfileName", "");
    out.leaf("ProfileSource", "");
    out.leaf("ProfileClassID", of.profile_class);
    out.open("ISO15745Reference");
    out.leaf("ISO15745Part", "1");
    out.leaf("ISO15745Edition", "1");
    out.leaf("ProfileTechnology", "CANopen");
    out.close();
    out.close();
}

std::string write_all(const Dictionary& dictionary, const Commissioning* node) {
    XmlPrinter out;
    out.line(R"(<?xml version="1.0" encoding="UTF-8"?>)");
    out.open("ISO15745ProfileContainer", {{"xmlns", std::string(name_space)},
                                          {"xmlns:co", std::string(name_space)},
                                          {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"}});
    out.open("ISO15745Profile");
    header(out, device_header);
    device_body(out, dictionary, node);
    out.close();
    out.open("ISO15745Profile");
    header(out, network_header);
    network_body(out, dictionary, node);
    out.close();
    out.close();
    return out.take();
}

}  // namespace

std::optional<std::string> written(const dictionary::Value& value, const dictionary::TypeRow& type) {
    std::string text = eds::value_text(value, type);
    const bool is_string = type.kind == dictionary::TypeKind::visible_string ||
                           type.kind == dictionary::TypeKind::unicode_string;
    return text.empty() && !is_string ? std::nullopt : std::optional(std::move(text));
}

void add(Attributes& attributes, std::string_view name, std::string value) {
    if (!value.empty()) {
        attributes.push_back({name, std::move(value)});
    }
}

Attributes body_attributes(std::string_view type, const dictionary::FileInformation& file) {
    const std::string created = xml_date(file.creation_date);
    Attributes attributes{{"xmlns", ""},
                          {"xsi:type", fmt::format("co:{}", type)},
                          {"formatName", "CANopen"},
                          {"formatVersion", "1.0"},
                          {"fileName", file.file_name},
                          {"fileCreator", file.created_by},
                          {"fileCreationDate", created.empty() ? std::string(no_date) : created}};
    add(attributes, "fileCreationTime", xml_time(file.creation_time));
    add(attributes, "fileModifiedBy", file.modified_by);
    add(attributes, "fileModificationDate", xml_date(file.modification_date));
    add(attributes, "fileModificationTime", xml_time(file.modification_time));
    attributes.push_back({"fileVersion", file.file_revision == 0
                                             ? fmt::format("{}", file.file_version)
                                             : fmt::format("{}.{}", file.file_version, file.file_revision)});
    attributes.push_back({"supportedLanguages", "en"});
    return attributes;
}

std::string parameter_id(const dictionary::Object& object, const dictionary::Variable& variable) {
    return has_sub_objects(object.code)
               ? fmt::format("UID_SUB_{:04X}{:02X}", object.index, variable.sub_index)
               : fmt::format("UID_OBJ_{:04X}", object.index);
}

std::string write(const Dictionary& dictionary) {
    return write_all(dictionary, nullptr);
}

std::string write(const Dictionary& dictionary, const Commissioning& node) {
    return write_all(dictionary, &node);
}

}  // namespace cgw::xdd
