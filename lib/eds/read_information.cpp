// What a file says about itself, its device and its node.
#include <algorithm>
#include <array>
#include <charconv>

#include "base/ascii.hpp"
#include "eds/reading.hpp"
#include "eds/words.hpp"

namespace cgw::eds {
namespace {

enum class FileKey : std::uint8_t {
    file_name,
    file_version,
    file_revision,
    last_eds,
    eds_version,
    description,
    creation_time,
    creation_date,
    created_by,
    modification_time,
    modification_date,
    modified_by,
};

constexpr std::array file_keys{
    row("FileName", FileKey::file_name),
    row("FileVersion", FileKey::file_version),
    row("FileRevision", FileKey::file_revision),
    row("LastEDS", FileKey::last_eds),
    row("EDSVersion", FileKey::eds_version),
    row("Description", FileKey::description),
    row("CreationTime", FileKey::creation_time),
    row("CreationDate", FileKey::creation_date),
    row("CreatedBy", FileKey::created_by),
    row("ModificationTime", FileKey::modification_time),
    row("ModificationDate", FileKey::modification_date),
    row("ModifiedBy", FileKey::modified_by),
};

enum class DeviceKey : std::uint8_t {
    vendor_name,
    vendor_number,
    product_name,
    product_number,
    revision_number,
    order_code,
    simple_boot_up_master,
    simple_boot_up_slave,
    granularity,
    dynamic_channels,
    group_messaging,
    receive_pdos,
    transmit_pdos,
    lss_supported,
    compact_pdo,
};

constexpr std::array device_keys{
    row("VendorName", DeviceKey::vendor_name),
    row("VendorNumber", DeviceKey::vendor_number),
    row("ProductName", DeviceKey::product_name),
    row("ProductNumber", DeviceKey::product_number),
    row("RevisionNumber", DeviceKey::revision_number),
    row("OrderCode", DeviceKey::order_code),
    row("SimpleBootUpMaster", DeviceKey::simple_boot_up_master),
    row("SimpleBootUpSlave", DeviceKey::simple_boot_up_slave),
    row(misspelt_device_keys[0].written, DeviceKey::simple_boot_up_master, true),
    row(misspelt_device_keys[1].written, DeviceKey::simple_boot_up_slave, true),
    row("Granularity", DeviceKey::granularity),
    row("DynamicChannelsSupported", DeviceKey::dynamic_channels),
    row("GroupMessaging", DeviceKey::group_messaging),
    row("NrOfRXPDO", DeviceKey::receive_pdos),
    row("NrOfTXPDO", DeviceKey::transmit_pdos),
    row("LSS_Supported", DeviceKey::lss_supported),
    row("CompactPDO", DeviceKey::compact_pdo),
};

enum class NodeKey : std::uint8_t {
    node_id,
    node_name,
    bit_rate,
    net_number,
    network_name,
    canopen_manager,
    serial_number,
};

constexpr std::array node_keys{
    row("NodeID", NodeKey::node_id),
    row("NodeName", NodeKey::node_name),
    row("Baudrate", NodeKey::bit_rate),
    row("NetNumber", NodeKey::net_number),
    row("NetworkName", NodeKey::network_name),
    row("CANopenManager", NodeKey::canopen_manager),
    row("LSS_SerialNumber", NodeKey::serial_number),
};

// The number behind `prefix`, whatever the case; nothing when the key is another.
std::optional<unsigned> number_behind(std::string_view key, std::string_view prefix, int radix) {
    unsigned number = 0;
    if (!base::equal_ignoring_case(key.substr(0, prefix.size()), prefix)) {
        return std::nullopt;
    }
    key.remove_prefix(prefix.size());
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number, radix);
    return error == std::errc{} && end == key.data() + key.size() ? std::optional(number) : std::nullopt;
}

void read_bit_rates(Reading& reading, const Section& section, std::vector<unsigned>& rates) {
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (reading.document.lines()[line].kind != LineKind::entry) {
            continue;
        }
        const auto rate = number_behind(reading.document.key(line), "BaudRate_", 10);
        const bool known =
            rate && std::find(bit_rate_keys.begin(), bit_rate_keys.end(), *rate) != bit_rate_keys.end();
        if (known && std::find(rates.begin(), rates.end(), *rate) == rates.end() &&
            reading.number(line, 1) == 1U) {
            rates.push_back(*rate);
        }
    }
    std::sort(rates.begin(), rates.end());
}

}  // namespace

void read_file_information(Reading& reading, dictionary::FileInformation& file) {
    file = {};
    file.eds_version.clear();
    const auto section = reading.sections.find(SectionKind::file_info);
    if (!section) {
        return;
    }
    const KeyLines lines = reading.key_lines(reading.section(*section), file_keys);
    file.file_name = reading.text(lines[FileKey::file_name]);
    reading.assign(lines[FileKey::file_version], highest_u8, file.file_version);
    reading.assign(lines[FileKey::file_revision], highest_u8, file.file_revision);
    file.eds_version = reading.text(lines[FileKey::eds_version]);
    file.description = reading.text(lines[FileKey::description]);
    file.creation_time = reading.text(lines[FileKey::creation_time]);
    file.creation_date = reading.text(lines[FileKey::creation_date]);
    file.created_by = reading.text(lines[FileKey::created_by]);
    file.modification_time = reading.text(lines[FileKey::modification_time]);
    file.modification_date = reading.text(lines[FileKey::modification_date]);
    file.modified_by = reading.text(lines[FileKey::modified_by]);
}

