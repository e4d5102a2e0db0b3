// What a file says about itself, its device, the network and its node.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/ascii.hpp"
#include "diagnostic/rules/xdd.hpp"
#include "eds/words.hpp"
#include "xdd/dates.hpp"
#include "xdd/reading.hpp"
#include "xdd/words.hpp"

namespace cgw::xdd {
namespace {

using dictionary::DeviceInformation;
using dictionary::Dictionary;
namespace rules = diagnostic::rules;

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t digits_of_u32 = 8;
constexpr std::uint16_t identity_object = 0x1018;

std::string text_of(pugi::xml_node element) {
    return std::string(base::trimmed(element.text().get(), blanks));
}

struct Stated {
    pugi::xml_node element;
    pugi::xml_attribute attribute;

    const char* text() const { return attribute.value(); }
};

Stated attribute_of(const Parts& parts, const char* name) {
    const pugi::xml_attribute of_network = parts.network_body.attribute(name);
    return of_network ? Stated{parts.network_body, of_network}
                      : Stated{parts.device_body, parts.device_body.attribute(name)};
}

// "2" or "2.1": version and revision. False for anything else, which says neither.
bool read_file_version(std::string_view text, dictionary::FileInformation& file) {
    constexpr unsigned highest = 255;
    unsigned version = 0;
    unsigned revision = 0;
    const char* const end = text.data() + text.size();
    auto [at, error] = std::from_chars(text.data(), end, version);
    if (error == std::errc{} && at != end && *at == '.') {
        const auto second = std::from_chars(at + 1, end, revision);
        at = second.ptr;
        error = second.ec;
    }
    const bool known = error == std::errc{} && at == end && version <= highest && revision <= highest;
    if (known) {
        file.file_version = version;
        file.file_revision = revision;
    }
    return known;
}

// A date or a time; "" after a finding, and where it is not known.
std::string moment_of(Source& source, const Stated& stated, std::string (*read)(std::string_view)) {
    std::string moment = read(stated.text());
    if (moment.empty() && *stated.text() != '\0' && !std::string_view(stated.text()).starts_with(no_date)) {
        source.report(rules::xdd_information, stated.element, stated.attribute,
                      fmt::format("{}, which is no date or time; it is left out", quoted(stated.attribute)));
    }
    return moment;
}

void read_file(Source& source, const Parts& parts, dictionary::FileInformation& file) {
    const auto moment = [&](const char* name, std::string (*read)(std::string_view)) {
        return moment_of(source, attribute_of(parts, name), read);
    };
    file.file_name = attribute_of(parts, "fileName").text();
    file.created_by = attribute_of(parts, "fileCreator").text();
    file.creation_date = moment("fileCreationDate", eds_date);
    file.creation_time = moment("fileCreationTime", eds_time);
    file.modified_by = attribute_of(parts, "fileModifiedBy").text();
    file.modification_date = moment("fileModificationDate", eds_date);
    file.modification_time = moment("fileModificationTime", eds_time);
    const Stated version = attribute_of(parts, "fileVersion");
    if (!read_file_version(version.text(), file) && *version.text() != '\0') {
        source.report(rules::xdd_information, version.element, version.attribute,
                      fmt::format("{}, which is no version from 0 to 255.255; {}.{} counts",
                                  quoted(version.attribute), file.file_version, file.file_revision));
    }
    const pugi::xml_node identity = Source::child(parts.device_body, "DeviceIdentity");
    file.description = Source::child(Source::child(identity, "productText"), "description").text().get();
}

// An identification is hexadecimal, with 0x or without; where there is none, the identity object counts.
std::uint32_t identification(Source& source, pugi::xml_node element, const Dictionary& dictionary,
                             std::uint8_t sub_index) {
    const std::string text = text_of(element);
    const bool is_hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    std::string_view digits = text;
    digits.remove_prefix(is_hexadecimal ? 2 : 0);
    std::uint32_t number = 0;
    const int radix = is_hexadecimal || digits.size() == digits_of_u32 ? 16 : 10;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, radix);
    if (!digits.empty() && error == std::errc{} && end == digits.data() + digits.size()) {
        return number;
    }
    if (!text.empty()) {
        source.report(rules::xdd_information, element,
                      fmt::format("{} is {}, which is no number of 32 bits; the value of 1018h:{} counts",
                                  local_name(element.name()), quoted(text), sub_index));
    }
    const dictionary::Variable* const stated = dictionary.find(identity_object, sub_index);
    return stated != nullptr ? static_cast<std::uint32_t>(stated->default_value.number) : 0;
}

pugi::xml_node firmware_version(pugi::xml_node identity) {
    pugi::xml_node result;
    Source::each_child(identity, "version", [&result](pugi::xml_node version) {
        if (std::string_view(version.attribute("versionType").value()) == "FW" && !result) {
            result = version;
        }
    });
    return result;
}

void read_identity(Source& source, const Parts& parts, Dictionary& dictionary) {
    const pugi::xml_node identity = Source::child(parts.device_body, "DeviceIdentity");
    DeviceInformation& device = dictionary.device;
    device.vendor_name = text_of(Source::child(identity, "vendorName"));
    device.vendor_number = identification(source, Source::child(identity, "vendorID"), dictionary, 1);
    device.product_name = text_of(Source::child(identity, "productName"));
    device.product_number = identification(source, Source::child(identity, "productID"), dictionary, 2);
    device.revision_number = identification(source, firmware_version(identity), dictionary, 3);
    device.order_code = text_of(Source::child(identity, "orderNumber"));
}

void read_comments(const Parts& parts, std::vector<std::string>& comments) {
    const pugi::xml_node capabilities =
        Source::child(Source::child(parts.device_body, "DeviceFunction"), "capabilities");
    Source::each_child(capabilities, "characteristicsList", [&comments](pugi::xml_node list) {
        Source::each_child(list, "characteristic", [&comments](pugi::xml_node each) {
            if (label_of(Source::child(each, "characteristicName")) != comments_characteristic) {
                return;
            }
            Source::each_child(each, "characteristicContent", [&comments](pugi::xml_node content) {
                comments.push_back(label_of(content));
            });
        });
    });
}

void read_bit_rates(Source& source, const Parts& parts, std::vector<unsigned>& rates) {
    const pugi::xml_node layer =
        Source::child(Source::child(parts.network_body, "TransportLayers"), "PhysicalLayer");
    Source::each_child(Source::child(layer, "baudRate"), "supportedBaudRate", [&](pugi::xml_node each) {
        const pugi::xml_attribute value = each.attribute("value");
        for (const unsigned rate : eds::bit_rate_keys) {
            if (value.value() == fmt::format("{}{}", rate, bit_rate_unit)) {
                rates.push_back(rate);
                return;
            }
        }
        source.report(
            rules::xdd_bit_rate, each, value,
            fmt::format("{}, which is none of the bit rates of CANopen; it is left out", quoted(value)));
    });
    std::sort(rates.begin(), rates.end());
    rates.erase(std::unique(rates.begin(), rates.end()), rates.end());
}

// Dummy0005=1
void read_dummies(Source& source, const Parts& parts, std::vector<std::uint8_t>& dummies) {
    constexpr std::string_view prefix = "Dummy000";
    std::array<bool, dummy_types + 1> used{};
    const pugi::xml_node layers = Source::child(parts.network_body, "ApplicationLayers");
    Source::each_child(Source::child(layers, "dummyUsage"), "dummy", [&](pugi::xml_node each) {
        const pugi::xml_attribute entry = each.attribute("entry");
        const std::string_view text = entry.value();
        const bool is_known = text.size() == prefix.size() + 3 && text.starts_with(prefix) &&
                              text[8] >= '1' && text[8] <= '7' && text[9] == '=' &&
                              (text[10] == '0' || text[10] == '1');
        if (is_known) {
            used.at(static_cast<std::size_t>(text[8] - '0')) = text[10] == '1';
        } else {
            source.report(rules::xdd_value, each, entry,
                          fmt::format("{}; it can be Dummy0001=0 to Dummy0007=1", quoted(entry)));
        }
    });
    for (std::uint8_t type = 1; type <= dummy_types; ++type) {
        if (used.at(type)) {
            dummies.push_back(type);
        }
    }
}

void read_features(Source& source, const Parts& parts, DeviceInformation& device) {
    const pugi::xml_node management = Source::child(parts.network_body, "NetworkManagement");
    const pugi::xml_node general = Source::child(management, "CANopenGeneralFeatures");
    const pugi::xml_node master = Source::child(management, "CANopenMasterFeatures");
    device.group_messaging = source.flag(general, "groupMessaging").value_or(false);
    device.dynamic_channels = source.number(general, "dynamicChannels", 0xFF).value_or(0) != 0;
    device.granularity = static_cast<unsigned>(source.number(general, "granularity", 0xFF).value_or(0));
    device.receive_pdos = static_cast<unsigned>(source.number(general, "nrOfRxPDO", 0xFFFF).value_or(0));
    device.transmit_pdos = static_cast<unsigned>(source.number(general, "nrOfTxPDO", 0xFFFF).value_or(0));
    device.simple_boot_up_slave = source.flag(general, "bootUpSlave").value_or(false);
    device.lss_supported = source.flag(general, "layerSettingServiceSlave").value_or(false);
    device.simple_boot_up_master = source.flag(master, "bootUpMaster").value_or(false);
}

// "250", "250 Kbps" or nothing.
std::optional<std::uint32_t> read_bit_rate(Source& source, pugi::xml_node node) {
    const pugi::xml_attribute attribute = node.attribute("actualBaudRate");
    std::string_view text = base::trimmed(attribute.value(), blanks);
    if (text.ends_with(bit_rate_unit)) {
        text.remove_suffix(bit_rate_unit.size());
    }
    std::uint16_t rate = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rate);
    if (error == std::errc{} && end == text.data() + text.size()) {
        return rate;
    }
    if (!text.empty()) {
        source.report(rules::xdd_value, node, attribute,
                      fmt::format("{}, which is no number of kbit/s", quoted(attribute)));
    }
    return std::nullopt;
}

}  // namespace

void read_information(Source& source, const Parts& parts, Dictionary& dictionary) {
    read_file(source, parts, dictionary.file);
    read_identity(source, parts, dictionary);
    read_comments(parts, dictionary.comments);
    read_bit_rates(source, parts, dictionary.device.bit_rates_kbit);
    read_dummies(source, parts, dictionary.supported_dummies);
    read_features(source, parts, dictionary.device);
}

std::optional<dictionary::Commissioning> read_commissioning(Source& source, const Parts& parts) {
    const pugi::xml_node element =
        Source::child(Source::child(parts.network_body, "NetworkManagement"), "deviceCommissioning");
    if (!element) {
        return std::nullopt;
    }
    dictionary::Commissioning node;
    node.node_id = static_cast<std::uint8_t>(source.number(element, "NodeID", 0xFF).value_or(0));
    node.node_name = element.attribute("nodeName").value();
    node.bit_rate_kbit = read_bit_rate(source, element);
    node.net_number =
        static_cast<std::uint32_t>(source.number(element, "networkNumber", 0xFFFFFFFF).value_or(0));
    node.network_name = element.attribute("networkName").value();
    node.canopen_manager = source.flag(element, "CANopenManager").value_or(false);
    return node;
}

}  // namespace cgw::xdd
