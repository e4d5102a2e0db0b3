// The PDO table: activity, times, identifiers, and what every word maps.
#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"
#include "image/verify.hpp"

namespace cgw::image {
namespace {

std::uint16_t predefined_identifier(const Pdo& pdo, std::uint8_t node) {
    const auto& bases = pdo.receive ? facts::cob::rpdo : facts::cob::tpdo;
    return static_cast<std::uint16_t>(bases[pdo.number - 1U] + node);
}

bool position_fits(const Pdo& pdo, std::size_t position, std::uint8_t direction) {
    const bool receive = position >= facts::tpdo_count;
    const std::size_t number = (receive ? position - facts::tpdo_count : position) + 1;
    return direction == (receive ? 1 : 0) && pdo.number == number;
}

// D8, and 0 where there is no cycle to set.
bool time_fits(const Pdo& pdo, std::uint32_t main_cycle_us) {
    if (!pdo.receive && pdo.number <= facts::binary_tpdos) {
        return pdo.asked_ms == 0 && pdo.cycles == 0 && pdo.effective_us == 0;
    }
    const std::uint32_t cycles = facts::whole_cycles(pdo.asked_ms, main_cycle_us);
    return pdo.cycles == cycles && pdo.effective_us == static_cast<std::uint64_t>(cycles) * main_cycle_us;
}

bool activity_fits(const Pdo& pdo, const Governor& governor) {
    if (pdo.active != (pdo.word_count != 0)) {
        return false;
    }
    if (pdo.receive) {
        return true;
    }
    if (pdo.number <= facts::binary_tpdos) {
        return pdo.active ==
               (pdo.number == facts::binary_tpdos ? governor.send_status : governor.send_errors);
    }
    return !pdo.active || pdo.cycles != 0;
}

bool source_fits(const Pdo& pdo, std::uint8_t source, std::uint8_t node) {
    const bool predefined = pdo.number <= facts::predefined_pdos;
    return source == (predefined ? 0 : 1) && (!predefined || pdo.cob_id == predefined_identifier(pdo, node));
}

bool is_reserved(std::uint16_t identifier, const Bus& can2) {
    namespace cob = facts::cob;
    const auto own = [&](std::uint16_t base) { return static_cast<std::uint16_t>(base + can2.own_node); };
    const std::uint16_t reserved[] = {
        cob::nmt, cob::sync, cob::time, own(cob::sdo_answer), own(cob::sdo_request), own(cob::heartbeat)};
    for (const std::uint16_t value : reserved) {
        if (identifier == value) {
            return true;
        }
    }
    return can2.peer_node != 0 && identifier == cob::heartbeat + can2.peer_node;
}

// A value travelling out is read, one coming in is written.
bool access_fits(object::Access access, bool receive) {
    using object::Access;
    if (receive) {
        return access == Access::rww || access == Access::rw || access == Access::wo;
    }
    return access == Access::ro || access == Access::rwr || access == Access::rw ||
           access == Access::constant;
}

bool word_fits(const object::ObjectTable& objects, const Pdo& pdo, const MappedObject& word) {
    if (word.bits != facts::word_bits) {
        return false;
    }
    if (word.index == facts::object::unsigned16_dummy) {
        return pdo.receive && word.sub_index == 0 && word.parameter == 0;
    }
    const object::ObjectTable::Lookup lookup = objects.find(word.index, word.sub_index);
    return lookup.found == object::Found::yes && lookup.entry.length * 8U == word.bits &&
           (lookup.entry.flags & object::flag_pdo_mappable) != 0 &&
           access_fits(lookup.entry.access, pdo.receive);
}

bool is_unused(const MappedObject& word) {
    return word.index == 0 && word.sub_index == 0 && word.bits == 0 && word.parameter == 0;
}

}  // namespace

bool pdos_fit(const Image& image) {
    const Governor governor = image.governor();
    const std::uint8_t node = image.can2().own_node;
    for (std::size_t i = 0; i < pdo::count; ++i) {
        const Pdo pdo = image.pdo(i);
        const std::uint8_t* record = image.records(SectionId::pdos).at(i);
        if (!position_fits(pdo, i, record[pdo::direction]) ||
            !source_fits(pdo, record[pdo::cob_id_source], node) || !time_fits(pdo, governor.main_cycle_us) ||
            !activity_fits(pdo, governor)) {
            return false;
        }
    }
    return true;
}

bool mappings_fit(const Image& image) {
    const object::ObjectTable objects = image.objects();
    for (std::size_t i = 0; i < pdo::count; ++i) {
        const Pdo pdo = image.pdo(i);
        for (std::size_t word = 0; word < pdo.mapping.size(); ++word) {
            const MappedObject& mapped = pdo.mapping[word];
            if (word < pdo.word_count ? !word_fits(objects, pdo, mapped) : !is_unused(mapped)) {
                return false;
            }
        }
    }
    return true;
}

bool identifiers_fit(const Image& image) {
    const Bus can2 = image.can2();
    for (std::size_t i = 0; i < pdo::count; ++i) {
        const Pdo pdo = image.pdo(i);
        if (!pdo.active) {
            continue;
        }
        if (is_reserved(pdo.cob_id, can2)) {
            return false;
        }
        for (std::size_t other = 0; other < i; ++other) {
            const Pdo earlier = image.pdo(other);
            if (earlier.active && earlier.cob_id == pdo.cob_id) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace cgw::image
