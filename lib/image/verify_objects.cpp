// The object table and its value block.
#include "image/verify.hpp"

namespace cgw::image {
namespace {

constexpr std::uint8_t value_sizes[] = {4, 2, 1};  // the order of the value block

constexpr unsigned known_flags = object::flag_pdo_mappable | object::flag_sdo_read_only;

bool records_fit(const object::ObjectTable& table) {
    std::uint32_t last_key = 0;  // indices begin at 1000h
    for (std::size_t i = 0; i < table.size(); ++i) {
        const object::ObjectEntry entry = table.entry(i);
        const std::uint32_t key = (static_cast<std::uint32_t>(entry.index) << 8) | entry.sub_index;
        if (key <= last_key || entry.length == 0 || entry.access > object::Access::constant ||
            entry.flags > known_flags) {
            return false;
        }
        last_key = key;
    }
    return table.size() != 0;
}

// Every value where the layout puts it, so that none overlaps another and each is aligned to its size.
std::size_t values_end(const object::ObjectTable& table, bool& placed) {
    std::size_t offset = 0;
    for (const std::uint8_t size : value_sizes) {
        for (std::size_t i = 0; i < table.size(); ++i) {
            const object::ObjectEntry entry = table.entry(i);
            if (entry.length == size) {
                placed = placed && entry.offset == offset;
                offset += size;
            }
        }
    }
    return offset;
}

}  // namespace

bool objects_fit(const Image& image) {
    const object::ObjectTable table = image.objects();
    if (!records_fit(table)) {
        return false;
    }
    bool placed = true;
    const std::size_t end = values_end(table, placed);
    const std::size_t size = image.initial_values().size();
    return placed && (size == end || (size > end && !is_known_minor(image)));
}

}  // namespace cgw::image
