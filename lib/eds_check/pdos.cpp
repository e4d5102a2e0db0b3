// What PDOs map, and how they are transmitted.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "diagnostic/rules/eds_check.hpp"
#include "eds/words.hpp"
#include "eds_check/context.hpp"
#include "eds_check/standard_objects.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using dictionary::Object;
using dictionary::Variable;
using object::Access;

constexpr unsigned most_bits = 64;
constexpr std::uint8_t most_entries = 64;
constexpr std::uint16_t first_object = 0x1000;  // below stand data types, which are dummies in a mapping

struct PdoKind {
    IndexRange communication;
    IndexRange mapping;
    bool transmits;
};
constexpr std::array pdo_kinds{PdoKind{receive_communication, receive_mapping, false},
                               PdoKind{transmit_communication, transmit_mapping, true}};

// One entry of a mapping that is in use.
struct Mapped {
    const Group& group;
    const PdoKind& kind;
    std::uint8_t sub_index;  // of the entry
    std::uint16_t index;     // of what it maps
    std::uint8_t mapped_sub_index;
    unsigned bits;

    bool is_dummy() const { return index < first_object; }
};

const PdoKind* mapping_kind(std::uint16_t index) {
    const auto* const kind = std::find_if(pdo_kinds.begin(), pdo_kinds.end(), [index](const PdoKind& each) {
        return each.mapping.contains(index);
    });
    return kind != pdo_kinds.end() ? kind : nullptr;
}

// How many entries are in use; nothing when that is not stated, or no number of a mapping.
std::optional<std::uint8_t> entries_in_use(const Object& object) {
    const auto count = number_of(object.find(0));
    return count && *count <= most_entries ? std::optional(static_cast<std::uint8_t>(*count)) : std::nullopt;
}

// Calls `take(group, kind, object)` for each mapping that stands in the file.
template <typename Take>
void for_each_mapping(const Context& context, Take take) {
    for (const Group& group : context.model.groups()) {
        const PdoKind* const kind = mapping_kind(group.index);
        if (kind != nullptr && group.has_section && group.object != nullptr &&
            object::has_sub_objects(group.object->code)) {
            take(group, *kind, *group.object);
        }
    }
}

// Calls `take(mapped)` for each entry in use whose value is stated.
template <typename Take>
void for_each_mapped(const Context& context, Take take) {
    for_each_mapping(context, [&](const Group& group, const PdoKind& kind, const Object& object) {
        const std::uint8_t count = entries_in_use(object).value_or(0);
        for (unsigned sub = 1; sub <= count; ++sub) {
            const auto sub_index = static_cast<std::uint8_t>(sub);
            if (const auto value = number_of(object.find(sub_index))) {
                take(Mapped{group, kind, sub_index, static_cast<std::uint16_t>(*value >> 16U),
                            static_cast<std::uint8_t>(*value >> 8U),
                            static_cast<unsigned>(*value & eds::highest_u8)});
            }
        }
    });
}

const Variable* target_of(const Context& context, const Mapped& mapped) {
    return context.sheet.dictionary.find(mapped.index, mapped.mapped_sub_index);
}

std::string entry_text(const Context& context, const Mapped& mapped) {
    const dictionary::Object* const object = context.sheet.dictionary.find(mapped.index);
    const bool alone =
        mapped.mapped_sub_index == 0 && object != nullptr && !object::has_sub_objects(object->code);
    return fmt::format("[{:04X}sub{:X}] maps {}", mapped.group.index, mapped.sub_index,
                       mapped.is_dummy() ? fmt::format("the dummy {}", object_text(mapped.index))
                       : alone           ? object_text(mapped.index)
                                         : object_text(mapped.index, mapped.mapped_sub_index));
}

// It has a section, of which the reader has said that it cannot be understood.
bool is_unreadable(const Context& context, const Mapped& mapped) {
    const Group* const group = context.model.find(mapped.index);
    const Part* const part = group != nullptr ? group->find(mapped.mapped_sub_index) : nullptr;
    const bool alone = group != nullptr && group->object == nullptr && group->has_section;
    return alone || (part != nullptr && part->variable == nullptr);
}

