#include "cli/cgw/network_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "cli/cgw/check_report.hpp"
#include "cli/cgw/description_input.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "config/numbers.hpp"
#include "eds/value_places.hpp"
#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"
#include "network/same_device.hpp"

namespace cgw::cli {
namespace {

double number_within(std::string_view key, const std::string& text, double least, double most) {
    const std::optional<double> value = base::parse_real(text);
    if (!value || *value < least || *value > most) {
        throw UsageError(fmt::format("{}: '{}' is not a number from {} to {}", key, text,
                                     base::to_text(least), base::to_text(most)));
    }
    return *value;
}

std::uint64_t microseconds(const Arguments& arguments, std::string_view key) {
    constexpr double longest_ms = 3'600'000;
    return static_cast<std::uint64_t>(
        std::llround(number_within(key, arguments.value(key), 0, longest_ms) * 1000));
}

// "30,50,70"
network::Bands bands_of(const std::string& text) {
    network::Bands bands;
    double* const limits[] = {&bands.comfortable, &bands.ok, &bands.fail};
    std::string_view rest = text;
    double last = 0;
    for (double* limit : limits) {
        const std::size_t comma = rest.find(',');
        *limit = number_within("--bands", std::string(rest.substr(0, comma)), last, 100) / 100;
        last = *limit * 100;
        if ((comma == std::string_view::npos) != (limit == limits[2])) {
            throw UsageError(fmt::format("--bands: '{}' is not three numbers in percent", text));
        }
        rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    }
    return bands;
}

Change change_of(const std::string& text) {
    const std::size_t sign = text.find('=');
    const std::string name = text.substr(0, sign);
    std::string value = sign == std::string::npos ? "" : text.substr(sign + 1);
    Change change{.text = text};
    if (name == "baud") {
        const auto& rates = facts::bit_rates_kbit;
        const std::optional<std::int64_t> kbit = base::parse_integer(value);
        if (!kbit || std::find(rates.begin(), rates.end(), *kbit) == rates.end()) {
            throw UsageError(fmt::format("--what-if baud: '{}' is no bit rate of 426 CanOpenBaudrate: {}",
                                         value, fmt::join(rates, ", ")));
        }
        change.bit_rate = static_cast<std::uint32_t>(*kbit) * 1000;
        return change;
    }
    const std::optional<std::int64_t> tpdo =
        name.starts_with("TPDO") ? base::parse_integer(std::string_view(name).substr(4)) : std::nullopt;
    if (!tpdo || *tpdo < config::first_analogue_tpdo || *tpdo > config::tpdo_count) {
        throw UsageError(fmt::format("--what-if: '{}' is neither baud=KBIT nor TPDO4=MS to TPDO16=MS", text));
    }
    change.tpdo = static_cast<std::uint8_t>(*tpdo);
    value.resize(value.ends_with("ms") ? value.size() - 2 : value.size());
    const std::optional<std::int64_t> time = base::parse_integer(value);
    if (!time || *time < 1 || *time > config::longest_time_ms) {
        throw UsageError(fmt::format("--what-if {}: '{}' is no time from 1 to {} ms", name, value,
                                     config::longest_time_ms));
    }
    change.time_ms = static_cast<std::uint32_t>(*time);
    return change;
}

// Where a description says what; only those that are EDS or DCF tell lines.
class Places {
  public:
    explicit Places(const driver::DeviceDescription& description) : path_(description.path) {
        if (driver::is_eds(description.kind)) {
            sheet_.emplace(description.sources.at(path_));
        }
    }

    diagnostic::Location whole() const { return {path_, {}}; }
    diagnostic::Location of_object(std::uint16_t index, std::uint8_t sub_index) const {
        return {path_, sheet_ ? sheet_->of_object(index, sub_index) : diagnostic::Range{}};
    }
    diagnostic::Location of_key(eds::SectionKind section, std::string_view key) const {
        return {path_, sheet_ ? sheet_->of_key(section, key) : diagnostic::Range{}};
    }

