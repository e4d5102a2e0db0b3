#include "eds/writer.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "dictionary/ascii.hpp"
#include "dictionary/data_types.hpp"
#include "eds/words.hpp"

namespace cgw::eds {
namespace {

using dictionary::Commissioning;
using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;

constexpr std::size_t longest_line = 255;
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

std::string decimal(std::size_t number) {
    return fmt::format("{}", number);
}
std::string flag(bool value) {
    return value ? "1" : "0";
}

std::string hexadecimal(std::uint64_t number, object::DataType type) {
    const unsigned digits = (dictionary::row_of(type).bits + 7) / 8 * 2;
    const std::uint64_t kept = digits < 16 ? number & ((std::uint64_t{1} << (4 * digits)) - 1) : number;
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

// The text as it grows: CRLF line ends, a blank line between sections.
class Printer {
  public:
    void section(std::string_view name) {
        text_ += text_.empty() ? "[" : "\r\n[";
        text_.append(name).append("]\r\n");
    }
    void entry(std::string_view key, std::string_view value) {
        text_.append(key).append("=").append(value).append("\r\n");
    }
    void text_entry(std::string_view key, std::string_view text) {
        std::string value = dictionary::to_ascii(text);
        std::replace(value.begin(), value.end(), ';', ',');
        entry(key, dictionary::shortened(base::trimmed(value, " "), longest_line - key.size() - 1));
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

void file_information(Printer& out, const dictionary::FileInformation& file, const Commissioning* node) {
    out.section("FileInfo");
    out.text_entry("FileName", file.file_name);
    out.entry("FileVersion", decimal(file.file_version));
    out.entry("FileRevision", decimal(file.file_revision));
    out.entry("EDSVersion", file.eds_version);
    out.text_entry("Description", file.description);
    out.entry("CreationTime", file.creation_time);
    out.entry("CreationDate", file.creation_date);
    out.text_entry("CreatedBy", file.created_by);
    out.entry("ModificationTime", file.modification_time);
    out.entry("ModificationDate", file.modification_date);
    out.text_entry("ModifiedBy", file.modified_by);
    if (node != nullptr) {
        out.text_entry("LastEDS", node->last_eds);
    }
}

void commissioning(Printer& out, const Commissioning& node) {
    out.section("DeviceComissioning");
    out.entry("NodeID", decimal(node.node_id));
    out.text_entry("NodeName", node.node_name);
    if (node.bit_rate_kbit) {
        out.entry("Baudrate", decimal(*node.bit_rate_kbit));
    }
    out.entry("NetNumber", decimal(node.net_number));
    out.text_entry("NetworkName", node.network_name);
    out.entry("CANopenManager", flag(node.canopen_manager));
    out.entry("LSS_SerialNumber", hexadecimal(node.serial_number, object::DataType::unsigned32));
}

void device_information(Printer& out, const dictionary::DeviceInformation& device) {
    constexpr auto u32 = object::DataType::unsigned32;
    out.section("DeviceInfo");
    out.text_entry("VendorName", device.vendor_name);
    out.entry("VendorNumber", hexadecimal(device.vendor_number, u32));
    out.text_entry("ProductName", device.product_name);
    out.entry("ProductNumber", hexadecimal(device.product_number, u32));
    out.entry("RevisionNumber", hexadecimal(device.revision_number, u32));
    out.text_entry("OrderCode", device.order_code);
    for (const unsigned rate : bit_rate_keys) {
        const auto& supported = device.bit_rates_kbit;
        const bool known = std::find(supported.begin(), supported.end(), rate) != supported.end();
        out.entry(fmt::format("BaudRate_{}", rate), flag(known));
    }
    out.entry("SimpleBootUpMaster", flag(device.simple_boot_up_master));
    out.entry("SimpleBootUpSlave", flag(device.simple_boot_up_slave));
    out.entry("Granularity", decimal(device.granularity));
    out.entry("DynamicChannelsSupported", flag(device.dynamic_channels));
    out.entry("GroupMessaging", flag(device.group_messaging));
    out.entry("NrOfRXPDO", decimal(device.receive_pdos));
    out.entry("NrOfTXPDO", decimal(device.transmit_pdos));
    out.entry("LSS_Supported", flag(device.lss_supported));
}

void dummy_usage(Printer& out, const std::vector<std::uint8_t>& supported) {
    out.section("DummyUsage");
    for (unsigned type = 1; type <= dummy_types; ++type) {
        const bool used = std::find(supported.begin(), supported.end(), type) != supported.end();
        out.entry(fmt::format("Dummy{:04}", type), flag(used));
    }
}

void comments(Printer& out, const std::vector<std::string>& lines) {
    out.section("Comments");
    out.entry("Lines", decimal(lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        out.text_entry(fmt::format("Line{}", i + 1), lines[i]);
    }
}

std::string object_type(object::ObjectCode code) {
    return fmt::format("0x{:X}", static_cast<unsigned>(code));
}

void variable_entries(Printer& out, const Variable& variable, const Commissioning* node) {
    out.entry("ObjectType", object_type(object::ObjectCode::var));
    out.entry("DataType", fmt::format("0x{:04X}", static_cast<unsigned>(variable.type)));
    out.entry("AccessType", std::string(access_types.at(static_cast<std::size_t>(variable.access))));
    out.entry("DefaultValue", default_text(variable, node));
    if (node != nullptr && !variable.run_time) {
        out.entry("ParameterValue", default_text(variable, node));
    }
    out.entry("PDOMapping", flag(variable.pdo_mapping));
    if (variable.low_limit) {
        out.entry("LowLimit", hexadecimal(variable.low_limit->number, variable.type));
    }
    if (variable.high_limit) {
        out.entry("HighLimit", hexadecimal(variable.high_limit->number, variable.type));
    }
}

void object_sections(Printer& out, const Object& object, const Commissioning* node) {
    out.section(fmt::format("{:04X}", object.index));
    out.text_entry("ParameterName", object.name);
    if (object.code == object::ObjectCode::var) {
        variable_entries(out, object.variables.front(), node);
        return;
    }
    out.entry("ObjectType", object_type(object.code));
    out.entry("SubNumber", decimal(object.variables.size()));
    for (const Variable& variable : object.variables) {
        out.section(fmt::format("{:04X}sub{:X}", object.index, variable.sub_index));
        out.text_entry("ParameterName", variable.name);
        variable_entries(out, variable, node);
    }
}

void object_list(Printer& out, const ObjectList& list, const std::vector<Object>& all,
                 const Commissioning* node) {
    std::vector<const Object*> listed;
    for (const Object& object : all) {
        if (list.contains(object.index)) {
            listed.push_back(&object);
        }
    }
    out.section(list.name);
    out.entry("SupportedObjects", decimal(listed.size()));
    for (std::size_t i = 0; i < listed.size(); ++i) {
        out.entry(decimal(i + 1), fmt::format("0x{:04X}", listed[i]->index));
    }
    for (const Object* const object : listed) {
        object_sections(out, *object, node);
    }
}

// `node` is nullptr for a data sheet.
std::string write_all(const Dictionary& dictionary, const Commissioning* node) {
    Printer out;
    file_information(out, dictionary.file, node);
    device_information(out, dictionary.device);
    if (node != nullptr) {
        commissioning(out, *node);
    }
    dummy_usage(out, dictionary.supported_dummies);
    comments(out, dictionary.comments);
    for (const ObjectList& list : object_lists) {
        object_list(out, list, dictionary.objects, node);
    }
    return out.take();
}

}  // namespace

std::string write(const Dictionary& dictionary) {
    return write_all(dictionary, nullptr);
}

std::string write(const Dictionary& dictionary, const Commissioning& node) {
    return write_all(dictionary, &node);
}

}  // namespace cgw::eds
