// What is wrong between fields of a record, between records, and between sections: what can be said about one
// field. For the rest the verifier's word on the section has to do.
#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "facts/gateway.hpp"
#include "inspect/walk.hpp"
#include "object/object_table.hpp"

namespace cgw::inspect {
namespace {

using image::SectionId;

// Visits the groups of a section that hold a whole record, with the record's bytes.
template <typename Visit>
void each_record(const Outline& outline, SectionId id, Groups& groups, Visit visit) {
    const Record& record = *find_record(static_cast<std::uint16_t>(id));
    for (Group& group : groups) {
        if (group.section == record.name && group.record) {
            const auto bytes = outline.record(id, *group.record);
            if (bytes.size() >= record.size) {
                visit(group, bytes);
            }
        }
    }
}

// Keeps what is known already.
void blame(Group& group, std::size_t offset_in_record, std::string wrong) {
    for (Item& item : group.items) {
        if (item.offset == group.items.front().offset + offset_in_record && item.wrong.empty()) {
            item.wrong = std::move(wrong);
            return;
        }
    }
}

void judge_order(const Outline& outline, SectionId id, Groups& groups) {
    std::int64_t last = -1;
    each_record(outline, id, groups, [&](Group& group, std::span<const std::uint8_t> record) {
        const std::int64_t number = load(record, 0, 2);
        if (number <= last) {
            blame(group, 0, fmt::format("must be more than {}, the one before", last));
        }
        last = number;
    });
}

void judge_objects(const Outline& outline, Groups& groups) {
    namespace at = image::object_record;
    std::uint32_t last = 0;
    each_record(outline, SectionId::objects, groups, [&](Group& group, std::span<const std::uint8_t> record) {
        const std::uint32_t key = (load(record, at::index, 2) << 8) | record[at::sub_index];
        if (key <= last) {
            blame(group, at::index, "objects must ascend, each once");
        }
        last = key;
    });
    std::size_t next = 0;
    for (const std::size_t size : {4U, 2U, 1U}) {
        each_record(outline, SectionId::objects, groups,
                    [&](Group& group, std::span<const std::uint8_t> record) {
                        if (object::size_of(static_cast<object::DataType>(record[at::type])) == size) {
                            if (load(record, at::offset, 2) != next) {
                                blame(group, at::offset, fmt::format("must be {}", next));
                            }
                            next += size;
                        }
                    });
    }
}

// Why no such object can be in the word; "" when one can.
std::string wrong_mapping(const Outline& outline, std::uint32_t mapping) {
    namespace at = image::object_record;
    const std::uint32_t index = mapping >> 16;
    const std::uint32_t sub_index = (mapping >> 8) & 0xFFU;
    if ((mapping & 0xFFU) != facts::word_bits) {
        return fmt::format("must have {} bits", facts::word_bits);
    }
    if (index == facts::object::unsigned16_dummy) {
        return "";
    }
    const Extent* objects = outline.find(SectionId::objects);
    for (std::size_t i = 0; objects != nullptr && i < objects->count(); ++i) {
        const auto record = outline.record(SectionId::objects, i);
        if (record.size() >= at::size && load(record, at::index, 2) == index &&
            record[at::sub_index] == sub_index) {
            return (record[at::rights] & (object::flag_pdo_mappable << 4)) != 0
                       ? ""
                       : "the object is not mappable";
        }
    }
    return "there is no such object";
}

void judge_pdos(const Outline& outline, Groups& groups) {
    namespace at = image::pdo;
    each_record(outline, SectionId::pdos, groups, [&](Group& group, std::span<const std::uint8_t> record) {
        const bool receives = *group.record >= facts::tpdo_count;
        const std::size_t number = (receives ? *group.record - facts::tpdo_count : *group.record) + 1;
        if (record[at::direction] != (receives ? 1 : 0)) {
            blame(group, at::direction, fmt::format("must be {}", receives ? 1 : 0));
        }
        if (record[at::number] != number) {
            blame(group, at::number, fmt::format("must be {}", number));
        }
        if ((record[at::active] != 0) != (record[at::word_count] != 0)) {
            blame(group, at::word_count, "an active PDO has words, another one none");
        }
        for (std::size_t word = 0; word < facts::words_per_pdo; ++word) {
            const std::uint32_t mapping = load(record, at::mapping + 4 * word, 4);
            const bool used = word < record[at::word_count];
            blame(group, at::mapping + 4 * word,
                  used           ? wrong_mapping(outline, mapping)
                  : mapping != 0 ? "behind the words that the PDO carries"
                                 : "");
        }
    });
}

void judge_text(const Outline& outline, const Extent& strings, Group& group,
                std::span<const std::uint8_t> record, std::size_t offset_at, std::size_t length_at) {
    const std::size_t offset = load(record, offset_at, 4);
    const std::size_t length = record[length_at];
    if (offset > strings.size || length > strings.size - offset) {
        blame(group, offset_at, fmt::format("the text ends behind the {} bytes of `strings`", strings.size));
        return;
    }
    const auto bytes = outline.bytes.subspan(strings.offset + offset, length);
    const std::string text(bytes.begin(), bytes.end());
    if (base::printable(text) != text) {
        blame(group, offset_at, "the text is not printable UTF-8");
    }
}

void judge_labels(const Outline& outline, Groups& groups) {
    namespace at = image::label;
    const Extent* strings = outline.find(SectionId::strings);
    if (strings == nullptr) {
        return;
    }
    each_record(outline, SectionId::labels, groups, [&](Group& group, std::span<const std::uint8_t> record) {
        judge_text(outline, *strings, group, record, at::name_offset, at::name_length);
        judge_text(outline, *strings, group, record, at::unit_offset, at::unit_length);
    });
}

void judge_model(const Outline& outline, Groups& groups) {
    const Extent* model = outline.find(SectionId::model);
    if (model == nullptr || groups.empty()) {
        return;
    }
    const auto digest = base::sha256(outline.bytes.subspan(model->offset, model->size));
    const auto stated =
        outline.bytes.subspan(image::header::configuration_id, image::header::configuration_id_size);
    for (Group& group : groups) {
        if (group.section == "model" && !std::equal(stated.begin(), stated.end(), digest.begin())) {
            group.wrong = "its SHA-256 is not the configuration id";
        }
    }
}

}  // namespace

void judge_sections(const Outline& outline, Groups& groups) {
    for (const SectionId id :
         {SectionId::switches, SectionId::sensors, SectionId::signals, SectionId::labels}) {
        judge_order(outline, id, groups);
    }
    judge_objects(outline, groups);
    judge_pdos(outline, groups);
    judge_labels(outline, groups);
    judge_model(outline, groups);
}

}  // namespace cgw::inspect
