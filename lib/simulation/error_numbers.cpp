#include "simulation/error_numbers.hpp"

namespace cgw::simulation {

std::vector<std::uint16_t> error_numbers(std::uint16_t canopen_errors,
                                         const std::array<std::uint16_t, facts::error_words>& words) {
    std::vector<std::uint16_t> numbers;
    const auto append = [&numbers](unsigned word, unsigned first) {
        for (unsigned bit = 0; bit < facts::word_bits; ++bit) {
            if (((word >> bit) & 1U) != 0) {
                numbers.push_back(static_cast<std::uint16_t>(first + bit));
            }
        }
    };
    append(canopen_errors, facts::first_canopen_error);
    for (unsigned i = 0; i < words.size(); ++i) {
        append(words[i], facts::error_number(i * facts::word_bits));
    }
    return numbers;
}

}  // namespace cgw::simulation
