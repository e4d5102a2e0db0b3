// What the file says about itself, its device and its node.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds/words.hpp"
#include "eds_check/context.hpp"
#include "eds_check/counts.hpp"
#include "eds_check/dates.hpp"
#include "eds_check/standard_objects.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using eds::SectionKind;

constexpr std::uint16_t identity = 0x1018;

// Keys of [DeviceInfo] that repeat the identity object.
struct IdentityRow {
    std::string_view key;
    std::uint8_t sub_index;
    bool from_1;  // 0 is no such number
};
constexpr std::array identity_rows{IdentityRow{"VendorNumber", 1, true},
                                   IdentityRow{"ProductNumber", 2, true},
                                   IdentityRow{"RevisionNumber", 3, false}};

const IdentityRow* find_identity(std::string_view key) {
    const auto* const row =
        std::find_if(identity_rows.begin(), identity_rows.end(), [key](const IdentityRow& each) {
            return each.key.size() == key.size() && base::equal_ignoring_case(each.key, key);
        });
    return row != identity_rows.end() ? row : nullptr;
}

const dictionary::Variable* identity_variable(const Context& context, std::uint8_t sub_index) {
    return context.sheet.dictionary.find(identity, sub_index);
}

struct PdoCount {
    std::string_view key;
    IndexRange range;
    std::string_view name;
};
constexpr std::array pdo_counts{PdoCount{"NrOfRXPDO", receive_communication, "receive"},
                                PdoCount{"NrOfTXPDO", transmit_communication, "transmit"}};

const PdoCount* find_pdo_count(std::string_view key) {
    const auto* const row = std::find_if(pdo_counts.begin(), pdo_counts.end(), [key](const PdoCount& each) {
        return base::equal_ignoring_case(each.key, key);
    });
    return row != pdo_counts.end() ? row : nullptr;
}

std::string cut(std::string_view text) {
    constexpr std::size_t longest = 60;
    return base::printable(text.substr(0, longest));
}

template <typename Judge>
void check_text_keys(const Context& context, const diagnostic::Rule& rule,
                     std::initializer_list<std::string_view> keys, Judge judge) {
    for (const std::string_view key : keys) {
        const std::uint32_t line = context.line_of(SectionKind::file_info, key);
        if (!context.stated(line)) {
            continue;
        }
        const std::string message = judge(context.document.value(line));
        if (!message.empty()) {
            context.reading.report(
                rule, context.document.value_span(line),
                fmt::format("{} is `{}`; {}", key, cut(context.document.value(line)), message));
        }
    }
}

}  // namespace

std::optional<std::size_t> described_pdos(const Context& context, std::string_view key) {
    const PdoCount* const row = find_pdo_count(key);
    if (row == nullptr) {
        return std::nullopt;
    }
    const std::span<const Group> groups = context.model.groups();
    return static_cast<std::size_t>(std::count_if(groups.begin(), groups.end(), [&](const Group& group) {
        return group.has_section && row->range.contains(group.index);
    }));
}

bool lacks_pdos(const Context& context, std::string_view key) {
    constexpr unsigned mapping_offset = 0x200;
    const PdoCount* const row = find_pdo_count(key);
    const auto is_missing = [&](unsigned index) {
        return row != nullptr && row->range.contains(static_cast<std::uint16_t>(index)) &&
               context.model.find(
                   {.kind = SectionKind::object, .index = static_cast<std::uint16_t>(index)}) == nullptr;
    };
    const std::span<const Listed> listed = context.model.listed();
    const std::span<const Group> groups = context.model.groups();
    return std::any_of(listed.begin(), listed.end(),
                       [&](const Listed& each) { return is_missing(each.index); }) ||
           std::any_of(groups.begin(), groups.end(), [&](const Group& group) {
               return group.index >= mapping_offset && is_missing(group.index - mapping_offset);
           });
}

std::optional<std::uint64_t> identity_number(const Context& context, std::string_view key) {
    const IdentityRow* const row = find_identity(key);
    return row != nullptr ? number_of(identity_variable(context, row->sub_index)) : std::nullopt;
}

bool is_numbered_from_1(std::string_view key) {
    const IdentityRow* const row = find_identity(key);
    return row != nullptr && row->from_1;
}

void check_file_name(const Context& context) {
    const std::uint32_t line = context.line_of(SectionKind::file_info, "FileName");
    if (context.options.file_name.empty() || !context.stated(line) ||
        (context.document.value(line).size() == context.options.file_name.size() &&
         base::equal_ignoring_case(context.document.value(line), context.options.file_name))) {
        return;
    }
    context.reading.report(rules::eds_file_name, context.document.value_span(line),
                           fmt::format("FileName is `{}`, and the file is called {}",
                                       cut(context.document.value(line)), context.options.file_name));
}

void check_version(const Context& context) {
    check_text_keys(context, rules::eds_version, {"EDSVersion"}, [](std::string_view text) {
        return text == "4.0" || text == "3.0" ? "" : "it can be 4.0, or 3.0 in old files";
    });
}

void check_dates(const Context& context) {
    check_text_keys(context, rules::eds_date, {"CreationDate", "ModificationDate"},
                    [](std::string_view text) { return is_date(text) ? "" : "a date is mm-dd-yyyy"; });
}

void check_times(const Context& context) {
    check_text_keys(context, rules::eds_time, {"CreationTime", "ModificationTime"},
                    [](std::string_view text) {
                        return is_time(text) ? "" : "a time is hh:mmAM or hh:mmPM, from 12:00AM";
                    });
}

