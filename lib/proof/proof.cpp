#include "proof/proof.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cgw::proof {
namespace {

using dictionary::Difference;

constexpr std::string_view id_before = ", configuration ";
constexpr std::size_t id_digits = 16;

// The configuration id that cgw puts behind the description; "" in a file of another origin.
std::string stated_id(const dictionary::Dictionary& dictionary) {
    const std::string& description = dictionary.file.description;
    const std::size_t at = description.rfind(id_before);
    return at != std::string::npos ? description.substr(at + id_before.size(), id_digits) : std::string();
}

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
}

}  // namespace

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
    if (const std::string id = stated_id(description.dictionary); !id.empty()) {
        add_if(proof, "configuration-id", "configuration id", plant.configuration_id_text, id);
    }
    proof.compared = fmt::format("{} objects", plant.dictionary.objects.size());
    return proof;
}

bool all_same(std::span<const Proof> proofs) {
    return std::all_of(proofs.begin(), proofs.end(),
                       [](const Proof& proof) { return proof.differences.same(); });
}

}  // namespace cgw::proof
