// What can go wrong in and around a Gateway, how it shows and what the Gateway does about it: the manual's
// chapters 9.4 and 9.5 as a table, and the errors that are set at the moment.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "facts/gateway.hpp"

namespace cgw::device {

// A cause. Several causes may show as one error.
enum class Fault : std::uint8_t {
    governor_reset,         // 12411: the governor was reset, the gateway was not
    initialisation,         // 12412: refused three times
    receive_pdo_late,       // 12413: the monitoring of some receive PDO has tripped
    governor_can_bus,       // 12414: the governor's own 3070
    governor_can_comm,      // 12415: the governor's own 3071
    gateway_reset,          // 12419: the gateway was reset, the governor was not
    heartbeat_lost,         // 12420
    can1_bus,               // 3070, 12421: CAN1's controller, not mended by initialising it again
    can1_overflow,          // 3071, 12422: CAN1's reception or transmission buffer
    governor_silent,        // 3071, 12422: the governor does not respond
    node_number_twice,      // 3071, 12422: another device of our type has our number on CAN1
    can2_bus,               // 3072, 12423: CAN2's controller
    can2_receive_overflow,  // 3073, 12424: CANopen reception buffer
    sdo_overflow,           // 3073, 12424: SDO transmission buffer
    parameter_store,        // 3076
    program_memory,         // 3077
    working_memory,         // 3078
    supply_voltage,         // 3085
    data,                   // 3090: no valid configuration
    stack,                  // 3093
    internal,               // 3094
};
inline constexpr std::size_t fault_count = 21;

// What a fault does to the state machine when it appears.
// `interrupted`: Undefined until the governor initialises; an initialisation that has begun goes on.
enum class Reaction : std::uint8_t { none, undefined, interrupted, pre_operational, stopped };

// What makes a fault disappear once its cause is gone.
enum class Clearing : std::uint8_t {
    by_itself,
    on_request,  // clearing all errors, or entering Operational
    by_reset,    // of the Gateway
};

struct FaultRow {
    Fault fault;
    std::uint16_t error;          // 3000..3095; 0: none of the Gateway's own
    std::uint16_t canopen_error;  // 12411..12424; 0: none
    Reaction reaction;
    Clearing clearing;
};

// One row per fault, in the order of Fault.
std::span<const FaultRow, fault_count> fault_rows();
const FaultRow& row_of(Fault fault);

class GatewayErrors {
  public:
    static constexpr std::uint16_t can_open_error = 3074;  // set while 2005h is not 0
    static constexpr std::uint16_t first_error = 3070;
    static constexpr std::size_t error_count = 25;  // 3070..3094

    // The cause is there, or gone.
    void set(Fault fault, bool present);
    // Gone again at once, as an overflow is.
    void strike(Fault fault);

    // What on_request waits for. A cause that is still present stays set.
    void clear();

    bool present(Fault fault) const { return (present_ & bit(fault)) != 0; }
    bool shown(Fault fault) const { return (shown_ & bit(fault)) != 0; }
    // A cause is present, or only a reset clears it, that does not let CANopen run.
    bool blocking() const;

    std::uint16_t canopen_errors() const { return canopen_errors_; }  // 2005h (D52)
    // The Gateway's own share of 2000h:1..6 (D21).
    const std::array<std::uint16_t, facts::error_words>& words() const { return words_; }

    // How often each of 3070..3094 has appeared, at most 255: the sentinels 3170..3194, which outlive a
    // reset.
    const std::array<std::uint8_t, error_count>& sentinels() const { return sentinels_; }
    // Adds what was counted before.
    void restore(const std::array<std::uint8_t, error_count>& sentinels);
    // As after a reset: only the sentinels stay.
    void reset();

  private:
    static constexpr std::uint32_t bit(Fault fault) { return 1U << static_cast<unsigned>(fault); }
    void update();
    void count(const std::array<std::uint16_t, facts::error_words>& before);

    std::uint32_t present_ = 0;
    std::uint32_t shown_ = 0;
    std::uint16_t canopen_errors_ = 0;
    std::array<std::uint16_t, facts::error_words> words_{};
    std::array<std::uint8_t, error_count> sentinels_{};
};

}  // namespace cgw::device
