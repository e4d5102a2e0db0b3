// The CANopen Gateway (manual, chapters 3 to 6), built from a configuration image. It sits between the
// governor link and the CANopen bus CAN2, moves words and never scales them. One caller at a time; no heap.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "canopen/slave.hpp"
#include "device/gateway_errors.hpp"
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
    static constexpr canopen::Time announcement_period = 500'000;  // us, while 3072 is set (D58)
    static constexpr canopen::Time governor_silence = 500'000;  // us without a word from the governor (D46)

    Gateway(frame::FramePort& can2, GovernorLink& governor) : governor_(&governor), slave_(can2) {}
    Gateway(const Gateway&) = delete;
    Gateway& operator=(const Gateway&) = delete;
    ~Gateway() = default;

    // A reset: takes a valid image, whose bytes outlive the gateway, and starts in Undefined. On anything but
    // ok the gateway shows 3090 and stays Undefined and deaf.
    OpenStatus open(const image::Image& image, canopen::Time now);

    GatewayState state() const { return status_.state; }
    const GatewayStatus& status() const { return status_; }
    const GatewayErrors& errors() const { return errors_; }
    // The permanent error memory of former runs, kept by whoever runs the gateway; once. A reset keeps it.
    void restore(const std::array<std::uint8_t, GatewayErrors::error_count>& sentinels) {
        errors_.restore(sentinels);
    }

    // A cause of an error as whoever runs the gateway sees it: the drivers of both controllers, supply and
    // memory tests, the governor link. Causes the gateway sees itself (late RPDOs, lost heartbeat, silent
    // governor, SDO overflow) are not reported from outside.
    void report(Fault fault, bool present, canopen::Time now);
    // "Clear errors", of the PC or of the governor.
    void clear_errors(canopen::Time now);

    // From the governor. Undefined and Init are obeyed in every state unless an error forbids CANopen;
    // Pre-Operational ends an initialisation and is ignored outside Init.
    void command(GovernorCommand command, canopen::Time now);
    // Once per governor main cycle, the rhythm of all transmit PDOs. `elapsed`: how many main cycles have
    // passed since the last call, more than one when data of some did not get through; at least 1.
    void main_cycle(const GovernorData& data, canopen::Time now, unsigned elapsed = 1);

    // From CAN2.
    void receive(const frame::Frame& frame, canopen::Time now);

    // Sends what is due, watches what must arrive. Returns when time alone will make something due; while
    // pending() is true, call again as soon as CAN2 has room.
    canopen::Time poll(canopen::Time now);
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

    OpenStatus take(const image::Image& image, canopen::Time now);
    bool find_places();
    void resolve(std::size_t position, const image::Pdo& pdo);
    canopen::MappedValue place_of(const image::MappedObject& mapped) const;
    void configure(const image::Image& image, canopen::Time now);
    void initialise(GatewayState state);
    void force(GatewayState state, canopen::Time now);
    void follow_slave(canopen::Time now);
    void enter_operational(canopen::Time now);
    void react(Reaction reaction, canopen::Time now);
    void forget_errors();
    void hear_governor(canopen::Time now);
    void watch_governor(canopen::Time now);
    void follow_monitors();
    std::uint8_t late_rpdos() const;
    canopen::Time announce(canopen::Time now);
    void publish(GatewayState state);
    void store_errors();
    void store(const GovernorData& data);
    void store_analogue(std::size_t position, const PdoWords& words);
    void set(const object::ObjectEntry& entry, std::uint32_t value);
    void request_transmit_pdos(unsigned elapsed);
    void forward(std::size_t rpdo_row);

    GovernorLink* governor_;
    canopen::Slave slave_;
    GatewayStatus status_;
    GatewayErrors errors_;
    std::uint8_t operational_entries_ = 0;
    std::array<std::uint16_t, error_words> governor_errors_{};
    canopen::Time start_up_end_ = 0;  // 400: nobody is missed before
    canopen::Time governor_deadline_ = canopen::never;
    canopen::Time next_announcement_ = canopen::never;
    bool open_ = false;
    object::ObjectTable objects_;
    std::span<const std::uint8_t> initial_values_;
    Places places_;
    std::array<std::uint8_t, value_capacity> values_{};
    std::array<canopen::MappedValue, pdos * words_per_pdo> mapping_{};
    std::array<canopen::PdoRow, pdos> rows_{};  // TPDO1..16, RPDO1..4, as in the image
    std::array<canopen::TransmitState, transmit_pdos> transmit_states_{};
    std::array<Rhythm, transmit_pdos> rhythms_{};
    std::array<canopen::ArrivalMonitor, receive_pdos> receive_monitors_{};
};

}  // namespace cgw::device