void report(const Context& context, const diagnostic::Rule& rule, const Mapped& mapped, std::string message) {
    std::vector<diagnostic::Related> related;
    const Group* const group = context.model.find(mapped.index);
    if (group != nullptr && !mapped.is_dummy()) {
        const Part* const part = group->find(mapped.mapped_sub_index);
        const Part& shown = part != nullptr ? *part : group->parts.front();
        related.push_back({context.reading.location(context.header_of(shown.section)), "the mapped object"});
    }
    context.reading.report(rule, context.value_place(mapped.group, mapped.sub_index), std::move(message), "",
                           std::move(related));
}

// A dummy is a data type; nullptr where there is nothing to be mapped.
const dictionary::TypeRow* type_of(const Context& context, const Mapped& mapped) {
    if (mapped.is_dummy()) {
        return dictionary::find_type(mapped.index);
    }
    const Variable* const variable = target_of(context, mapped);
    return variable != nullptr ? &dictionary::row_of(variable->type) : nullptr;
}

// A boolean may be mapped as one bit, or as the byte that it takes.
bool is_length_of(const dictionary::TypeRow& type, unsigned bits) {
    constexpr unsigned bits_of_byte = 8;
    return type.bits == 0 || bits == type.bits ||
           (type.type == object::DataType::boolean && bits == bits_of_byte);
}

bool fits_direction(Access access, bool transmits) {
    if (transmits) {
        return access == Access::ro || access == Access::rw || access == Access::rwr ||
               access == Access::constant;
    }
    return access == Access::wo || access == Access::rw || access == Access::rww;
}

}  // namespace

void check_mapped_objects(const Context& context) {
    for_each_mapped(context, [&](const Mapped& mapped) {
        if (!mapped.is_dummy() && target_of(context, mapped) == nullptr && !is_unreadable(context, mapped)) {
            report(context, rules::eds_mapped_absent, mapped,
                   fmt::format("{}, which does not exist", entry_text(context, mapped)));
        } else if (mapped.index == 0) {
            report(context, rules::eds_mapped_absent, mapped,
                   fmt::format("[{:04X}sub{:X}] is in use and maps nothing", mapped.group.index,
                               mapped.sub_index));
        }
    });
}

void check_mapped_lengths(const Context& context) {
    for_each_mapped(context, [&](const Mapped& mapped) {
        const dictionary::TypeRow* const type = type_of(context, mapped);
        if (type != nullptr && !is_length_of(*type, mapped.bits)) {
            report(context, rules::eds_mapped_length, mapped,
                   fmt::format("{} with {} bits; it is {} with {}", entry_text(context, mapped), mapped.bits,
                               type->name, type->bits));
        }
    });
}

void check_mapped_mappable(const Context& context) {
    for_each_mapped(context, [&](const Mapped& mapped) {
        const Variable* const variable = mapped.is_dummy() ? nullptr : target_of(context, mapped);
        if (variable != nullptr && !variable->pdo_mapping) {
            report(context, rules::eds_mapped_refused, mapped,
                   fmt::format("{}, which cannot be mapped: its PDOMapping is not 1",
                               entry_text(context, mapped)));
        }
    });
}

void check_mapped_directions(const Context& context) {
    for_each_mapped(context, [&](const Mapped& mapped) {
        const Variable* const variable = mapped.is_dummy() ? nullptr : target_of(context, mapped);
        if (variable != nullptr && !fits_direction(variable->access, mapped.kind.transmits)) {
            report(context, rules::eds_mapped_direction, mapped,
                   fmt::format("{} into a {} PDO, and its AccessType is {}", entry_text(context, mapped),
                               mapped.kind.transmits ? "transmit" : "receive",
                               eds::access_types[static_cast<std::size_t>(variable->access)]));
        }
    });
}

