#include "cli/cgw/network_suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "authoring/patch.hpp"
#include "base/canopen_text.hpp"
#include "config/numbers.hpp"
#include "network/frame_bits.hpp"
#include "network/identifier_map.hpp"

namespace cgw::cli {
namespace {

using config::Pdo;
using driver::CheckedFile;
using parameter::Assignment;
using parameter::Device;
namespace gateway = config::gateway;
namespace governor = config::governor;

class Search {
  public:
    Search(BusMembers& members, const NetworkOptions& options, bool keep_rate, const AskBus& ask)
        : members_(members), options_(options), keep_rate_(keep_rate), ask_(ask) {}

    Suggestion run() {
        level_rates();
        move_identifiers();
        // Each step makes the load smaller, by half at most: far fewer steps are enough.
        constexpr int most_steps = 1'000;
        for (int step = 0; step < most_steps; ++step) {
            const BusState state = ask_(members_);
            found_.reached = state.works && state.load <= options_.target;
            if (found_.reached || !(raise_rate() || lengthen_cycle())) {
                break;
            }
        }
        write();
        return std::move(found_);
    }

  private:
    struct Key {
        std::size_t plant;
        Device device;
        std::uint16_t number;
        auto operator<=>(const Key&) const = default;
    };

    // False where the file does not set the parameter: then nothing stands there to be changed.
    bool change(std::size_t plant, Device device, std::uint16_t number, const std::string& value,
                const std::string& what) {
        if (assignment(plant, device, number) == nullptr) {
            return false;
        }
        edits_[{plant, device, number}] = {value, fmt::format("{}: {}", members_.plants[plant].path, what)};
        return true;
    }

    const Assignment* assignment(std::size_t plant, Device device, std::uint16_t number) const {
        return members_.plants[plant].settings.of(device).find(number);
    }

    bool set_rate(std::uint16_t kbit) {
        const auto can = [&](const CheckedFile& file) {
            return !file.configuration.can2.manual &&
                   file.settings.gateway.find(gateway::canopen_bit_rate) != nullptr;
        };
        if (!std::all_of(members_.plants.begin(), members_.plants.end(), can)) {
            return false;
        }
        for (std::size_t plant = 0; plant < members_.plants.size(); ++plant) {
            std::uint16_t& rate = members_.plants[plant].configuration.can2.bit_rate_kbit;
            if (rate != kbit) {
                rate = kbit;
                change(plant, Device::gateway, gateway::canopen_bit_rate, std::to_string(kbit),
                       fmt::format("bit rate {} kbit/s, of all nodes on the bus", kbit));
            }
        }
        return true;
    }

    // Bit rates that no node is without, upwards.
    std::vector<std::uint16_t> possible_rates() const {
        std::vector<std::uint16_t> rates(facts::bit_rates_kbit.begin(), facts::bit_rates_kbit.end());
        std::erase_if(rates, [&](std::uint16_t rate) {
            return !std::all_of(members_.nodes.begin(), members_.nodes.end(),
                                [&](const network::DescribedNode& node) { return node.offers(rate); });
        });
        return rates;
    }

    // One bit rate for all: the highest of them, or the next one that all have.
    void level_rates() {
        std::uint32_t highest = 0;
        for (const CheckedFile& file : members_.plants) {
            highest = std::max<std::uint32_t>(highest, file.configuration.can2.bit_rate_kbit);
        }
        for (const network::DescribedNode& node : members_.nodes) {
            highest = std::max(highest, node.set_kbit.value_or(0));
        }
        const std::vector<std::uint16_t> rates = possible_rates();
        if (!rates.empty()) {
            const auto next = std::lower_bound(rates.begin(), rates.end(), highest);
            set_rate(next != rates.end() ? *next : rates.back());
        }
    }

    bool raise_rate() {
        const std::vector<std::uint16_t> rates = possible_rates();
        const auto next = std::upper_bound(rates.begin(), rates.end(),
                                           members_.plants.front().configuration.can2.bit_rate_kbit);
        if (keep_rate_ || next == rates.end() || !set_rate(*next)) {
            return false;
        }
        forget_set_rates(members_);
        return true;
    }

