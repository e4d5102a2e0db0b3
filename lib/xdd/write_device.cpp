// The device profile: who made it, and its parameters.
#include <fmt/format.h>

#include <algorithm>

#include "dictionary/data_types.hpp"
#include "eds/value_text.hpp"
#include "xdd/words.hpp"
#include "xdd/writing.hpp"

namespace cgw::xdd {
namespace {

using dictionary::DeviceInformation;
using dictionary::Dictionary;
using dictionary::Variable;

Attributes english() {
    return {{"lang", "en"}};
}

void identity(XmlPrinter& out, const Dictionary& dictionary) {
    const DeviceInformation& device = dictionary.device;
    out.open("co:DeviceIdentity");
    out.leaf("co:vendorName", device.vendor_name);
    out.leaf("co:vendorID", fmt::format("0x{:08X}", device.vendor_number));
    out.leaf("co:productName", device.product_name);
    out.leaf("co:productID", fmt::format("0x{:08X}", device.product_number));
    if (!dictionary.file.description.empty()) {
        out.open("co:productText");
        out.leaf("description", dictionary.file.description, english());
        out.close();
    }
    if (!device.order_code.empty()) {
        out.leaf("co:orderNumber", device.order_code);
    }
    out.leaf("co:version", fmt::format("0x{:08X}", device.revision_number), {{"versionType", "FW"}});
    out.close();
}

void characteristic(XmlPrinter& out, std::string_view name, const std::vector<std::string>& contents) {
    out.open("co:characteristic");
    out.open("co:characteristicName");
    out.leaf("label", name, english());
    out.close();
    for (const std::string& content : contents) {
        out.open("co:characteristicContent");
        out.leaf("label", content, english());
        out.close();
    }
    out.close();
}

void function(XmlPrinter& out, const std::vector<std::string>& comments) {
    out.open("co:DeviceFunction");
    out.open("co:capabilities");
    out.open("co:characteristicsList");
    characteristic(out, protocol_characteristic, {"CANopen"});
    if (!comments.empty()) {
        characteristic(out, comments_characteristic, comments);
    }
    out.close();
    out.close();
    out.close();
}

std::string_view type_element(object::DataType type) {
    const auto* const row = std::find_if(elementary_types.begin(), elementary_types.end(),
                                         [type](const ElementaryType& each) { return each.type == type; });
    return row != elementary_types.end() ? row->element : type_without_width;
}

void value_element(XmlPrinter& out, std::string_view element, const dictionary::Value& value,
                   const dictionary::TypeRow& type) {
    if (const auto text = written(value, type)) {
        out.empty(element, {{"value", *text}});
    }
}

// A range has both limits.
void range(XmlPrinter& out, const Variable& variable, const dictionary::TypeRow& type) {
    if (!variable.low_limit || !variable.high_limit) {
        return;
    }
    out.open("co:allowedValues");
    out.open("co:range");
    out.empty("minValue", {{"value", eds::value_text(*variable.low_limit, type)}});
    out.empty("maxValue", {{"value", eds::value_text(*variable.high_limit, type)}});
    out.close();
    out.close();
}

void parameter(XmlPrinter& out, const dictionary::Object& object, const Variable& variable, bool of_node) {
    const dictionary::TypeRow& type = dictionary::row_of(variable.type);
    const AccessWords& access = access_words.at(static_cast<std::size_t>(variable.access));
    out.open("co:parameter",
             {{"uniqueID", parameter_id(object, variable)}, {"access", std::string(access.parameter)}});
    out.leaf("label", has_sub_objects(object.code) ? variable.name : object.name, english());
    out.empty(type_element(variable.type));
    if (of_node && variable.parameter_value) {
        value_element(out, "co:actualValue", *variable.parameter_value, type);
    }
    if (!variable.no_default) {
        value_element(out, "co:defaultValue", variable.default_value, type);
    }
    range(out, variable, type);
    out.close();
}

}  // namespace

void device_body(XmlPrinter& out, const Dictionary& dictionary, const dictionary::Commissioning* node) {
    out.open("ProfileBody", body_attributes("ProfileBody_Device_CANopen", dictionary.file));
    identity(out, dictionary);
    out.empty("co:DeviceManager");
    function(out, dictionary.comments);
    const bool has_parameters =
        std::any_of(dictionary.objects.begin(), dictionary.objects.end(),
                    [](const dictionary::Object& object) { return !object.variables.empty(); });
    if (has_parameters) {
        out.open("co:ApplicationProcess");
        out.open("co:parameterList");
        for (const dictionary::Object& object : dictionary.objects) {
            for (const Variable& variable : object.variables) {
                parameter(out, object, variable, node != nullptr);
            }
        }
        out.close();
        out.close();
    }
    out.close();
}

}  // namespace cgw::xdd
