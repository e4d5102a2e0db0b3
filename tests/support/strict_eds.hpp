// What strict importers refuse in an electronic data sheet, as an independent reader: it shares no code with
// the writer, so that a mistake in one does not hide in the other.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cgw::test {

using EdsSection = std::map<std::string, std::string>;

struct StrictEds {
    std::map<std::string, EdsSection> sections;
    std::vector<std::string> findings;  // "[1018sub1] DefaultValue is missing"; empty: accepted

    // Value of a key, or "" with a finding.
    std::string value(const std::string& section, const std::string& key);
    std::uint64_t number(const std::string& section, const std::string& key);  // 0 with a finding
    bool has(const std::string& section) const { return sections.contains(section); }
    void find(const std::string& where, const std::string& what);
};

// Lines, sections and keys only; check_strictly() then judges what they say.
StrictEds read_strictly(const std::string& text);
// Counts of DeviceInfo, communication against mapping objects, and every mapped object.
void check_pdos(StrictEds& eds);

std::string hex_digits(std::uint64_t value, int width);  // upper case, at least `width` of them
unsigned bits_of(std::uint64_t data_type);               // 0: a type no word has

StrictEds check_strictly(const std::string& text);

}  // namespace cgw::test
