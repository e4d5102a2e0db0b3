// Inside the room explain: the Gateway's objects with their names and types, whatever a configuration uses.
#pragma once

#include <cstdint>

#include "config/numbers.hpp"
#include "dictionary/dictionary.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::explain {

class DeviceObjects {
  public:
    explicit DeviceObjects(const parameter::Catalogue& catalogue);

    const dictionary::Object* find(std::uint16_t index) const { return dictionary_.find(index); }

    // Entries of 2001h and 2002h exist as far as a configuration fills them; up to 52 can (D24).
    bool has(std::uint16_t index, std::uint8_t sub) const {
        const bool output =
            index == config::object::unsigned_outputs || index == config::object::signed_outputs;
        return output ? sub <= facts::maximum_outputs : dictionary_.find(index, sub) != nullptr;
    }

  private:
    dictionary::Dictionary dictionary_;
};

}  // namespace cgw::explain
