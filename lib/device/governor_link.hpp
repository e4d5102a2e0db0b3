// Everything governor and gateway say to each other (D56). What travels underneath, memory or telegrams on
// CAN1, is nobody else's business.
#pragma once

#include <array>
#include <cstdint>

#include "facts/gateway.hpp"

namespace cgw::device {

// The five states of the manual's chapter 3 (D50).
enum class GatewayState : std::uint8_t { undefined, init, pre_operational, operational, stopped };

// Governor to gateway: commands of the state machine (manual, chapter 3).
enum class GovernorCommand : std::uint8_t { undefined, init, pre_operational };

using facts::analogue_tpdos;
using facts::error_words;
using facts::first_analogue_tpdo;
using facts::words_per_pdo;

using PdoWords = std::array<std::uint16_t, words_per_pdo>;

// Governor to gateway: what one main cycle of the governor delivers, as one consistent whole.
struct GovernorData {
    std::array<PdoWords, analogue_tpdos> analogue{};  // [TPDO - 4], words as sent, unused ones anything
    std::array<std::uint16_t, error_words> errors{};  // bit b of word w is error 3000 + 16 w + b (D21)
    std::uint16_t engine_state = 0;                   // 2000h:7, low byte (D22)
};

// What the governor is told whenever any of it changes: it keeps a copy of the state machine and of the
// errors.
struct GatewayStatus {
    GatewayState state = GatewayState::undefined;
    std::uint16_t canopen_errors = 0;                 // 2005h
    std::array<std::uint16_t, error_words> errors{};  // the Gateway's own share of 2000h:1..6
    std::uint8_t late_rpdos = 0;                      // bit r - 1: the monitoring of RPDO r has tripped
    bool heartbeat_lost = false;
    std::uint8_t operational_entries = 0;  // counted from the reset on, so that none goes unnoticed

    friend bool operator==(const GatewayStatus&, const GatewayStatus&) = default;
};

// Gateway to governor. Neither call may call back into the gateway.
class GovernorLink {
  public:
    virtual void status_changed(const GatewayStatus& status) = 0;
    // A receive PDO, 1..4, by word; words it does not carry, dummies included, are 0.
    virtual void process_data(std::uint8_t rpdo, const PdoWords& words) = 0;

  protected:
    ~GovernorLink() = default;
};

}  // namespace cgw::device
