// Inside the emit room: the report of a plant, section by section.
#pragma once

#include "emit/emitter.hpp"
#include "network/judge.hpp"
#include "page/page.hpp"

namespace cgw::emit {

using Blocks = std::vector<page::Block>;

std::string counted(std::size_t count, std::string_view what);  // "1 note", "2 notes"

// What the sections say together, for the verdict.
struct Judgement {
    page::Tone tone = page::Tone::good;
    std::vector<std::string> reasons;

    void add(page::Tone worse, std::string reason);
};

// report_plant.cpp: devices, buses, times.
void add_devices(const Plant& plant, Blocks& blocks);
void add_times(const Plant& plant, Blocks& blocks);

// report_network.cpp: identifiers, load and response times of the CANopen bus.
network::Judged judge_network(const Plant& plant);
void add_network(const network::Judged& bus, Blocks& blocks, Judgement& judgement);

// report_pdos.cpp: each active PDO.
void add_pdos(const Plant& plant, Blocks& blocks);

// report_findings.cpp: findings, what nobody checked, changes.
void add_findings(const Plant& plant, const network::Judged& bus, Blocks& blocks, Judgement& judgement);
void add_not_verified(const Plant& plant, Blocks& blocks, Judgement& judgement);
void add_changes(const Plant& plant, Blocks& blocks);

// report_sheets.cpp: what to type into both devices.
void add_entry_sheets(const Plant& plant, Blocks& blocks);

// All of it, the verdict first.
page::Page report_page(const Plant& plant);

}  // namespace cgw::emit