  private:
    const std::string& path_;
    std::optional<eds::ValuePlaces> sheet_;
};

// E0209: what check refuses in a file is no question either.
config::CyclicTime possible_time(const Change& change, std::uint32_t main_cycle_us) {
    const config::CyclicTime time = config::cyclic_time(change.time_ms, main_cycle_us);
    if (time.cycles > config::maximum_governor_cycles) {
        throw UsageError(fmt::format("--what-if {}: {} main cycles of {}, and at most {} are possible (D8)",
                                     change.text, time.cycles, base::milliseconds_text(main_cycle_us),
                                     config::maximum_governor_cycles));
    }
    return time;
}

void read_node(const Arguments& arguments, const NodeOption& option, int device, BusMembers& members) {
    driver::DeviceDescription description = load_description(arguments, option.path, members.exit_code);
    if (!description.valid() || members.exit_code != exit_fine) {
        return;
    }
    if (description.node_id && *description.node_id != option.node_id) {
        throw UsageError(fmt::format("--node: {} is about node {}, and {} is asked for", option.path,
                                     *description.node_id, option.node_id));
    }
    const Places places(description);
    network::ForeignNode node = network::messages_of(
        description.dictionary, option.node_id, places.whole(),
        [&](std::uint16_t index, std::uint8_t sub_index) { return places.of_object(index, sub_index); });
    for (std::size_t plant = 0; plant < members.plants.size(); ++plant) {
        const driver::CheckedFile& file = members.plants[plant];
        if (file.configuration.node_id == option.node_id &&
            network::difference_between(
                network::messages_of(file.settings, file.configuration, static_cast<int>(plant)),
                node.messages, option.node_id)
                .empty()) {
            return;
        }
    }
    network::DescribedNode described{.node_id = option.node_id,
                                     .offered_kbit = description.dictionary.device.bit_rates_kbit,
                                     .set_kbit = std::nullopt,
                                     .offered_where = places.of_key(eds::SectionKind::device_info, ""),
                                     .set_where = places.of_key(eds::SectionKind::commissioning, "Baudrate")};
    if (description.commissioning) {
        described.set_kbit = description.commissioning->bit_rate_kbit;
    }
    members.nodes.push_back(std::move(described));
    for (network::Message& message : node.messages) {
        message.plant = device;
    }
    members.foreign.insert(members.foreign.end(), node.messages.begin(), node.messages.end());
    members.left_out.insert(members.left_out.end(), node.left_out.begin(), node.left_out.end());
    members.sources.merge(description.sources);
}

}  // namespace

NetworkOptions network_options(const Arguments& arguments) {
    NetworkOptions options;
    constexpr double most_errors = 10'000;
    options.bus.errors_per_second = number_within("--errors", arguments.value("--errors"), 0, most_errors);
    options.bus.sdo_interval_us = microseconds(arguments, "--sdo");
    options.jitter_us = microseconds(arguments, "--jitter");
    options.bands = bands_of(arguments.value("--bands"));
    for (const std::string& text : arguments.values("--what-if")) {
        Change change = change_of(text);
        if (std::any_of(options.changes.begin(), options.changes.end(),
                        [&](const Change& other) { return other.tpdo == change.tpdo; })) {
            throw UsageError(fmt::format("--what-if: {} is given twice", text.substr(0, text.find('='))));
        }
        options.changes.push_back(std::move(change));
    }
    options.target = number_within("--target", arguments.value("--target"), 1, 100) / 100;
    return options;
}

std::vector<NodeOption> node_options(const Arguments& arguments) {
    std::vector<NodeOption> nodes;
    for (const std::string& text : arguments.values("--node")) {
        const std::size_t colon = text.rfind(':');
        const std::optional<std::int64_t> node_id =
            colon == std::string::npos ? std::nullopt
                                       : base::parse_integer(std::string_view(text).substr(colon + 1));
        if (!node_id || *node_id < 1 || *node_id > facts::maximum_node_id || colon == 0) {
            throw UsageError(fmt::format("--node: '{}' is not FILE:ID with a node id from 1 to {}", text,
                                         facts::maximum_node_id));
        }
        nodes.push_back({text.substr(0, colon), static_cast<std::uint8_t>(*node_id)});
    }
    return nodes;
}

BusMembers read_members(const Arguments& arguments) {
    BusMembers members;
    const std::vector<NodeOption> nodes = node_options(arguments);
    for (const std::string& path : checked_files(arguments)) {
        driver::CheckedFile file = driver::check_file(path);
        report_findings(file, use_color(arguments, stderr));
        members.exit_code = worse(members.exit_code, exit_code_of(file));
        members.plants.push_back(std::move(file));
    }
    int device = 0;
    for (const NodeOption& node : nodes) {
        read_node(arguments, node, --device, members);
    }
    return members;
}

std::vector<network::Message> all_messages(const BusMembers& members, const NetworkOptions& options) {
    std::vector<network::Message> messages;
    for (std::size_t plant = 0; plant < members.plants.size(); ++plant) {
        const driver::CheckedFile& file = members.plants[plant];
        const auto own = network::messages_of(file.settings, file.configuration, static_cast<int>(plant));
        messages.insert(messages.end(), own.begin(), own.end());
    }
    messages.insert(messages.end(), members.foreign.begin(), members.foreign.end());
    for (network::Message& message : messages) {
        message.jitter_us = message.jitter_us == 0 ? options.jitter_us : message.jitter_us;
    }
    return messages;
}

std::vector<network::Member> members_of(const BusMembers& members) {
    std::vector<network::Member> found;
    for (const driver::CheckedFile& file : members.plants) {
        found.push_back(network::member_of(file.settings, file.configuration));
        found.back().path = file.path;
    }
    return found;
}

void forget_set_rates(BusMembers& members) {
    for (network::DescribedNode& node : members.nodes) {
        node.set_kbit.reset();
    }
}

void apply_changes(BusMembers& members, const std::vector<Change>& changes) {
    for (const Change& change : changes) {
        bool found = change.tpdo == 0;
        if (change.tpdo == 0) {
            forget_set_rates(members);
        }
        for (driver::CheckedFile& file : members.plants) {
            config::Configuration& configuration = file.configuration;
            if (change.tpdo == 0) {
                configuration.can2.manual = false;
                configuration.can2.bit_rate_kbit = static_cast<std::uint16_t>(change.bit_rate / 1000);
                continue;
            }
            config::Pdo& pdo = configuration.pdos[change.tpdo - 1U];
            if (pdo.active) {
                pdo.time = possible_time(change, configuration.main_cycle_us);
                found = true;
            }
        }
        if (!found) {
            throw UsageError(fmt::format("--what-if {}: no plant sends TPDO{}", change.text, change.tpdo));
        }
    }
}

}  // namespace cgw::cli
