// What one parameter file says, before anything is concluded from it: both parameter sets with the
// place of every value.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bit_timing/controller.hpp"
#include "diagnostic/location.hpp"
#include "facts/gateway.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/row.hpp"

namespace cgw::parameter {

struct Assignment {
    const Row* row = nullptr;
    double value = 0;            // engineering units, as typed
    bool decimal_typed = false;  // an integer without 0x, 0o or 0b (D15)
    std::string spelling{};      // the key as written
    diagnostic::Location key{};
    diagnostic::Location where{};  // of the value
};

// The assigned parameters of one device; what is not assigned is 0 (off).
class ParameterSet {
  public:
    // False, and nothing changed, when the number is assigned already.
    bool assign(Assignment assignment);

    const Assignment* find(std::uint16_t number) const;
    double value(std::uint16_t number) const;           // 0 when not assigned
    std::uint32_t integer(std::uint16_t number) const;  // value() as an integer; 0 for a negative one
    const std::map<std::uint16_t, Assignment>& all() const { return assigned_; }

    // The file means to set this number, but its name or value is wrong and a finding says so already:
    // whoever looks for absent parameters stays silent about it.
    void reject(std::uint16_t number) { rejected_.insert(number); }
    bool rejected(std::uint16_t number) const { return rejected_.contains(number); }

  private:
    std::map<std::uint16_t, Assignment> assigned_;
    std::set<std::uint16_t> rejected_;
};

// The engineering values that belong to the internal limits of a scaling.
struct ExternalLimits {
    double minimum = 0;
    double maximum = 0;
};

// From the row's constants or from the reference parameters it names (978..995); nullopt when a limit is not
// known: no scaling, a blank cell, limits that do not differ, or a highest reference parameter that is 0. A
// reference parameter that is not set is 0, as every parameter (D49).
std::optional<ExternalLimits> external_limits(const Row& row, const ParameterSet& references);

struct Date {
    int year = 2004;
    int month = 5;
    int day = 19;

    friend auto operator<=>(const Date&, const Date&) = default;
};

struct DocumentInformation {
    std::optional<Date> created{};
    std::string author{};
    std::uint32_t revision = 0;  // 0..255: EDS FileRevision is an UNSIGNED8
};

// 1018h:3 and :4 (D32); zero where the file says nothing.
struct Identity {
    std::uint32_t software_version = 0;  // 3842, 0..65535
    std::uint32_t serial_date = 0;       // 3844, 0..9912
    std::uint32_t serial_number = 0;     // 3845, 0..65535
};

struct BitTiming {
    std::uint32_t clock_hz = 0;
    const bit_timing::Controller* controller = nullptr;  // never null in what was read
    diagnostic::Location where{};
};

struct NetworkNode {
    std::uint8_t node_id = 0;
    diagnostic::Location where{};
};

// A message of another node, as [[network.message]] states it.
struct NetworkMessage {
    std::uint16_t identifier = 0;   // 0..0x7FF
    std::uint8_t bytes = 8;         // 0..8
    std::uint64_t period_us = 0;    // above 0
    std::uint64_t jitter_us = 0;    // how late it may be
    std::uint64_t deadline_us = 0;  // 0: none
    std::string name{};
    diagnostic::Location where{};
};

// Bytes of a title: with room for what an EDS adds in its Description of 243 bytes.
inline constexpr std::size_t longest_title = 200;

struct Settings {
    std::string path{};
    std::string title{};
    DocumentInformation document{};
    std::uint32_t main_cycle_us = facts::usual_governor_main_cycle_us;  // governor main cycle (D8)
    Identity identity{};
    std::optional<BitTiming> can1_bit_timing{};
    std::optional<BitTiming> can2_bit_timing{};
    std::vector<NetworkNode> network_nodes{};
    std::vector<NetworkMessage> network_messages{};
    ParameterSet governor{};
    ParameterSet gateway{};
    diagnostic::Location governor_table{};  // the [governor.parameters] header, for what is missing there
    diagnostic::Location gateway_table{};
    // Rows of [[governor.declare]] and of the file's own catalogues (Catalogue::added()): they decide width
    // and sign of what is sent, so they belong to the configuration id.
    std::vector<const Row*> declarations{};

    const ParameterSet& of(Device device) const { return device == Device::governor ? governor : gateway; }
};

// The canonical model as text, one fact a line, each line ended by LF:
//   cgw-configuration 1
//   title "Genset 2"                               JSON string
//   identity 12 407 12                             software version, serial date, serial number
//   main-cycle-us 15625
//   row governor 2990 "TorqueActual" measurement 16 signed "%" -32768..32767 -100..100
//                                                  a declared row: list, role when it has one, width, sign,
//                                                  unit, internal and external limits ("@980" is a reference
//                                                  parameter,
//                                                  "?" is blank); by device and number, each once; none of
//                                                  a bootloader
//   governor 401 1                                 every value that is not 0, by device and number
// Order, comments and spelling of the file do not matter; neither do author, date and texts.
std::string canonical_text(const Settings& settings);

// SHA-256 of the canonical text. It guards against accidents, not against tampering.
std::array<std::uint8_t, 32> configuration_id(const Settings& settings);

}  // namespace cgw::parameter