void read_device_information(Reading& reading, dictionary::DeviceInformation& device) {
    const auto number = reading.sections.find(SectionKind::device_info);
    if (!number) {
        return;
    }
    const Section& section = reading.section(*number);
    const KeyLines lines = reading.key_lines(section, device_keys);
    device.vendor_name = reading.text(lines[DeviceKey::vendor_name]);
    reading.assign(lines[DeviceKey::vendor_number], highest_u32, device.vendor_number);
    device.product_name = reading.text(lines[DeviceKey::product_name]);
    reading.assign(lines[DeviceKey::product_number], highest_u32, device.product_number);
    reading.assign(lines[DeviceKey::revision_number], highest_u32, device.revision_number);
    device.order_code = reading.text(lines[DeviceKey::order_code]);
    read_bit_rates(reading, section, device.bit_rates_kbit);
    reading.assign_flag(lines[DeviceKey::simple_boot_up_master], device.simple_boot_up_master);
    reading.assign_flag(lines[DeviceKey::simple_boot_up_slave], device.simple_boot_up_slave);
    reading.assign(lines[DeviceKey::granularity], highest_u8, device.granularity);
    reading.assign_flag(lines[DeviceKey::dynamic_channels], device.dynamic_channels);
    reading.assign_flag(lines[DeviceKey::group_messaging], device.group_messaging);
    reading.assign(lines[DeviceKey::receive_pdos], highest_u16, device.receive_pdos);
    reading.assign(lines[DeviceKey::transmit_pdos], highest_u16, device.transmit_pdos);
    reading.assign_flag(lines[DeviceKey::lss_supported], device.lss_supported);
    reading.assign(lines[DeviceKey::compact_pdo], highest_u32, device.compact_pdo);
}

void read_dummy_usage(Reading& reading, std::vector<std::uint8_t>& dummies) {
    const auto number = reading.sections.find(SectionKind::dummy_usage);
    if (!number) {
        return;
    }
    const Section& section = reading.section(*number);
    std::array<std::optional<bool>, highest_u8 + 1> used{};  // the first entry counts
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (reading.document.lines()[line].kind == LineKind::entry) {
            const auto type = number_behind(reading.document.key(line), "Dummy", 16);
            if (type && *type <= highest_u8 && !used[*type]) {
                used[*type] = reading.number(line, 1) == 1U;
            }
        }
    }
    for (std::size_t type = 0; type < used.size(); ++type) {
        if (used[type].value_or(false)) {
            dummies.push_back(static_cast<std::uint8_t>(type));
        }
    }
}

void read_comments(Reading& reading, std::uint32_t number, std::vector<std::string>& comments) {
    const Section& section = reading.section(number);
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (reading.document.lines()[line].kind == LineKind::entry &&
            number_behind(reading.document.key(line), "Line", 10)) {
            comments.push_back(reading.text(line));
        }
    }
}

std::optional<dictionary::Commissioning> read_commissioning(Reading& reading) {
    const auto section = reading.sections.find(SectionKind::commissioning);
    if (!section) {
        return std::nullopt;
    }
    dictionary::Commissioning node;
    const KeyLines lines = reading.key_lines(reading.section(*section), node_keys);
    reading.assign(lines[NodeKey::node_id], highest_u8, node.node_id);
    node.node_name = reading.text(lines[NodeKey::node_name]);
    if (const auto rate = reading.number(lines[NodeKey::bit_rate], highest_u16)) {
        node.bit_rate_kbit = static_cast<std::uint32_t>(*rate);
    }
    reading.assign(lines[NodeKey::net_number], highest_u32, node.net_number);
    node.network_name = reading.text(lines[NodeKey::network_name]);
    reading.assign_flag(lines[NodeKey::canopen_manager], node.canopen_manager);
    reading.assign(lines[NodeKey::serial_number], highest_u32, node.serial_number);
    if (const auto file = reading.sections.find(SectionKind::file_info)) {
        const auto last_eds = reading.document.find(reading.section(*file), "LastEDS");
        node.last_eds = reading.text(last_eds.value_or(0));
    }
    if (const auto connected = reading.sections.find(SectionKind::connected_modules)) {
        reading.numbered(reading.section(*connected), [&](std::uint32_t, std::uint32_t line) {
            if (const auto module = reading.number(line, highest_u16)) {
                node.connected_modules.push_back(static_cast<std::uint16_t>(*module));
            }
        });
    }
    return node;
}

}  // namespace cgw::eds
