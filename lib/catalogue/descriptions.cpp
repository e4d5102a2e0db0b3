#include <algorithm>

#include "base/ascii.hpp"
#include "catalogue/errors.hpp"
#include "catalogue/objects.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using parameter::Row;

const Row* shown_by_either(const Catalogue& catalogue, std::uint16_t number) {
    const Row* row = catalogue.find(Device::gateway, number);
    return row != nullptr ? row : catalogue.find(Device::governor, number);
}

constexpr std::uint16_t bits_per_word = 16;

}  // namespace

const ErrorDescription* find_error(Device device, Program program, std::uint16_t number) {
    for (const ErrorDescription& error : shipped_errors()) {
        const bool is_meant = error.number == number || error.counter == number;
        if (number != 0 && is_meant && error.program == program && error.shown_by(device)) {
            return &error;
        }
    }
    return nullptr;
}

const ErrorDescription* find_error(std::string_view key) {
    for (const ErrorDescription& error : shipped_errors()) {
        if (!error.key.empty() && base::equal_ignoring_case(error.key, key)) {
            return &error;
        }
    }
    return nullptr;
}

const ObjectDescription* find_object(std::uint16_t index) {
    for (const ObjectDescription& object : shipped_objects()) {
        if (object.index == index && object.whole) {
            return &object;
        }
    }
    return nullptr;
}

const ObjectDescription* find_object(std::uint16_t index, std::uint8_t sub) {
    for (const ObjectDescription& object : shipped_objects()) {
        if (object.index == index && !object.whole && sub >= object.first_sub && sub <= object.last_sub) {
            return &object;
        }
    }
    return find_object(index);
}

std::vector<parameter::NamedBit> object_bits(std::uint16_t index, std::uint8_t sub,
                                             const Catalogue& catalogue) {
    const ObjectDescription* object = find_object(index, sub);
    if (object == nullptr) {
        return {};
    }
    std::vector<parameter::NamedBit> bits(object->bits.begin(), object->bits.end());
    if (object->bit_parameter == 0) {
        return bits;
    }
    for (std::uint8_t bit = 0; bit < object->bit_count; ++bit) {
        const int number = object->bit_parameter + (sub - object->first_sub) * bits_per_word + bit;
        if (const Row* row = shown_by_either(catalogue, static_cast<std::uint16_t>(number))) {
            bits.push_back({bit, row->name, row->text});
        }
    }
    return bits;
}

std::optional<ObjectBit> find_object_bit(std::uint16_t number) {
    for (const ObjectDescription& object : shipped_objects()) {
        if (object.bit_parameter == 0 || number < object.bit_parameter) {
            continue;
        }
        const int offset = number - object.bit_parameter;
        const int sub = object.first_sub + offset / bits_per_word;
        const int bit = offset % bits_per_word;
        if (sub <= object.last_sub && bit < object.bit_count) {
            return ObjectBit{object.index, static_cast<std::uint8_t>(sub), static_cast<std::uint8_t>(bit)};
        }
    }
    return std::nullopt;
}

}  // namespace cgw::catalogue
