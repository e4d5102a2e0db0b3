// The CANopen Gateway (manual, chapters 3 to 6), built from a configuration image. It sits between the
// governor link and the CANopen bus CAN2, moves words and never scales them. One caller at a time; no heap.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "canopen/slave.hpp"
#include "device/governor_link.hpp"
#include "frame/frame.hpp"
#include "image/image.hpp"
#include "object/object_table.hpp"

namespace cgw::device {

enum class OpenStatus : std::uint8_t {
    ok = 0,
    values_too_large = 1,  // the image's value block exceeds Gateway::value_capacity
    object_missing = 2,    // 1001h, 2000h:1..6 or 2005h, which the gateway itself writes
};

std::string_view to_text(OpenStatus status);

class Gateway {
  public:
    static constexpr std::size_t value_capacity = 1024;  // bytes; a full configuration needs about 760

    Gateway(frame::FramePort& can2, GovernorLink& governor) : governor_(&governor), slave_(can2) {}
    Gateway(const Gateway&) = delete;
    Gateway& operator=(const Gateway&) = delete;
    ~Gateway() = default;

    // Takes a valid image, whose bytes outlive the gateway, and starts in Undefined. On anything but ok the
    // gateway is Undefined and deaf.
    OpenStatus open(const image::Image& image);

    GatewayState state() const { return state_; }

    // From the governor. Undefined and Init are obeyed in every state, Pre-Operational ends an initialisation
    // and is ignored outside Init.
    void command(GovernorCommand command, canopen::Time now);
    // Once per governor main cycle, the rhythm of all transmit PDOs.
    void main_cycle(const GovernorData& data, canopen::Time now);

    // From CAN2.
    void receive(const frame::Frame& frame, canopen::Time now);

    // See canopen::Slave::poll.
    canopen::Time poll(canopen::Time now) { return slave_.poll(now); }
    bool pending() const { return slave_.pending(); }

    const canopen::Slave& slave() const { return slave_; }
    std::span<const std::uint8_t> values() const { return {values_.data(), initial_values_.size()}; }

  private:
    static constexpr std::size_t transmit_pdos = facts::tpdo_count;
    static constexpr std::size_t receive_pdos = facts::rpdo_count;
    static constexpr std::size_t binary_pdos = facts::binary_tpdos;  // TPDO1..3, on change
    static constexpr std::size_t pdos = transmit_pdos + receive_pdos;

    // The objects the gateway writes, found once.
    struct Places {
        object::ObjectEntry error_register;
        std::array<object::ObjectEntry, error_words> errors;
        object::ObjectEntry engine_state;
        bool has_engine_state = false;
        object::ObjectEntry canopen_errors;
    };

    // One analogue transmit PDO's rhythm, in governor main cycles.
    struct Rhythm {
        std::uint16_t cycles = 0;
        std::uint16_t left = 0;
    };

    bool find_places();
    void resolve(std::size_t position, const image::Pdo& pdo);
    canopen::MappedValue place_of(const image::MappedObject& mapped) const;
    void configure(const image::Image& image);
    void initialise(GatewayState state);
    void enter(GatewayState state);
    void follow_slave(canopen::Time now);
    void store(const GovernorData& data);
    void store_analogue(std::size_t position, const PdoWords& words);
    void set(const object::ObjectEntry& entry, std::uint32_t value);
    std::uint32_t get(const object::ObjectEntry& entry) const;
    void request_transmit_pdos();
    void forward(std::size_t rpdo_row);

    GovernorLink* governor_;
    canopen::Slave slave_;
    GatewayState state_ = GatewayState::undefined;
    bool open_ = false;
    object::ObjectTable objects_;
    std::span<const std::uint8_t> initial_values_;
    Places places_;
    std::array<std::uint8_t, value_capacity> values_{};
    std::array<canopen::MappedValue, pdos * words_per_pdo> mapping_{};
    std::array<canopen::PdoRow, pdos> rows_{};  // TPDO1..16, RPDO1..4, as in the image
    std::array<canopen::TransmitState, transmit_pdos> transmit_states_{};
    std::array<Rhythm, transmit_pdos> rhythms_{};
};

}  // namespace cgw::device
