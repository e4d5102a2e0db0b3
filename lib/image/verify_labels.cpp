// Labels: texts that are safe to show, numbers that are numbers.
#include "image/bytes.hpp"
#include "image/verify.hpp"

namespace cgw::image {
namespace {

struct Utf8Form {
    std::uint8_t mask, lead;     // of the first byte
    std::uint8_t continuations;  // bytes that follow
    std::uint32_t minimum;       // smaller code points are overlong
};

constexpr Utf8Form utf8_forms[] = {
    {0x80, 0x00, 0, 0x0}, {0xE0, 0xC0, 1, 0x80}, {0xF0, 0xE0, 2, 0x800}, {0xF8, 0xF0, 3, 0x10000}};

bool is_printable(std::uint32_t code_point) {
    const bool control = code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
    const bool surrogate = code_point >= 0xD800 && code_point < 0xE000;
    return !control && !surrogate && code_point <= 0x10FFFF;
}

// Bytes that the character at text[0] takes; 0 when it is not well-formed or not printable.
std::size_t character_size(std::span<const std::uint8_t> text) {
    for (const Utf8Form& form : utf8_forms) {
        if ((text[0] & form.mask) != form.lead) {
            continue;
        }
        if (text.size() <= form.continuations) {
            return 0;
        }
        std::uint32_t code_point = text[0] & static_cast<std::uint8_t>(~form.mask);
        for (std::size_t i = 1; i <= form.continuations; ++i) {
            if ((text[i] & 0xC0U) != 0x80U) {
                return 0;
            }
            code_point = (code_point << 6) | (text[i] & 0x3FU);
        }
        return code_point >= form.minimum && is_printable(code_point) ? 1U + form.continuations : 0;
    }
    return 0;
}

bool text_fits(const Records& strings, std::uint32_t offset, std::uint8_t length) {
    if (offset > strings.size || length > strings.size - offset) {
        return false;
    }
    std::span<const std::uint8_t> text(strings.data + offset, length);
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        if (size == 0) {
            return false;
        }
        text = text.subspan(size);
    }
    return true;
}

// Numbers are looked at as the bits of a double, since firmware has better things to do than to calculate
// with them.
bool is_finite(std::uint64_t bits) {
    return ((bits >> 52) & 0x7FFU) != 0x7FFU;
}

bool same_number(std::uint64_t a, std::uint64_t b) {
    const bool both_zero = ((a | b) << 1) == 0;  // of either sign
    return a == b || both_zero;
}

bool scaling_fits(const Image& image, const std::uint8_t* record) {
    const std::uint64_t minimum = load_u64(record + label::external_minimum);
    const std::uint64_t maximum = load_u64(record + label::external_maximum);
    if (record[label::has_scaling] == 0) {
        return minimum == 0 && maximum == 0;
    }
    Signal signal;
    return is_finite(minimum) && is_finite(maximum) && !same_number(minimum, maximum) &&
           image.find_signal(wire::load_u16(record + label::number), signal);
}

}  // namespace

bool labels_fit(const Image& image) {
    const Records& labels = image.records(SectionId::labels);
    const Records& strings = image.records(SectionId::strings);
    for (std::size_t i = 0; i < labels.count(); ++i) {
        const std::uint8_t* record = labels.at(i);
        if (!text_fits(strings, wire::load_u32(record + label::name_offset), record[label::name_length]) ||
            !text_fits(strings, wire::load_u32(record + label::unit_offset), record[label::unit_length]) ||
            !scaling_fits(image, record)) {
            return false;
        }
    }
    return true;
}

}  // namespace cgw::image
