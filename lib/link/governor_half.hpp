// The governor's half of the configuration, as it travels at initialisation: a sequence of 16-bit items in a
// fixed order. Both ends make it from their own image; the gateway accepts the governor when the two are the
// same.
#pragma once

#include <cstdint>

#include "image/image.hpp"

namespace cgw::link {

enum class ItemKind : std::uint8_t {
    version,        // of this list
    governor_node,  // 401 of the governor
    gateway_node,   // 403
    send_errors,    // 14401
    send_status,    // 14402
    main_cycle,     // of the governor: microseconds, low word, then high word
    assignment,     // 16400..16451; `position`: word 0..51 over TPDO4..16
    cycles,         // of TPDO4..16 in main cycles; `position` 0..12
    monitoring,     // of RPDO1..4 in main cycles; `position` 0..3
    switches,       // their number
    switch_number,  // 8nn; `position` in the list
    switch_bit,     // 1..16, low-active ones as 101h..110h
    sensors,        // their number
    sensor_number,  // 9nn
    sensor_channel,
};

struct Item {
    ItemKind kind = ItemKind::version;
    std::uint8_t position = 0;
    std::uint16_t value = 0;
};

class GovernorHalf {
  public:
    static constexpr std::uint16_t format = 1;

    GovernorHalf() = default;
    // The image outlives it.
    explicit GovernorHalf(const image::Image& image);

    std::uint16_t count() const { return count_; }
    // `index` < count().
    Item item(std::uint16_t index) const;

  private:
    Item input_item(std::uint16_t index) const;

    const image::Image* image_ = nullptr;
    std::uint16_t count_ = 0;
    std::uint16_t switches_ = 0;
    std::uint16_t sensors_ = 0;
};

}  // namespace cgw::link