void check_dummies(const Context& context) {
    const auto& supported = context.sheet.dictionary.supported_dummies;
    for_each_mapped(context, [&](const Mapped& mapped) {
        if (!mapped.is_dummy() || mapped.index == 0) {
            return;
        }
        const bool allowed = std::find(supported.begin(), supported.end(), mapped.index) != supported.end();
        if (mapped.kind.transmits) {
            report(context, rules::eds_dummy, mapped,
                   fmt::format("{}; only receive PDOs have dummies", entry_text(context, mapped)));
        } else if (!allowed) {
            report(context, rules::eds_dummy, mapped,
                   fmt::format("{}, and Dummy{:04X} of [DummyUsage] is not 1", entry_text(context, mapped),
                               mapped.index));
        }
    });
}

void check_mapped_bits(const Context& context) {
    for_each_mapping(context, [&](const Group& group, const PdoKind&, const Object& object) {
        unsigned bits = 0;
        const std::uint8_t count = entries_in_use(object).value_or(0);
        for (unsigned sub = 1; sub <= count; ++sub) {
            const auto value = number_of(object.find(static_cast<std::uint8_t>(sub)));
            bits += static_cast<unsigned>(value.value_or(0) & eds::highest_u8);
        }
        if (bits > most_bits) {
            context.reading.report(rules::eds_mapped_bits, context.header_of(group.own().section),
                                   fmt::format("{} maps {} bits; a PDO has at most {}",
                                               context.label(group.own()), bits, most_bits));
        }
    });
}

void check_mapped_counts(const Context& context) {
    constexpr std::uint64_t sam_mpdo = 254;
    constexpr std::uint64_t dam_mpdo = 255;
    for_each_mapping(context, [&](const Group& group, const PdoKind&, const Object& object) {
        const auto count = number_of(object.find(0));
        if (!count || *count == sam_mpdo || *count == dam_mpdo) {
            return;
        }
        const std::size_t entries = object.variables.size() - (object.find(0) != nullptr ? 1U : 0U);
        if (*count > most_entries || *count > entries) {
            context.reading.report(rules::eds_mapped_count, context.value_place(group, 0),
                                   fmt::format("{} entries of {} are in use, and {} stand there", *count,
                                               context.label(group.own()), entries));
        }
    });
}

void check_pdo_pairs(const Context& context) {
    for (const Group& group : context.model.groups()) {
        if (!group.has_section) {
            continue;
        }
        for (const PdoKind& kind : pdo_kinds) {
            const bool is_mapping = kind.mapping.contains(group.index);
            if (!is_mapping && !kind.communication.contains(group.index)) {
                continue;
            }
            const IndexRange& own = is_mapping ? kind.mapping : kind.communication;
            const IndexRange& other = is_mapping ? kind.communication : kind.mapping;
            const auto wanted = static_cast<std::uint16_t>(other.first + (group.index - own.first));
            if (context.sheet.dictionary.find(wanted) == nullptr && context.model.find(wanted) == nullptr) {
                context.reading.report(
                    rules::eds_pdo_pair, context.header_of(group.own().section),
                    fmt::format("{} is the {} parameter of a PDO, and its {} parameter {} is missing",
                                context.label(group.own()), is_mapping ? "mapping" : "communication",
                                is_mapping ? "communication" : "mapping", object_text(wanted)));
            }
        }
    }
}

void check_transmission_types(const Context& context) {
    constexpr std::uint8_t type_sub_index = 2;
    constexpr std::uint64_t first_reserved = 241;
    constexpr std::uint64_t last_reserved = 251;
    constexpr std::uint64_t last_on_request = 253;
    for (const Group& group : context.model.groups()) {
        const bool receives = receive_communication.contains(group.index);
        if (group.object == nullptr || !group.has_section ||
            (!receives && !transmit_communication.contains(group.index))) {
            continue;
        }
        const auto type = number_of(group.object->find(type_sub_index));
        const std::uint64_t last = receives ? last_on_request : last_reserved;
        if (type && *type >= first_reserved && *type <= last) {
            context.reading.report(
                rules::eds_transmission_type, context.value_place(group, type_sub_index),
                fmt::format("transmission type {} is {}", *type,
                            *type > last_reserved ? "for transmit PDOs only" : "a reserved one"));
        }
    }
}

}  // namespace cgw::eds_check
