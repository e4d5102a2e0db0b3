#include "support/random_dictionary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

namespace cgw::test {
namespace {

using dictionary::TypeKind;
using dictionary::TypeRow;
using dictionary::Value;
using dictionary::Variable;
using object::ObjectCode;

constexpr std::string_view characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:=[]()/+-<>&\"'#$%";

}  // namespace

std::uint64_t RandomDictionary::number(unsigned bits) {
    const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    switch (below(4)) {
        case 0:
            return 0;
        case 1:
            return mask;
        default:
            return random_() & mask;
    }
}

// No blanks at its ends.
std::string RandomDictionary::text(std::uint32_t longest) {
    std::string result;
    for (std::uint32_t length = below(longest); length > 0; --length) {
        result += characters[below(static_cast<std::uint32_t>(characters.size()))];
    }
    if (!result.empty()) {
        result.front() = 'A';
        result.back() = 'z';
    }
    return result;
}

std::string RandomDictionary::date() {
    return fmt::format("{:02}-{:02}-{}", 1 + below(12), 1 + below(28), 1990 + below(60));
}

std::string RandomDictionary::time() {
    return fmt::format("{:02}:{:02}{}", 1 + below(12), below(60), below(2) == 0 ? "AM" : "PM");
}

Value RandomDictionary::value(const TypeRow& type) {
    Value result;
    switch (type.kind) {
        case TypeKind::visible_string:
        case TypeKind::unicode_string:
            result.bytes = "S" + text(300);
            break;
        case TypeKind::octet_string:
        case TypeKind::domain:
            for (std::uint32_t length = 1 + below(20); length > 0; --length) {
                result.bytes += static_cast<char>(below(256));
            }
            break;
        case TypeKind::structure:
            break;
        case TypeKind::real:
            result.number = number(type.bits);
            break;
        case TypeKind::natural:
            result.number = number(type.bits);
            result.node_id_relative = rarely();
            if (result.node_id_relative) {  // which no node makes too large
                constexpr std::uint64_t highest_node = 127;
                result.number =
                    std::min(result.number, (~std::uint64_t{0} >> (64 - type.bits)) - highest_node);
            }
            break;
        default:
            result.number = number(type.bits);
    }
    return result;
}

Variable RandomDictionary::variable(std::uint8_t sub_index, ObjectCode code) {
    const auto types = dictionary::data_types();
    const TypeRow& type = types[below(static_cast<std::uint32_t>(types.size()))];
    const bool has_values = type.kind != TypeKind::structure;
    Variable result;
    result.sub_index = sub_index;
    result.name = text();
    result.type = type.type;
    result.access =
        code == ObjectCode::type_definition ? object::Access::ro : static_cast<object::Access>(below(6));
    result.pdo_mapping = below(2) == 0;
    result.flags = rarely() ? below(4) : 0;
    result.no_default = !has_values || rarely();
    if (!result.no_default) {
        result.default_value = value(type);
    }
    if (has_values && rarely()) {
        result.low_limit = value(type);
    }
    if (has_values && rarely()) {
        result.high_limit = value(type);
    }
    if (has_values && rarely()) {
        result.parameter_value = value(type);
    }
    if (rarely()) {
        result.denotation = text();
        result.upload_file = text();
        result.download_file = text();
    }
    return result;
}

dictionary::Object RandomDictionary::object(std::uint16_t index) {
    constexpr ObjectCode codes[] = {ObjectCode::domain,
                                    ObjectCode::type_definition,
                                    ObjectCode::structure_definition,
                                    ObjectCode::var,
                                    ObjectCode::var,
                                    ObjectCode::array,
                                    ObjectCode::record};
    dictionary::Object result;
    result.index = index;
    result.name = text();
    result.code = codes[below(std::size(codes))];
    if (rarely()) {
        for (std::uint32_t links = below(4); links > 0; --links) {
            result.object_links.push_back(static_cast<std::uint16_t>(below(0x10000)));
        }
    }
    if (!has_sub_objects(result.code)) {
        result.variables.push_back(variable(0, result.code));
        result.variables.front().name = result.name;
        return result;
    }
    result.flags = rarely() ? below(4) : 0;
    result.denotation = rarely() ? text() : "";
    std::set<std::uint8_t> sub_indices;
    for (std::uint32_t count = below(8); count > 0; --count) {
        sub_indices.insert(static_cast<std::uint8_t>(below(often() ? 10 : 256)));
    }
    for (const std::uint8_t sub_index : sub_indices) {
        result.variables.push_back(variable(sub_index, ObjectCode::var));
    }
    return result;
}

std::vector<dictionary::Object> RandomDictionary::objects(std::uint32_t most) {
    std::set<std::uint16_t> indices;
    for (std::uint32_t count = below(most); count > 0; --count) {
        const std::uint32_t range = often() ? 0x1000 + below(0x200) : below(0x10000);
        indices.insert(static_cast<std::uint16_t>(range));
    }
    std::vector<dictionary::Object> result;
    for (const std::uint16_t index : indices) {
        result.push_back(object(index));
    }
    return result;
}

dictionary::Module RandomDictionary::module(std::uint8_t number) {
    dictionary::Module result;
    result.number = number;
    result.product_name = text();
    result.product_version = below(1000);
    result.product_revision = below(1000);
    result.order_code = text();
    for (std::uint32_t count = below(3); count > 0; --count) {
        result.comments.push_back(text());
    }
    // Of the sheet of a kind of device: nothing of one node.
    const auto without_node = [](Variable& variable) {
        variable.parameter_value.reset();
        variable.denotation.clear();
        variable.upload_file.clear();
        variable.download_file.clear();
    };
    result.fixed_objects = objects(4);
    for (dictionary::Object& fixed : result.fixed_objects) {
        fixed.denotation.clear();
        for (Variable& each : fixed.variables) {
            without_node(each);
        }
    }
    for (std::uint32_t count = below(3), index = 0x6000; count > 0; --count, ++index) {
        dictionary::ModuleExtension& extension = result.extensions.emplace_back();
        extension.index = static_cast<std::uint16_t>(index);
        extension.variable = variable(0, ObjectCode::var);
        without_node(extension.variable);
        extension.count = below(3);
        extension.shared_bits = extension.count == 0 ? below(8) : 0;
        extension.extends_objects = below(2) == 0;
    }
    return result;
}

dictionary::Dictionary RandomDictionary::dictionary() {
    dictionary::Dictionary result;
    dictionary::FileInformation& file = result.file;
    file.file_name = text();
    file.file_version = below(256);
    file.file_revision = below(256);
    file.description = text(240);
    file.creation_date = date();
    file.creation_time = time();
    file.created_by = text();
    file.modification_date = date();
    file.modification_time = time();
    file.modified_by = text();
    dictionary::DeviceInformation& device = result.device;
    device.vendor_name = text();
    device.vendor_number = static_cast<std::uint32_t>(number(32));
    device.product_name = text();
    device.product_number = static_cast<std::uint32_t>(number(32));
    device.revision_number = static_cast<std::uint32_t>(number(32));
    device.order_code = text();
    for (const unsigned rate : {10U, 20U, 50U, 125U, 250U, 500U, 800U, 1000U}) {
        if (below(2) == 0) {
            device.bit_rates_kbit.push_back(rate);
        }
    }
    device.simple_boot_up_master = below(2) == 0;
    device.simple_boot_up_slave = below(2) == 0;
    device.granularity = below(65);
    device.dynamic_channels = below(2) == 0;
    device.group_messaging = below(2) == 0;
    device.receive_pdos = below(513);
    device.transmit_pdos = below(513);
    device.lss_supported = below(2) == 0;
    for (std::uint32_t count = below(4); count > 0; --count) {
        result.comments.push_back(text());
    }
    for (std::uint8_t type = 1; type <= 7; ++type) {
        if (below(2) == 0) {
            result.supported_dummies.push_back(type);
        }
    }
    if (rarely()) {
        result.supported_dummies.push_back(0x1B);
    }
    result.objects = objects(20);
    for (std::uint32_t count = rarely() ? below(4) : 0, number = 1; count > 0; --count, ++number) {
        result.modules.push_back(module(static_cast<std::uint8_t>(number)));
    }
    return result;
}

dictionary::Commissioning RandomDictionary::commissioning() {
    dictionary::Commissioning node;
    node.last_eds = text();
    node.node_id = static_cast<std::uint8_t>(1 + below(127));
    node.node_name = text();
    if (often()) {
        node.bit_rate_kbit = below(1001);
    }
    node.net_number = below(128);
    node.network_name = text();
    node.canopen_manager = below(2) == 0;
    node.serial_number = static_cast<std::uint32_t>(number(32));
    for (std::uint32_t count = rarely() ? below(4) : 0; count > 0; --count) {
        node.connected_modules.push_back(static_cast<std::uint16_t>(1 + below(3)));
    }
    return node;
}

}  // namespace cgw::test
