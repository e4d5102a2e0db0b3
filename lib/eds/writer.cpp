#include "eds/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "eds/words.hpp"
#include "eds/writing.hpp"

namespace cgw::eds {
namespace {

using dictionary::Commissioning;
using dictionary::Dictionary;
using dictionary::Object;

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
bool is_optional(std::uint16_t index) {  // data types below 1000h as well, for which there is no list
    return !is_mandatory(index) && !is_manufacturer(index);
}

constexpr std::array object_lists{
    ObjectList{"MandatoryObjects", is_mandatory},
    ObjectList{"OptionalObjects", is_optional},
    ObjectList{"ManufacturerObjects", is_manufacturer},
};

std::string u32_text(std::uint32_t number) {
    return fmt::format("0x{:08X}", number);
}

void file_information(Printer& out, const dictionary::FileInformation& file, const Commissioning* node) {
    out.section("FileInfo");
    out.text_entry("FileName", file.file_name);
    out.number_entry("FileVersion", file.file_version);
    out.number_entry("FileRevision", file.file_revision);
    out.text_entry("EDSVersion", file.eds_version);
    out.text_entry("Description", file.description);
    out.text_entry("CreationTime", file.creation_time);
    out.text_entry("CreationDate", file.creation_date);
    out.text_entry("CreatedBy", file.created_by);
    out.text_entry("ModificationTime", file.modification_time);
    out.text_entry("ModificationDate", file.modification_date);
    out.text_entry("ModifiedBy", file.modified_by);
    if (node != nullptr) {
        out.text_entry("LastEDS", node->last_eds);
    }
}

void commissioning(Printer& out, const Commissioning& node) {
    out.section("DeviceComissioning");
    out.number_entry("NodeID", node.node_id);
    out.text_entry("NodeName", node.node_name);
    if (node.bit_rate_kbit) {
        out.number_entry("Baudrate", *node.bit_rate_kbit);
    }
    out.number_entry("NetNumber", node.net_number);
    out.text_entry("NetworkName", node.network_name);
    out.flag_entry("CANopenManager", node.canopen_manager);
    out.entry("LSS_SerialNumber", u32_text(node.serial_number));
}

void device_information(Printer& out, const dictionary::DeviceInformation& device) {
    out.section("DeviceInfo");
    out.text_entry("VendorName", device.vendor_name);
    out.entry("VendorNumber", u32_text(device.vendor_number));
    out.text_entry("ProductName", device.product_name);
    out.entry("ProductNumber", u32_text(device.product_number));
    out.entry("RevisionNumber", u32_text(device.revision_number));
    out.text_entry("OrderCode", device.order_code);
    for (const unsigned rate : bit_rate_keys) {
        const auto& supported = device.bit_rates_kbit;
        const bool known = std::find(supported.begin(), supported.end(), rate) != supported.end();
        out.flag_entry(fmt::format("BaudRate_{}", rate), known);
    }
    out.flag_entry("SimpleBootUpMaster", device.simple_boot_up_master);
    out.flag_entry("SimpleBootUpSlave", device.simple_boot_up_slave);
    out.number_entry("Granularity", device.granularity);
    out.flag_entry("DynamicChannelsSupported", device.dynamic_channels);
    out.flag_entry("GroupMessaging", device.group_messaging);
    out.number_entry("NrOfRXPDO", device.receive_pdos);
    out.number_entry("NrOfTXPDO", device.transmit_pdos);
    out.flag_entry("LSS_Supported", device.lss_supported);
    if (device.compact_pdo != 0) {
        out.entry("CompactPDO", u32_text(device.compact_pdo));
    }
}

void dummy_usage(Printer& out, const std::vector<std::uint8_t>& supported) {
    out.section("DummyUsage");
    for (unsigned type = 1; type <= dummy_types; ++type) {
        const bool used = std::find(supported.begin(), supported.end(), type) != supported.end();
        out.flag_entry(fmt::format("Dummy{:04}", type), used);
    }
    for (const std::uint8_t type : supported) {
        if (type == 0 || type > dummy_types) {
            out.flag_entry(fmt::format("Dummy{:04X}", type), true);
        }
    }
}

void object_list(Printer& out, const ObjectList& list, const std::vector<Object>& all, FileKind kind) {
    std::vector<std::uint16_t> indices;
    for (const Object& object : all) {
        if (list.contains(object.index)) {
            indices.push_back(object.index);
        }
    }
    out.section(list.name);
    index_entries(out, "SupportedObjects", indices);
    for (const Object& object : all) {
        if (list.contains(object.index)) {
            object_sections(out, object, kind);
        }
    }
}

void connected_modules(Printer& out, const std::vector<std::uint16_t>& numbers) {
    if (numbers.empty()) {
        return;
    }
    out.section("ConnectedModules");
    out.number_entry("NrOfEntries", numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out.number_entry(fmt::format("{}", i + 1), numbers[i]);
    }
}

// `node` is nullptr for a data sheet.
std::string write_all(const Dictionary& dictionary, const Commissioning* node) {
    const FileKind kind = node != nullptr ? FileKind::configuration : FileKind::data_sheet;
    Printer out;
    file_information(out, dictionary.file, node);
    device_information(out, dictionary.device);
    if (node != nullptr) {
        commissioning(out, *node);
    }
    dummy_usage(out, dictionary.supported_dummies);
    out.section("Comments");
    comment_entries(out, dictionary.comments);
    for (const ObjectList& list : object_lists) {
        object_list(out, list, dictionary.objects, kind);
    }
    modules(out, dictionary.modules);
    if (node != nullptr) {
        connected_modules(out, node->connected_modules);
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
