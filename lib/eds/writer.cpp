#include "eds/writer.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "dictionary/ascii.hpp"

namespace cgw::eds {
namespace {

using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;

constexpr std::size_t longest_line = 255;
constexpr std::string_view eds_version = "4.0";
constexpr std::array<unsigned, 8> bit_rate_keys{10, 20, 50, 125, 250, 500, 800, 1000};
constexpr unsigned dummy_types = 7;  // Dummy0001..Dummy0007

struct ObjectList {
    std::string_view name;
    bool (*contains)(std::uint16_t index);
};

bool is_mandatory(std::uint16_t index) {
    return index == 0x1000 || index == 0x1001 || index == 0x1018;
}
bool is_manufacturer(std::uint16_t index) {
    return index >= 0x2000 && index < 0x6000;
}
bool is_optional(std::uint16_t index) {
    return index >= 0x1000 && !is_mandatory(index) && !is_manufacturer(index);
}

constexpr std::array object_lists{
    ObjectList{"MandatoryObjects", is_mandatory},
    ObjectList{"OptionalObjects", is_optional},
    ObjectList{"ManufacturerObjects", is_manufacturer},
};

// Spelling of object::Access, in the order of its values.
constexpr std::array<std::string_view, 6> access_types{"ro", "wo", "rw", "rwr", "rww", "const"};

std::string decimal(std::size_t number) {
    return fmt::format("{}", number);
}
std::string flag(bool value) {
    return value ? "1" : "0";
}

std::string hexadecimal(std::uint32_t number, object::DataType type) {
    const unsigned digits = 2U * object::size_of(type);
    const std::uint32_t kept = digits < 8 ? number & ((1U << (4 * digits)) - 1) : number;
    return fmt::format("0x{:0{}X}", kept, digits);
}

std::string default_text(const Variable& variable, const Commissioning* node) {
    const dictionary::Value& value = variable.default_value;
    if (node != nullptr) {
        return hexadecimal(value.resolve(node->node_id), variable.type);
    }
    return value.node_id_relative ? fmt::format("$NODEID+0x{:X}", value.number)
                                  : hexadecimal(value.number, variable.type);
}

void text_entry(Section& section, std::string key, std::string_view text) {
    std::string value = dictionary::to_ascii(text);
    std::replace(value.begin(), value.end(), ';', ',');
    value = dictionary::shortened(base::trimmed(value, " "), longest_line - key.size() - 1);
    section.entry(std::move(key), std::move(value));
}

void file_information(Document& document, const dictionary::FileInformation& file,
                      const Commissioning* node) {
    Section& section = document.section("FileInfo");
    text_entry(section, "FileName", file.file_name);
    section.entry("FileVersion", decimal(file.file_version));
    section.entry("FileRevision", decimal(file.file_revision));
    section.entry("EDSVersion", std::string(eds_version));
    text_entry(section, "Description", file.description);
    section.entry("CreationTime", file.creation_time);
    section.entry("CreationDate", file.creation_date);
    text_entry(section, "CreatedBy", file.created_by);
    section.entry("ModificationTime", file.modification_time);
    section.entry("ModificationDate", file.modification_date);
    text_entry(section, "ModifiedBy", file.modified_by);
    if (node != nullptr) {
        text_entry(section, "LastEDS", node->last_eds);
    }
}

void commissioning(Document& document, const Commissioning& node) {
    Section& section = document.section("DeviceComissioning");
    section.entry("NodeID", decimal(node.node_id));
    text_entry(section, "NodeName", node.node_name);
    if (node.bit_rate_kbit) {
        section.entry("Baudrate", decimal(*node.bit_rate_kbit));
    }
    section.entry("NetNumber", decimal(node.net_number));
    text_entry(section, "NetworkName", node.network_name);
    section.entry("CANopenManager", flag(node.canopen_manager));
    section.entry("LSS_SerialNumber", hexadecimal(node.serial_number, object::DataType::unsigned32));
}

void device_information(Document& document, const dictionary::DeviceInformation& device) {
    constexpr auto u32 = object::DataType::unsigned32;
    Section& section = document.section("DeviceInfo");
    text_entry(section, "VendorName", device.vendor_name);
    section.entry("VendorNumber", hexadecimal(device.vendor_number, u32));
    text_entry(section, "ProductName", device.product_name);
    section.entry("ProductNumber", hexadecimal(device.product_number, u32));
    section.entry("RevisionNumber", hexadecimal(device.revision_number, u32));
    text_entry(section, "OrderCode", device.order_code);
    for (const unsigned rate : bit_rate_keys) {
        const auto& supported = device.bit_rates_kbit;
        const bool known = std::find(supported.begin(), supported.end(), rate) != supported.end();
        section.entry(fmt::format("BaudRate_{}", rate), flag(known));
    }
    section.entry("SimpleBootUpMaster", flag(device.simple_boot_up_master));
    section.entry("SimpleBootUpSlave", flag(device.simple_boot_up_slave));
    section.entry("Granularity", decimal(device.granularity));
    section.entry("DynamicChannelsSupported", "0");
    section.entry("GroupMessaging", "0");
    section.entry("NrOfRXPDO", decimal(device.receive_pdos));
    section.entry("NrOfTXPDO", decimal(device.transmit_pdos));
    section.entry("LSS_Supported", flag(device.lss_supported));
}

void dummy_usage(Document& document, const std::vector<std::uint8_t>& supported) {
    Section& section = document.section("DummyUsage");
    for (unsigned type = 1; type <= dummy_types; ++type) {
        const bool used = std::find(supported.begin(), supported.end(), type) != supported.end();
        section.entry(fmt::format("Dummy{:04}", type), flag(used));
    }
}

void comments(Document& document, const std::vector<std::string>& lines) {
    Section& section = document.section("Comments");
    section.entry("Lines", decimal(lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        text_entry(section, fmt::format("Line{}", i + 1), lines[i]);
    }
}

std::string object_type(object::ObjectCode code) {
    return fmt::format("0x{:X}", static_cast<unsigned>(code));
}

void variable_entries(Section& section, const Variable& variable, const Commissioning* node) {
    section.entry("ObjectType", object_type(object::ObjectCode::var));
    section.entry("DataType", fmt::format("0x{:04X}", static_cast<unsigned>(variable.type)));
    section.entry("AccessType", std::string(access_types.at(static_cast<std::size_t>(variable.access))));
    section.entry("DefaultValue", default_text(variable, node));
    if (node != nullptr && !variable.run_time) {
        section.entry("ParameterValue", default_text(variable, node));
    }
    section.entry("PDOMapping", flag(variable.pdo_mapping));
    if (variable.low_limit) {
        section.entry("LowLimit", hexadecimal(*variable.low_limit, variable.type));
    }
    if (variable.high_limit) {
        section.entry("HighLimit", hexadecimal(*variable.high_limit, variable.type));
    }
}

void object_sections(Document& document, const Object& object, const Commissioning* node) {
    Section& section = document.section(fmt::format("{:04X}", object.index));
    text_entry(section, "ParameterName", object.name);
    if (object.code == object::ObjectCode::var) {
        variable_entries(section, object.variables.front(), node);
        return;
    }
    section.entry("ObjectType", object_type(object.code));
    section.entry("SubNumber", decimal(object.variables.size()));
    for (const Variable& variable : object.variables) {
        Section& sub = document.section(fmt::format("{:04X}sub{:X}", object.index, variable.sub_index));
        text_entry(sub, "ParameterName", variable.name);
        variable_entries(sub, variable, node);
    }
}

void object_list(Document& document, const ObjectList& list, const std::vector<Object>& all,
                 const Commissioning* node) {
    std::vector<const Object*> listed;
    for (const Object& object : all) {
        if (list.contains(object.index)) {
            listed.push_back(&object);
        }
    }
    Section& section = document.section(std::string(list.name));
    section.entry("SupportedObjects", decimal(listed.size()));
    for (std::size_t i = 0; i < listed.size(); ++i) {
        section.entry(decimal(i + 1), fmt::format("0x{:04X}", listed[i]->index));
    }
    for (const Object* const object : listed) {
        object_sections(document, *object, node);
    }
}

// `node` is nullptr for a data sheet.
Document make_document(const Dictionary& dictionary, const Commissioning* node) {
    Document document;
    file_information(document, dictionary.file, node);
    device_information(document, dictionary.device);
    if (node != nullptr) {
        commissioning(document, *node);
    }
    dummy_usage(document, dictionary.supported_dummies);
    comments(document, dictionary.comments);
    for (const ObjectList& list : object_lists) {
        object_list(document, list, dictionary.objects, node);
    }
    return document;
}

}  // namespace

Document to_document(const Dictionary& dictionary) {
    return make_document(dictionary, nullptr);
}

Document to_document(const Dictionary& dictionary, const Commissioning& node) {
    return make_document(dictionary, &node);
}

std::string write(const Dictionary& dictionary) {
    return print(to_document(dictionary));
}

std::string write(const Dictionary& dictionary, const Commissioning& node) {
    return print(to_document(dictionary, node));
}

}  // namespace cgw::eds
