// What `cgw network` prints of a bus.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnostic/renderers.hpp"
#include "explain/table.hpp"
#include "network/analysis.hpp"
#include "network/identifier_map.hpp"
#include "network/judge.hpp"

namespace cgw::cli {

struct NetworkReport {
    std::vector<network::Member> members;
    network::Bands bands;
    network::Analysis analysis;
    std::optional<network::Analysis> before;  // with --what-if: as the files have it
    std::vector<std::string> changes;         // the what-ifs, as typed
    std::vector<network::IdentifierRange> map;
    std::vector<std::string> left_out;
    std::vector<diagnostic::FileReport> findings;  // about the bus, by file
    bool fails = false;                            // a finding says so
    bool fails_before = false;
};

// "it will work: …" or "it will not work: …", one line without its end.
std::string network_verdict(const NetworkReport& report, const network::Analysis& analysis, bool fails);

// The messages by priority. With --what-if beside them how it was.
explain::Table network_table(const NetworkReport& report);

std::string network_text(const NetworkReport& report, bool with_map);
std::string network_markdown(const NetworkReport& report);
std::string network_json(const NetworkReport& report);  // schemas/network-report.schema.json

}  // namespace cgw::cli
