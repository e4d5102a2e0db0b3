#include "proof/proof.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proof/configuration_id.hpp"
#include "proof/proving.hpp"

namespace cgw::proof {
namespace {

using dictionary::Difference;

void add_if(Proof& proof, std::string_view aspect, std::string_view text, std::string a, std::string b) {
    if (a != b) {
        Difference difference{aspect, text};
        difference.a = std::move(a);
        difference.b = std::move(b);
        proof.differences.all.insert(proof.differences.all.begin(), std::move(difference));
    }
}

void compare_node(Proof& proof, const emit::Plant& plant, const dictionary::Commissioning& node) {
    const auto rate = config::bit_rate(plant.configuration.can2, plant.settings.can2_bit_timing);
    if (rate && node.bit_rate_kbit) {
        add_if(proof, "bit-rate", "bit rate, kbit/s", fmt::format("{}", *rate / 1000),
               fmt::format("{}", *node.bit_rate_kbit));
    }
    add_if(proof, "node-id", "node-ID", fmt::format("{}", plant.configuration.node_id),
           fmt::format("{}", node.node_id));
    // The gateway is a slave; whoever makes it a manager of the network means another device.
    add_if(proof, "manager", "CANopen manager", "no", node.canopen_manager ? "yes" : "no");
}

}  // namespace

void compare_id(Proof& proof, std::string_view expected, const std::string& found) {
    if (found.empty()) {
        proof.differences.not_compared.emplace_back("configuration id");
    } else {
        add_if(proof, "configuration-id", "configuration id", std::string(expected), found);
    }
}

Proof prove_description(const emit::Plant& plant, const Description& description) {
    Proof proof;
    const std::uint8_t node_id = plant.configuration.node_id;
    const dictionary::Commissioning* const node = description.commissioning;
    proof.differences = dictionary::differences(
        {.dictionary = plant.dictionary, .node_id = node_id},
        {.dictionary = description.dictionary, .node_id = node != nullptr ? node->node_id : node_id});
    if (node != nullptr) {
        compare_node(proof, plant, *node);
    }
    compare_id(proof, plant.configuration_id_text, configuration_id(description.dictionary));
    proof.compared = fmt::format("{} objects", plant.dictionary.objects.size());
    return proof;
}

bool all_same(std::span<const Proof> proofs) {
    return std::all_of(proofs.begin(), proofs.end(),
                       [](const Proof& proof) { return proof.differences.same(); });
}

}  // namespace cgw::proof
