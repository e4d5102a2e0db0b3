#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "catalogue/objects.hpp"
#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "explain/device_objects.hpp"
#include "explain/entries.hpp"
#include "explain/wording.hpp"
#include "facts/communication.hpp"
#include "object/vocabulary.hpp"

namespace cgw::explain {

namespace {

using catalogue::ErrorDescription;
using parameter::Catalogue;
using parameter::Device;
using parameter::NamedBit;
using parameter::Program;
using parameter::Row;

constexpr unsigned word = 16;

bool is_set(std::uint32_t value, unsigned bit) {
    return ((value >> bit) & 1U) != 0;
}

void add_all(std::vector<std::string>& lines, std::string_view before,
             std::span<const std::string_view> texts) {
    for (const std::string_view text : texts) {
        lines.push_back(fmt::format("{}: {}", before, text));
    }
}

// What an error means, in the space of a bit.
std::vector<std::string> error_lines(const std::string& name, const ErrorDescription& error) {
    std::vector<std::string> lines{name};
    add_all(lines, "cause", error.cause);
    add_all(lines, "action", error.action);
    lines.push_back(fmt::format("clears: {}", error.clears));
    return lines;
}

// Error bit of 2000h or 2005h: the parameter in either device, with what is known about it.
std::vector<std::string> parameter_bit_lines(std::uint16_t number, const Catalogue& catalogue) {
    std::vector<std::string> lines;
    const ErrorDescription* told = nullptr;
    for (const Device device : {Device::governor, Device::gateway}) {
        const Row* row = catalogue.find(device, number);
        if (row == nullptr) {
            continue;
        }
        const std::string name = fmt::format("{} {}", to_text(device), label(*row));
        const ErrorDescription* error = catalogue::find_error(device, Program::application, number);
        if (error == nullptr) {
            lines.push_back(fmt::format("{}: {}", name, row->text));
        } else if (error != told) {
            const std::string both = error->governor && error->gateway ? label(*row) : name;
            const std::vector<std::string> more = error_lines(both, *error);
            lines.insert(lines.end(), more.begin(), more.end());
            told = error;
        }
    }
    return lines;
}

// D21: the governor has errors that our documents do not name. The bits of 2005h are all known (D52).
std::vector<std::string> unknown_bit_lines(const catalogue::ObjectDescription& object, int number) {
    if (object.index == config::object::errors && object.bit_parameter != 0) {
        return {fmt::format("error {}: no document names it, see the governor's own manual", number)};
    }
    return {"no meaning is known: free, or not printed"};
}

const NamedBit* find_bit(std::span<const NamedBit> bits, unsigned bit) {
    const auto found =
        std::find_if(bits.begin(), bits.end(), [bit](const NamedBit& b) { return b.bit == bit; });
    return found != bits.end() ? &*found : nullptr;
}

// --- words that are no bits: COB-IDs, mapping entries, the consumer heartbeat ---

void add_cob_id(Entry& entry, std::uint32_t value) {
    const std::uint32_t identifier = value & facts::cob::highest;
    entry.add("identifier", fmt::format("{} ({})", base::identifier_text(identifier), identifier));
    entry.add("active", (value & facts::pdo_not_valid) != 0 ? "no, bit 31 is set" : "yes, bit 31 is 0");
}

void add_mapping(Entry& entry, std::uint32_t value) {
    constexpr std::uint32_t byte = 0xFF;
    entry.add("maps", value == 0 ? "nothing"
                                 : fmt::format("{}, {} bits", object_text(value >> 16U, (value >> 8U) & byte),
                                               value & byte));
}

void add_heartbeat(Entry& entry, std::uint32_t value) {
    constexpr std::uint32_t half = 0xFFFF;
    entry.add("partner", value == 0 ? "nobody is monitored" : fmt::format("node {}", value >> 16U));
    entry.add("time", value == 0 ? "" : fmt::format("{} ms, effective", value & half));
}

void add_period(Entry& entry, std::uint32_t value) {
    entry.add("time", value == 0 ? "0: none" : fmt::format("{} ms, effective", value));
}

void add_serial(Entry& entry, std::uint32_t value) {
    constexpr std::uint32_t half = 0xFFFF;
    entry.add("number", fmt::format("3844 is {}, 3845 is {}", value >> 16U, value & half));
}

void add_transmission_type(Entry& entry, std::uint32_t value) {
    entry.add("number",
              fmt::format("{}{}", value,
                          value == config::transmission_type ? "" : ", which the gateway never has"));
}

constexpr std::string_view of_configuration =
    "what it means depends on the configuration: `cgw emit pdo-table` tells";

void add_unsigned_word(Entry& entry, std::uint32_t value) {
    entry.add("word", fmt::format("{}; {}", value, of_configuration));
}

void add_signed_word(Entry& entry, std::uint32_t value) {
    const auto number = static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
    entry.add("word", fmt::format("{}; {}", number, of_configuration));
}

// What has neither bits nor a form of its own.
void add_number(Entry& entry, std::uint32_t value) {
    entry.add("number", fmt::format("{} (0x{:X})", value, value));
}

struct Decoder {
    std::uint16_t first;
    std::uint16_t last;
    std::uint8_t first_sub;
    std::uint8_t last_sub;
    void (*add)(Entry& entry, std::uint32_t value);
};

constexpr std::uint8_t any = 0xFF;
constexpr Decoder decoders[] = {
    {0x1016, 0x1016, 1, 1, add_heartbeat},       {0x1017, 0x1017, 0, 0, add_period},
    {0x1018, 0x1018, 4, 4, add_serial},          {0x1200, 0x1200, 1, 2, add_cob_id},
    {0x1400, 0x1403, 1, 1, add_cob_id},          {0x1400, 0x1403, 2, 2, add_transmission_type},
    {0x1400, 0x1403, 5, 5, add_period},          {0x1600, 0x1603, 1, 4, add_mapping},
    {0x1800, 0x180F, 1, 1, add_cob_id},          {0x1800, 0x180F, 2, 2, add_transmission_type},
    {0x1800, 0x180F, 5, 5, add_period},          {0x1A00, 0x1A0F, 1, 4, add_mapping},
    {0x2001, 0x2001, 1, any, add_unsigned_word}, {0x2002, 0x2002, 1, any, add_signed_word},
    {0x2004, 0x2004, 1, any, add_unsigned_word},
};

const Decoder* find_decoder(std::uint16_t index, std::uint8_t sub) {
    const auto* const end = std::end(decoders);
    const auto* const found = std::find_if(std::begin(decoders), end, [&](const Decoder& d) {
        return index >= d.first && index <= d.last && sub >= d.first_sub && sub <= d.last_sub;
    });
    return found != end ? found : nullptr;
}

void add_object_bits(Entry& entry, const ObjectName& name, std::uint32_t value, unsigned width,
                     const Catalogue& catalogue) {
    const std::uint8_t sub = name.sub.value_or(0);
    const catalogue::ObjectDescription* object = catalogue::find_object(name.index, sub);
    const std::vector<NamedBit> bits = catalogue::object_bits(name.index, sub, catalogue);
    if (bits.empty() && object->bit_parameter == 0) {
        add_number(entry, value);
        return;
    }
    for (unsigned bit = 0; bit < width; ++bit) {
        if (!is_set(value, bit)) {
            continue;
        }
        const std::string title = fmt::format("bit {}", bit);
        const NamedBit* named = find_bit(bits, bit);
        const bool is_parameter = object->bit_parameter != 0;
        const int number = is_parameter
                               ? object->bit_parameter + (sub - object->first_sub) * static_cast<int>(word) +
                                     static_cast<int>(bit)
                               : 0;
        if (named == nullptr) {
            entry.add(title, unknown_bit_lines(*object, number));
        } else if (is_parameter) {
            entry.add(title, parameter_bit_lines(static_cast<std::uint16_t>(number), catalogue),
                      Style::lines);
        } else {
            entry.add(title, fmt::format("{}: {}", named->name, named->text));
        }
    }
    if (value == 0) {
        entry.add("bits", "none is set");
    }
}

// --- parameters ---

std::string range_judgement(const Row& row, double value) {
    if (!row.decimal && value != std::floor(value)) {
        return "no whole number, and it takes no other";
    }
    return row.has_range() ? fmt::format("{} {}", row.allows(value) ? "within" : "outside", range_text(row))
                           : std::string();
}

void add_parameter_bits(Entry& entry, const Row& row, std::uint32_t value) {
    for (unsigned bit = 0; bit < 2 * word && !row.bits.empty(); ++bit) {
        if (!is_set(value, bit)) {
            continue;
        }
        const NamedBit* named = find_bit(row.bits, bit);
        entry.add(fmt::format("bit {}", bit),
                  named != nullptr ? fmt::format("{}: {}", named->name, named->text) : "no meaning is known");
    }
    if (value == 0 && !row.bits.empty()) {
        entry.add("bits", "none is set");
    }
}

}  // namespace

Entry parameter_value_entry(const Row& row, double value, const Catalogue& catalogue) {
    Entry entry{"value",
                fmt::format("{} {} = {}", program_text(row.device, row.program), label(row),
                            quantity_text(row, value)),
                {}};
    entry.add("meaning", row.text);
    for (const parameter::NamedValue& named : row.values) {
        if (named.value == value) {
            entry.add("this value", named.text);
        }
    }
    if (value >= 0 && value == std::floor(value)) {  // read as 32 bits at most
        const auto whole = static_cast<std::uint32_t>(std::min<double>(value, ~std::uint32_t{0}));
        add_parameter_bits(entry, row, whole);
        add_time(entry, row, whole);
    }
    add_what_it_leads_to(entry, row, value, catalogue);
    entry.add("range", range_judgement(row, value));
    const ErrorDescription* error = catalogue::find_error(row.device, row.program, row.number);
    if (error == nullptr || value == 0 || error->counter == row.number) {
        return entry;
    }
    const Entry more = error_entry(*error, catalogue);
    std::copy_if(more.fields.begin(), more.fields.end(), std::back_inserter(entry.fields),
                 [](const Field& field) { return field.label != "source"; });
    return entry;
}

Answer object_value_answer(const ObjectName& name, std::uint32_t value, const Catalogue& catalogue) {
    Answer answer;
    const DeviceObjects objects(catalogue);
    const dictionary::Object* object = objects.find(name.index);
    const std::uint8_t sub = name.sub.value_or(0);
    if (object == nullptr || !objects.has(name.index, sub)) {
        answer.complaint = fmt::format("the gateway has no object {}",
                                       name.sub ? object_text(name.index, sub) : object_text(name.index));
        return answer;
    }
    const bool is_variable = object->code == object::ObjectCode::var;
    const std::string where = is_variable ? object_text(name.index) : object_text(name.index, sub);
    if (!is_variable && !name.sub) {
        answer.complaint = fmt::format("{} has several entries", object_text(name.index));
        answer.help = fmt::format("say which: {}={}", object_text(name.index, 1), value);
        return answer;
    }
    const dictionary::Variable* variable = object->find(sub);
    const unsigned width =
        variable != nullptr ? 8U * object::size_of(variable->type) : word;  // 5.1: manufacturer objects
    if (width < 2 * word && value >> width != 0) {
        answer.complaint = fmt::format("0x{:X} does not fit {}, which has {} bits", value, where, width);
        return answer;
    }
    Entry& entry = answer.entries.emplace_back();
    entry.kind = "value";
    entry.title = fmt::format("{} {} = 0x{:0{}X}", where, object->name, value, width / 4);
    entry.add("holds", catalogue::find_object(name.index, sub)->text);
    if (const Decoder* decoder = find_decoder(name.index, sub)) {
        decoder->add(entry, value);
    } else {
        add_object_bits(entry, name, value, width, catalogue);
    }
    entry.add("source", catalogue::find_object(name.index, sub)->section);
    return answer;
}

}  // namespace cgw::explain
