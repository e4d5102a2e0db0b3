// Inside the compare room: the parts of compare(), one source file each.
#pragma once

#include <vector>

#include "compare/compare.hpp"

namespace cgw::compare {

using Differences = std::vector<Difference>;

// Appends when the texts differ.
void note(Differences& differences, std::string_view kind, std::string subject, std::string a, std::string b);

// consequences.cpp: whether both devices talk; both buses and heartbeats; switches and sensors.
void compare_communication(const parameter::Settings& a, const parameter::Settings& b,
                           Differences& differences);
void compare_buses(const config::Configuration& a, const config::Configuration& b, Differences& differences);
void compare_inputs(const config::Configuration& a, const config::Configuration& b, Differences& differences);

// pdo_consequences.cpp: all 20 PDOs.
void compare_pdos(const config::Configuration& a, const config::Configuration& b, Differences& differences);

// word_consequences.cpp: engineering values of words that both carry; entries of 2001h and 2002h that A has.
void compare_scalings(const Side& a, const Side& b, Differences& differences);
void compare_objects(const config::Configuration& a, const config::Configuration& b,
                     Differences& differences);

// "RPDO2 word 1", where a sensor's channel comes (D26)
std::string channel_word_text(unsigned channel);

// "15.625 ms", "off"
std::string time_text(const config::CyclicTime& time);

}  // namespace cgw::compare