void check_identity(const Context& context) {
    const Group* const group = context.model.find(identity);
    for (const IdentityRow& row : identity_rows) {
        const std::uint32_t line = context.line_of(SectionKind::device_info, row.key);
        const auto stated = context.number(line);
        const auto held = identity_number(context, row.key);
        if (group == nullptr || !stated || !held || *stated == *held) {
            continue;
        }
        const Span place = context.value_place(*group, row.sub_index);
        context.reading.report(rules::eds_identity, context.document.value_span(line),
                               fmt::format("{} is 0x{:08X}, and {} is 0x{:08X}", row.key, *stated,
                                           object_text(identity, row.sub_index), *held),
                               "", {{context.reading.location(place), "what the device answers"}});
    }
}

void check_bit_rates(const Context& context) {
    const auto section = context.sheet.sections.find(SectionKind::device_info);
    if (section && context.sheet.dictionary.device.bit_rates_kbit.empty()) {
        context.reading.report(rules::eds_bit_rates, context.header_of(*section),
                               "no BaudRate_ key of [DeviceInfo] is 1: the device supports no bit rate");
    }
}

void check_granularity(const Context& context) {
    constexpr std::uint64_t most_bits = 64;
    const std::uint32_t line = context.line_of(SectionKind::device_info, "Granularity");
    const auto stated = context.number(line);
    if (stated && *stated > most_bits) {
        context.reading.report(rules::eds_granularity, context.document.value_span(line),
                               fmt::format("Granularity is {}; it can be 0 to {}", *stated, most_bits));
    }
}

void check_pdo_counts(const Context& context) {
    if (context.sheet.dictionary.device.compact_pdo != 0) {
        return;  // the numbers say how many PDOs are implied
    }
    for (const PdoCount& row : pdo_counts) {
        const std::uint32_t line = context.line_of(SectionKind::device_info, row.key);
        const auto stated = context.number(line);
        const std::size_t count = described_pdos(context, row.key).value_or(0);
        if (stated && *stated != count) {
            context.reading.report(
                rules::eds_pdo_count, context.document.value_span(line),
                fmt::format("{} is {}, and the file describes {} {} PDO{} ({:04X}h and above)", row.key,
                            *stated, count, row.name, count == 1 ? "" : "s", row.range.first));
        }
    }
}

void check_lss(const Context& context) {
    constexpr std::uint8_t serial_number = 4;
    const std::uint32_t line = context.line_of(SectionKind::device_info, "LSS_Supported");
    if (context.number(line) == 1U && identity_variable(context, serial_number) == nullptr) {
        context.reading.report(
            rules::eds_lss, context.document.value_span(line),
            "the device supports LSS, which needs a serial number, and 1018h:4 is missing");
    }
}

void check_node(const Context& context) {
    constexpr std::uint8_t highest = 127;
    const auto section = context.sheet.sections.find(SectionKind::commissioning);
    if (!section) {
        return;
    }
    const std::uint32_t line = context.line_of(SectionKind::commissioning, "NodeID");
    const auto stated = context.number(line);
    if (stated && (*stated == 0 || *stated > highest)) {
        context.reading.report(rules::eds_node_id, context.document.value_span(line),
                               fmt::format("NodeID is {}; it can be 1 to {}", *stated, highest));
    } else if (!context.stated(line)) {
        context.reading.report(rules::eds_node_id, context.header_of(*section),
                               "a configuration file is of one node, and its NodeID is missing");
    }
}

void check_node_bit_rate(const Context& context) {
    const std::uint32_t line = context.line_of(SectionKind::commissioning, "Baudrate");
    const auto stated = context.number(line);
    if (!stated || *stated > eds::highest_u16) {  // told by the reader
        return;
    }
    const auto& supported = context.sheet.dictionary.device.bit_rates_kbit;
    const bool known =
        std::find(eds::bit_rate_keys.begin(), eds::bit_rate_keys.end(), *stated) != eds::bit_rate_keys.end();
    const bool fits = std::find(supported.begin(), supported.end(), *stated) != supported.end();
    if (!known || (!fits && !supported.empty())) {
        context.reading.report(
            rules::eds_node_bit_rate, context.document.value_span(line),
            known ? fmt::format("BaudRate_{} of [DeviceInfo] is not 1", *stated)
                  : fmt::format("Baudrate is {}, which is no bit rate of CANopen in kbit/s", *stated));
    }
}

void check_serial_number(const Context& context) {
    constexpr std::uint8_t serial_number = 4;
    const std::uint32_t line = context.line_of(SectionKind::commissioning, "LSS_SerialNumber");
    const auto stated = context.number(line);
    const auto held = number_of(identity_variable(context, serial_number));
    const Group* const group = context.model.find(identity);
    if (group != nullptr && stated && held && *stated != 0 && *held != 0 && *stated != *held) {
        context.reading.report(
            rules::eds_serial_number, context.document.value_span(line),
            fmt::format("LSS_SerialNumber is {}, and {} is {}", *stated, object_text(identity, serial_number),
                        *held),
            "", {{context.reading.location(context.value_place(*group, serial_number)), "here"}});
    }
}

void check_configured_values(const Context& context) {
    if (context.sheet.commissioning) {
        return;
    }
    for_each_part(context, [&](const Group&, const Part& part) {
        const std::uint32_t line = part.lines[ObjectKey::parameter_value];
        if (context.stated(line)) {
            context.reading.report(rules::eds_configured_value, context.document.key_span(line),
                                   fmt::format("{} has a ParameterValue, and no section says of which node",
                                               context.label(part)));
        }
    });
}

}  // namespace cgw::eds_check
