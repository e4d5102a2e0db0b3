// Parameter files made at random from the shipped catalogue: careful ones that mostly check clean, and
// careless ones with anything in range and a little out of it. The same seed gives the same plant everywhere.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "parameter/catalogue.hpp"

namespace cgw::test {

// std::uniform_int_distribution differs between libraries; this does not.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(engine_() % limit); }
    bool one_in(std::uint32_t n) { return below(n) == 0; }
    std::int64_t between(std::int64_t lowest, std::int64_t highest);

    template <typename T>
    const T& pick(const std::vector<T>& from) {
        return from[below(static_cast<std::uint32_t>(from.size()))];
    }
    template <typename T>
    void shuffle(std::vector<T>& all) {
        for (std::size_t i = all.size(); i > 1; --i) {
            std::swap(all[i - 1], all[below(static_cast<std::uint32_t>(i))]);
        }
    }

  private:
    std::mt19937 engine_;
};

// Where the identifiers of TPDO5..16 come from.
enum class Identifiers : std::uint8_t { free_pool, follow_node };

class RandomPlant {
  public:
    RandomPlant(std::uint32_t seed, bool careful, Identifiers identifiers = Identifiers::free_pool);

    // As a parameter file. `order` shuffles tables, lines, spelling of keys, lists and listed nodes; 0: as
    // they came, one number a line.
    std::string text(std::uint32_t order = 0) const;

  private:
    using Values = std::map<std::uint16_t, std::string>;  // value as typed, by number

    void required();
    void outputs();
    void identifiers();
    void declare();
    bool may_be_active(unsigned tpdo);
    void inputs();
    void anything();
    std::string value_in_range(const parameter::Row& row);
    std::vector<std::string> lines(parameter::Device device, const Values& values, std::uint32_t order,
                                   Dice& dice) const;
    void set(parameter::Device device, unsigned number, std::int64_t value);

    Dice dice_;
    bool careful_;
    Identifiers identifiers_;
    std::int64_t node_ = 0;
    std::int64_t main_cycle_us_ = 15625;
    std::string identity_;
    std::vector<std::string> declarations_;
    std::vector<std::uint16_t> declared_;
    std::vector<unsigned> active_;  // TPDO5..16
    std::vector<int> nodes_;
    Values governor_;
    Values gateway_;
};

}  // namespace cgw::test
