#include "emit/node_file.hpp"

#include <fmt/format.h>

#include "dictionary/node.hpp"
#include "facts/communication.hpp"

namespace cgw::emit {
namespace {

using facts::object::identity;
using facts::object::serial_number_sub;

constexpr std::uint32_t bits_per_kbit = 1000;
constexpr std::string_view bit_rate_not_known =
    "Baudrate is left out: the bit timing is set by hand (4426 = 1), and the parameter file states no "
    "clock (bit_timing.can2) to compute the rate from";
constexpr std::string_view identity_not_known =
    "1018h:3 and 1018h:4 are 0 because the parameter file states no identity";

// The key holds whole kbit/s only; another rate, or none, is told in a comment.
void state_bit_rate(const Plant& plant, dictionary::Commissioning& node, dictionary::Dictionary& dictionary) {
    const std::optional<std::uint32_t> rate =
        config::bit_rate(plant.configuration.can2, plant.settings.can2_bit_timing);
    if (!rate) {
        dictionary.comments.emplace_back(bit_rate_not_known);
    } else if (*rate % bits_per_kbit != 0) {
        dictionary.comments.push_back(
            fmt::format("Baudrate is left out: the bit timing set by hand (4426 = 1) makes {} bit/s, no "
                        "whole number of kbit/s",
                        *rate));
    } else {
        node.bit_rate_kbit = *rate / bits_per_kbit;
    }
}

bool states_identity(const parameter::Identity& identity_of_device) {
    return identity_of_device.software_version != 0 || identity_of_device.serial_date != 0 ||
           identity_of_device.serial_number != 0;
}

}  // namespace

NodeFile node_file(const Plant& plant, const Options& options, std::string file_name) {
    dictionary::Dictionary dictionary = plant.dictionary;
    dictionary.file.file_name = std::move(file_name);
    dictionary::Commissioning node;
    node.last_eds = options.eds_name;
    node.node_id = plant.configuration.node_id;
    node.node_name = plant.settings.title.empty() ? dictionary.device.product_name : plant.settings.title;
    const dictionary::Variable* const serial = dictionary.find(identity, serial_number_sub);
    node.serial_number = serial != nullptr ? static_cast<std::uint32_t>(serial->default_value.number) : 0;
    state_bit_rate(plant, node, dictionary);
    if (!states_identity(plant.configuration.identity)) {
        dictionary.comments.emplace_back(identity_not_known);
    }
    return {dictionary::of_node(std::move(dictionary), node.node_id), std::move(node)};
}

}  // namespace cgw::emit
