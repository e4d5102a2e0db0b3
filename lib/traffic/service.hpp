// Whose identifier it is: PDOs of the plant first, then CiA 301's predefined connection set.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "traffic/subject.hpp"

namespace cgw::traffic {

enum class Service : std::uint8_t {
    nmt,
    sync,
    time,
    emergency,
    pdo,        // of the plant
    other_pdo,  // default PDO of some other node
    sdo_request,
    sdo_answer,
    heartbeat,  // boot-up, heartbeat and node guarding
    lss,
    unknown,
};

// "nmt", "sdo-request", …
std::string_view to_text(Service service);

struct Owner {
    Service service = Service::unknown;
    std::uint8_t node = 0;                  // 0: none
    const signals::Frame* frame = nullptr;  // of a PDO of the plant
    bool expected = false;                  // the plant and the nodes it names have this on their bus
};

// Whose each of the 2048 identifiers of 11 bits is.
class Owners {
  public:
    // Refers to the subject, which outlives it.
    explicit Owners(const Subject& subject);

    const Owner& of(std::uint32_t identifier) const { return owners_[identifier % owners_.size()]; }

  private:
    std::array<Owner, 2048> owners_{};
};

// For people: "TPDO1", "NMT", "SDO", "EMCY", "PDO", "HB", "SYNC", "TIME", "LSS", "?"
std::string name_of(const Owner& owner);

// What the predefined connection set has the identifier for: "TPDO1 of node 5", "NMT"; "" for nothing.
std::string default_use(std::uint32_t identifier);

}  // namespace cgw::traffic
