// What becomes of the words themselves: engineering units, and what SDO readers get.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "compare/consequences.hpp"

namespace cgw::compare {
namespace {

using parameter::Row;

struct CarriedWord {
    std::string place;  // "TPDO5 word 3"
    const Row* row = nullptr;
};

using CarriedWords = std::map<std::uint16_t, CarriedWord>;  // by number; the first place of each

CarriedWords words_of(const config::Configuration& configuration) {
    CarriedWords words;
    for (const config::AnalogueOutput& output : configuration.analogue_outputs) {
        words.try_emplace(
            output.parameter->number,
            CarriedWord{fmt::format("TPDO{} word {}", output.tpdo, output.word), output.parameter});
    }
    for (const config::Sensor& sensor : configuration.sensors) {
        words.try_emplace(sensor.row->number, CarriedWord{channel_word_text(sensor.channel), sensor.row});
    }
    return words;
}

bool same_words(const Row& a, const Row& b) {
    const bool same_range = !a.scaling || !b.scaling ||
                            (a.scaling->internal_minimum == b.scaling->internal_minimum &&
                             a.scaling->internal_maximum == b.scaling->internal_maximum);
    return a.is_signed == b.is_signed && same_range;
}

// "500..1200 mbar", with "for 0..65535, unsigned" where the words themselves differ.
std::string scaling_text(const Side& side, const Row& row, bool with_words) {
    const auto limits = parameter::external_limits(row, side.settings.governor);
    std::string text = "not known";
    if (limits) {
        text = fmt::format("{}..{}{}{}", base::to_text(limits->minimum), base::to_text(limits->maximum),
                           row.unit.empty() ? "" : " ", row.unit);
    }
    if (with_words && limits) {
        text += fmt::format(" for {}..{}", row.scaling->internal_minimum, row.scaling->internal_maximum);
    }
    return with_words ? text + (row.is_signed ? ", signed" : ", unsigned") : text;
}

using Objects = std::map<std::pair<std::uint16_t, std::uint8_t>, const Row*>;  // by index and sub-index

Objects objects_of(const config::Configuration& configuration) {
    Objects objects;
    for (const config::AnalogueOutput& output : configuration.analogue_outputs) {
        objects[{output.index, output.sub_index}] = output.parameter;
    }
    return objects;
}

}  // namespace

void compare_scalings(const Side& a, const Side& b, Differences& differences) {
    const CarriedWords before = words_of(a.configuration);
    for (const auto& [number, word] : words_of(b.configuration)) {
        const auto found = before.find(number);
        if (found == before.end()) {
            continue;
        }
        const Row& row_a = config::scaling_row(*found->second.row, a.catalogue);
        const Row& row_b = config::scaling_row(*word.row, b.catalogue);
        const bool with_words = !same_words(row_a, row_b);
        note(differences, "scaling", fmt::format("{} {}", word.place, parameter::label(*word.row)),
             scaling_text(a, row_a, with_words), scaling_text(b, row_b, with_words));
    }
}

// What is only new disturbs no reader.
void compare_objects(const config::Configuration& a, const config::Configuration& b,
                     Differences& differences) {
    const Objects now = objects_of(b);
    for (const auto& [place, row] : objects_of(a)) {
        const auto found = now.find(place);
        if (found == now.end() || found->second->number != row->number) {
            note(differences, "object", base::object_text(place.first, place.second), parameter::label(*row),
                 found != now.end() ? parameter::label(*found->second) : "nothing");
        }
    }
}

}  // namespace cgw::compare