    // TPDOs whose identifier somebody else has; the last plant gives way.
    void move_identifiers() {
        for (std::size_t plant = members_.plants.size(); plant-- > 0;) {
            for (Pdo& pdo : members_.plants[plant].configuration.pdos) {
                const bool own = pdo.active && pdo.cob_id_source == config::CobIdSource::parameter;
                if (own && use_of(pdo.cob_id) == network::Use::conflict) {
                    move(plant, pdo);
                }
            }
        }
    }

    network::Use use_of(std::uint16_t identifier) const {
        const std::vector<network::IdentifierRange> map =
            network::identifier_map(all_messages(members_, options_));
        const auto range = std::find_if(map.begin(), map.end(), [&](const network::IdentifierRange& one) {
            return identifier >= one.first && identifier <= one.last;
        });
        return range->use;
    }

    void move(std::size_t plant, Pdo& pdo) {
        const auto free = network::free_identifiers(all_messages(members_, options_), 1);
        if (!free.empty() &&
            change(plant, Device::gateway, gateway::tpdo_identifier_of(pdo.number),
                   fmt::format("0x{:X}", free.front()),
                   fmt::format("{} from {} to {}, which nobody has", pdo.name(),
                               base::identifier_text(pdo.cob_id), base::identifier_text(free.front())))) {
            pdo.cob_id = free.front();
        }
    }

    // Doubles the cycle of the TPDO that takes most of the bus.
    bool lengthen_cycle() {
        Pdo* chosen = nullptr;
        std::size_t of_plant = 0;
        double most = 0;
        for (std::size_t plant = 0; plant < members_.plants.size(); ++plant) {
            for (Pdo& pdo : members_.plants[plant].configuration.pdos) {
                const bool cyclic = pdo.direction == config::Direction::transmit && pdo.active &&
                                    pdo.number >= config::first_analogue_tpdo;
                const double load =
                    cyclic ? network::worst_case_bits(pdo.length()) / (1.0 * pdo.time.effective_us) : 0;
                const bool possible = cyclic && pdo.time.cycles * 2 <= config::maximum_governor_cycles;
                if (possible && load > most) {
                    most = load;
                    chosen = &pdo;
                    of_plant = plant;
                }
            }
        }
        return chosen != nullptr && set_cycle(of_plant, *chosen, chosen->time.asked_ms * 2);
    }

    bool set_cycle(std::size_t plant, Pdo& pdo, std::uint32_t time_ms) {
        pdo.time = config::cyclic_time(time_ms, members_.plants[plant].configuration.main_cycle_us);
        return change(plant, Device::governor, governor::tpdo_cycle_of(pdo.number), std::to_string(time_ms),
                      fmt::format("{} every {}", pdo.name(), base::milliseconds_text(pdo.time.effective_us)));
    }

    void write() {
        for (std::size_t plant = 0; plant < members_.plants.size(); ++plant) {
            const CheckedFile& file = members_.plants[plant];
            std::vector<authoring::Edit> edits;
            for (const auto& [key, edit] : edits_) {
                if (key.plant == plant) {
                    edits.push_back({assignment(plant, key.device, key.number)->where.range, edit.first});
                    found_.changes.push_back(edit.second);
                }
            }
            const auto source = file.sources.find(file.path);
            if (source != file.sources.end()) {
                found_.patch += authoring::unified_diff(file.path, source->second, edits);
            }
        }
    }

    BusMembers& members_;
    const NetworkOptions& options_;
    bool keep_rate_;
    const AskBus& ask_;
    std::map<Key, std::pair<std::string, std::string>> edits_;  // value, and what it does
    Suggestion found_;
};

}  // namespace

Suggestion suggest(BusMembers& members, const NetworkOptions& options, bool keep_rate, const AskBus& ask) {
    return Search(members, options, keep_rate, ask).run();
}

}  // namespace cgw::cli
