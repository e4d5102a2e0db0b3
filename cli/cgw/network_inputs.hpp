// What `cgw network` is asked: the options of the bus, and the files as members of it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cli/cgw/command.hpp"
#include "driver/check_file.hpp"
#include "network/judge.hpp"
#include "network/sources.hpp"

namespace cgw::cli {

// --what-if: "baud=125", "TPDO5=100ms".
struct Change {
    std::string text;
    std::uint32_t bit_rate = 0;  // bit/s; 0: it is about a TPDO
    std::uint8_t tpdo = 0;       // 4..16
    std::uint32_t time_ms = 0;
};

struct NetworkOptions {
    network::Bus bus;  // without its bit rate
    network::Bands bands;
    std::uint64_t jitter_us = 0;  // of messages without a stated one
    std::vector<Change> changes;
    double target = 0;  // of --suggest, a share
};

// Throws UsageError.
NetworkOptions network_options(const Arguments& arguments);

// A node that --node names.
struct NodeOption {
    std::string path;
    std::uint8_t node_id = 0;
};
std::vector<NodeOption> node_options(const Arguments& arguments);

struct BusMembers {
    std::vector<driver::CheckedFile> plants;
    std::vector<network::DescribedNode> nodes;   // of --node
    std::vector<network::Message> foreign;       // their messages
    std::vector<diagnostic::Related> left_out;   // what of them cannot be counted
    std::map<std::string, std::string> sources;  // texts of the files, by path
    int exit_code = 0;
};

// Reads everything; findings are on stderr. What --node tells of a plant's own gateway once more is left out.
// Members are to be used when the exit code is 0.
BusMembers read_members(const Arguments& arguments);

// All messages of the members, not yet merged.
std::vector<network::Message> all_messages(const BusMembers& members, const NetworkOptions& options);

// The plants as members of the bus.
std::vector<network::Member> members_of(const BusMembers& members);

// Another bit rate is one for all: no node keeps what its DCF says.
void forget_set_rates(BusMembers& members);

// What the changes make of the plants; throws UsageError for a TPDO that no plant sends.
void apply_changes(BusMembers& members, const std::vector<Change>& changes);

}  // namespace cgw::cli
