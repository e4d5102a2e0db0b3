// The communication network profile: the objects, and how the device takes part in the network.
#include <fmt/format.h>

#include <algorithm>

#include "dictionary/data_types.hpp"
#include "eds/words.hpp"
#include "xdd/words.hpp"
#include "xdd/writing.hpp"

namespace cgw::xdd {
namespace {

using dictionary::Commissioning;
using dictionary::DeviceInformation;
using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;
using object::ObjectCode;

std::string flag(bool value) {
    return value ? "true" : "false";
}

std::string code_text(ObjectCode code) {
    return fmt::format("{}", static_cast<unsigned>(code));
}

void add_flags(Attributes& attributes, std::uint32_t flags) {
    if (flags != 0) {
        attributes.push_back({"objFlags", fmt::format("{:0{}X}", flags, flags <= 0xFFFF ? 4 : 8)});
    }
}

void add_value(Attributes& attributes, std::string_view name, const std::optional<dictionary::Value>& value,
               const dictionary::TypeRow& type) {
    if (const auto text = value ? written(*value, type) : std::nullopt) {
        attributes.push_back({name, *text});
    }
}

void add_variable(Attributes& attributes, const Object& object, const Variable& variable, bool of_node) {
    const dictionary::TypeRow& type = dictionary::row_of(variable.type);
    const auto access = static_cast<std::size_t>(variable.access);
    attributes.push_back({"dataType", fmt::format("{:04X}", static_cast<unsigned>(variable.type))});
    add_value(attributes, "lowLimit", variable.low_limit, type);
    add_value(attributes, "highLimit", variable.high_limit, type);
    if (object.code != ObjectCode::type_definition) {
        attributes.push_back({"accessType", std::string(access_words.at(access).object)});
    }
    if (!variable.no_default) {
        add_value(attributes, "defaultValue", variable.default_value, type);
    }
    if (of_node) {
        add_value(attributes, "actualValue", variable.parameter_value, type);
        add(attributes, "denotation", variable.denotation);
    }
    attributes.push_back({"PDOmapping", std::string(variable.pdo_mapping ? mapping_words.at(access) : "no")});
    add_flags(attributes, variable.flags);
    attributes.push_back({"uniqueIDRef", parameter_id(object, variable)});
}

void object_element(XmlPrinter& out, const Object& object, bool of_node) {
    Attributes attributes{{"index", fmt::format("{:04X}", object.index)},
                          {"name", object.name},
                          {"objectType", code_text(object.code)}};
    if (!has_sub_objects(object.code)) {
        for (const Variable& variable : object.variables) {
            add_variable(attributes, object, variable, of_node);
        }
        out.empty("CANopenObject", attributes);
        return;
    }
    if (of_node) {
        add(attributes, "denotation", object.denotation);
    }
    add_flags(attributes, object.flags);
    attributes.push_back({"subNumber", fmt::format("{}", object.variables.size())});
    if (object.variables.empty()) {
        out.empty("CANopenObject", attributes);
        return;
    }
    out.open("CANopenObject", attributes);
    for (const Variable& variable : object.variables) {
        Attributes sub{{"subIndex", fmt::format("{:02X}", variable.sub_index)},
                       {"name", variable.name},
                       {"objectType", code_text(ObjectCode::var)}};
        add_variable(sub, object, variable, of_node);
        out.empty("CANopenSubObject", sub);
    }
    out.close();
}

void dummies(XmlPrinter& out, const std::vector<std::uint8_t>& supported) {
    out.open("dummyUsage");
    for (unsigned type = 1; type <= dummy_types; ++type) {
        const bool used = std::find(supported.begin(), supported.end(), type) != supported.end();
        out.empty("dummy", {{"entry", fmt::format("Dummy{:04}={}", type, used ? 1 : 0)}});
    }
    out.close();
}

void bit_rates(XmlPrinter& out, const std::vector<unsigned>& rates) {
    out.open("TransportLayers");
    out.open("PhysicalLayer");
    out.open("baudRate");
    for (const unsigned rate : rates) {
        out.empty("supportedBaudRate", {{"value", fmt::format("{}{}", rate, bit_rate_unit)}});
    }
    out.close();
    out.close();
    out.close();
}

void management(XmlPrinter& out, const DeviceInformation& device, const Commissioning* node) {
    out.open("NetworkManagement");
    out.empty("CANopenGeneralFeatures", {{"groupMessaging", flag(device.group_messaging)},
                                         {"dynamicChannels", device.dynamic_channels ? "1" : "0"},
                                         {"granularity", fmt::format("{}", device.granularity)},
                                         {"nrOfRxPDO", fmt::format("{}", device.receive_pdos)},
                                         {"nrOfTxPDO", fmt::format("{}", device.transmit_pdos)},
                                         {"bootUpSlave", flag(device.simple_boot_up_slave)},
                                         {"layerSettingServiceSlave", flag(device.lss_supported)}});
    out.empty("CANopenMasterFeatures", {{"bootUpMaster", flag(device.simple_boot_up_master)}});
    if (node != nullptr) {
        out.empty("deviceCommissioning",
                  {{"NodeID", fmt::format("{}", node->node_id)},
                   {"nodeName", node->node_name},
                   {"actualBaudRate", node->bit_rate_kbit ? fmt::format("{}", *node->bit_rate_kbit) : ""},
                   {"networkNumber", fmt::format("{}", node->net_number)},
                   {"networkName", node->network_name},
                   {"CANopenManager", flag(node->canopen_manager)}});
    }
    out.close();
}

bool is_mandatory(std::uint16_t index) {
    return index == 0x1000 || index == 0x1001 || index == 0x1018;
}
bool is_manufacturer(std::uint16_t index) {
    return index >= 0x2000 && index < 0x6000;
}

std::string count(const std::vector<Object>& objects, bool (*counts)(std::uint16_t index)) {
    return fmt::format("{}", std::count_if(objects.begin(), objects.end(),
                                           [counts](const Object& object) { return counts(object.index); }));
}

}  // namespace

void network_body(XmlPrinter& out, const Dictionary& dictionary, const Commissioning* node) {
    out.open("ProfileBody", body_attributes("ProfileBody_CommunicationNetwork_CANopen", dictionary.file));
    out.open("ApplicationLayers");
    out.open("co:CANopenObjectList",
             {{"mandatoryObjects", count(dictionary.objects, is_mandatory)},
              {"optionalObjects",
               count(dictionary.objects,
                     [](std::uint16_t index) { return !is_mandatory(index) && !is_manufacturer(index); })},
              {"manufacturerObjects", count(dictionary.objects, is_manufacturer)}});
    for (const Object& object : dictionary.objects) {
        object_element(out, object, node != nullptr);
    }
    out.close();
    dummies(out, dictionary.supported_dummies);
    out.close();
    bit_rates(out, dictionary.device.bit_rates_kbit);
    management(out, dictionary.device, node);
    out.close();
}

}  // namespace cgw::xdd
