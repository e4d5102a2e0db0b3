// Dictionaries of devices that nobody built, for round trips: everything that the model can hold and a file
// can say, in texts that every format takes. The same for the same seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "dictionary/data_types.hpp"
#include "dictionary/dictionary.hpp"

namespace cgw::test {

class RandomDictionary {
  public:
    explicit RandomDictionary(std::uint32_t seed) : random_(seed) {}

    dictionary::Dictionary dictionary();
    dictionary::Commissioning commissioning();

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  private:
    bool often() { return below(4) != 0; }
    bool rarely() { return below(6) == 0; }
    std::uint64_t number(unsigned bits);
    std::string text(std::uint32_t longest = 24);
    std::string date();
    std::string time();
    dictionary::Value value(const dictionary::TypeRow& type);
    dictionary::Variable variable(std::uint8_t sub_index, object::ObjectCode code);
    dictionary::Object object(std::uint16_t index);
    std::vector<dictionary::Object> objects(std::uint32_t most);
    dictionary::Module module(std::uint8_t number);

    std::mt19937_64 random_;
};

}  // namespace cgw::test
