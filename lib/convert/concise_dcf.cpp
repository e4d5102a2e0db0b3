#include "convert/concise_dcf.hpp"

#include <array>

#include "dictionary/data_types.hpp"

namespace cgw::convert {
namespace {

using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Value;
using dictionary::Variable;
using object::Access;

constexpr std::uint32_t not_downloaded = 1;  // bit of ObjFlags
constexpr std::uint64_t pdo_off = 0x80000000;
constexpr std::uint8_t cob_id_sub = 1;

// Where the parameters of PDOs stand: `mapping` is as far from the first as the other is.
struct PdoArea {
    std::uint16_t communication;
    std::uint16_t mapping;
};
constexpr std::array pdo_areas{PdoArea{0x1400, 0x1600}, PdoArea{0x1800, 0x1A00}};
constexpr std::uint16_t most_pdos = 0x200;

bool can_be_written(const Variable& variable) {
    return variable.access != Access::ro && variable.access != Access::constant &&
           (variable.flags & not_downloaded) == 0 &&
           dictionary::row_of(variable.type).kind != dictionary::TypeKind::structure;
}

class Downloads {
  public:
    Downloads(const Dictionary& configuration, std::uint8_t node_id)
        : configuration_(configuration), node_id_(node_id) {}

    std::vector<Download> take() {
        for (const Object& object : configuration_.objects) {
            const PdoArea* const of_communication = area_of(object.index, &PdoArea::communication);
            const PdoArea* const of_mapping = area_of(object.index, &PdoArea::mapping);
            if (of_communication != nullptr) {
                add_pdo(object, *of_communication);
            } else if (of_mapping != nullptr && communication_of(object.index, *of_mapping) != nullptr) {
                continue;  // with its communication parameters
            } else {
                add_changed(object);
            }
        }
        return std::move(downloads_);
    }

  private:
    static const PdoArea* area_of(std::uint16_t index, std::uint16_t PdoArea::*begin) {
        for (const PdoArea& area : pdo_areas) {
            if (index >= area.*begin && index < area.*begin + most_pdos) {
                return &area;
            }
        }
        return nullptr;
    }

    const Object* communication_of(std::uint16_t mapping, const PdoArea& area) const {
        return configuration_.find(static_cast<std::uint16_t>(mapping - area.mapping + area.communication));
    }

    Value resolved(const Value& value) const { return {value.resolve(node_id_), false, value.bytes}; }

    // What the node is to hold; nothing where the configuration does not say.
    std::optional<Value> target(const Variable& variable) const {
        if (variable.parameter_value) {
            return resolved(*variable.parameter_value);
        }
        return variable.no_default ? std::nullopt : std::optional(resolved(variable.default_value));
    }

    bool is_changed(const Variable& variable) const {
        return can_be_written(variable) && variable.parameter_value &&
               (variable.no_default ||
                !(resolved(*variable.parameter_value) == resolved(variable.default_value)));
    }

    bool is_changed(const Object& object) const {
        for (const Variable& variable : object.variables) {
            if (is_changed(variable)) {
                return true;
            }
        }
        return false;
    }

    void add(const Object& object, const Variable& variable, const Value& value) {
        Download& download = downloads_.emplace_back();
        download.index = object.index;
        download.sub_index = variable.sub_index;
        const dictionary::TypeRow& type = dictionary::row_of(variable.type);
        if (!dictionary::is_numeric(type.kind)) {
            download.data = base::to_bytes(value.bytes);
            return;
        }
        for (unsigned bit = 0; bit < type.bits; bit += 8) {
            download.data.push_back(static_cast<std::uint8_t>(value.number >> bit));
        }
    }

    void add_changed(const Object& object, const Variable* but = nullptr) {
        for (const Variable& variable : object.variables) {
            if (&variable != but && is_changed(variable)) {
                add(object, variable, resolved(*variable.parameter_value));
            }
        }
    }

    void add_pdo(const Object& communication, const PdoArea& area) {
        const Object* const mapping = configuration_.find(
            static_cast<std::uint16_t>(communication.index - area.communication + area.mapping));
        const bool mapping_changes = mapping != nullptr && is_changed(*mapping);
        if (!mapping_changes && !is_changed(communication)) {
            return;
        }
        const Variable* const cob_id = communication.find(cob_id_sub);
        const std::optional<Value> identifier =
            cob_id != nullptr && can_be_written(*cob_id) ? target(*cob_id) : std::nullopt;
        if (identifier) {
            add(communication, *cob_id, {identifier->number | pdo_off});
        }
        if (mapping_changes) {
            add_mapping(*mapping);
        }
        add_changed(communication, cob_id);
        if (identifier && (identifier->number & pdo_off) == 0) {
            add(communication, *cob_id, *identifier);
        }
    }

    void add_mapping(const Object& mapping) {
        const Variable* const count = mapping.find(0);
        const std::optional<Value> mapped =
            count != nullptr && can_be_written(*count) ? target(*count) : std::nullopt;
        if (!mapped) {
            add_changed(mapping);
            return;
        }
        add(mapping, *count, {});
        for (const Variable& variable : mapping.variables) {
            const std::optional<Value> entry = target(variable);
            if (&variable != count && variable.sub_index <= mapped->number && entry &&
                can_be_written(variable)) {
                add(mapping, variable, *entry);
            }
        }
        if (mapped->number != 0) {
            add(mapping, *count, *mapped);
        }
    }

    const Dictionary& configuration_;
    std::uint8_t node_id_;
    std::vector<Download> downloads_;
};

void append(base::Bytes& to, std::uint64_t number, unsigned bytes) {
    for (unsigned i = 0; i < bytes; ++i) {
        to.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
    }
}

}  // namespace

std::vector<Download> downloads(const Dictionary& configuration, std::uint8_t node_id) {
    return Downloads(configuration, node_id).take();
}

base::Bytes concise_dcf(const std::vector<Download>& downloads) {
    base::Bytes bytes;
    append(bytes, downloads.size(), 4);
    for (const Download& download : downloads) {
        append(bytes, download.index, 2);
        append(bytes, download.sub_index, 1);
        append(bytes, download.data.size(), 4);
        bytes.insert(bytes.end(), download.data.begin(), download.data.end());
    }
    return bytes;
}

bool is_without_entries(const base::Bytes& concise_dcf) {
    constexpr std::size_t of_count = 4;
    return concise_dcf.size() == of_count;
}

}  // namespace cgw::convert
