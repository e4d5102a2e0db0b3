#include <set>

#include "support/strict_eds.hpp"

namespace cgw::test {
namespace {

using AccessTypes = std::set<std::string>;

void check_mapped(StrictEds& eds, const std::string& section, std::uint64_t entry,
                  const AccessTypes& access) {
    const std::uint64_t index = entry >> 16U;
    const std::uint64_t sub = entry >> 8U & 0xFFU;
    const std::uint64_t bits = entry & 0xFFU;
    if (index < 0x20) {
        if (sub != 0 || bits_of(index) != bits ||
            eds.value("DummyUsage", "Dummy" + hex_digits(index, 4)) != "1") {
            eds.find(section, "maps a dummy that DummyUsage does not allow");
        }
        return;
    }
    const std::string object = hex_digits(index, 4);
    const bool single = eds.has(object) && eds.value(object, "ObjectType") == "0x7";
    const std::string target = single && sub == 0 ? object : object + "sub" + hex_digits(sub, 1);
    if (!eds.has(target)) {
        eds.find(section, "maps an object that does not exist");
        return;
    }
    if (bits_of(eds.number(target, "DataType")) != bits) {
        eds.find(section, "maps an object of another length");
    }
    if (eds.value(target, "PDOMapping") != "1") {
        eds.find(section, "maps an object that is not mappable");
    }
    if (!access.contains(eds.value(target, "AccessType"))) {
        eds.find(section, "maps an object of unsuitable access");
    }
}

void check_mapping(StrictEds& eds, const std::string& map, const AccessTypes& access) {
    const std::uint64_t used = eds.number(map + "sub0", "DefaultValue");
    std::uint64_t total = 0;
    for (std::uint64_t sub = 1; eds.has(map + "sub" + hex_digits(sub, 1)); ++sub) {
        const std::string section = map + "sub" + hex_digits(sub, 1);
        const std::uint64_t entry = eds.number(section, "DefaultValue");
        if (sub > used) {
            if (entry != 0) {
                eds.find(section, "unused entry is not 0");
            }
            continue;
        }
        total += entry & 0xFFU;
        check_mapped(eds, section, entry, access);
    }
    if (total > 64) {
        eds.find(map, "more than 64 bits are mapped");
    }
}

void check_direction(StrictEds& eds, const std::string& key, std::uint64_t communication,
                     std::uint64_t mapping, const AccessTypes& access) {
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; i < 512; ++i) {
        const std::string parameters = hex_digits(communication + i, 4);
        const std::string map = hex_digits(mapping + i, 4);
        if (eds.has(parameters) != eds.has(map)) {
            eds.find(parameters, "communication without mapping or the reverse");
        }
        if (eds.has(map)) {
            count += 1;
            check_mapping(eds, map, access);
        }
    }
    if (eds.number("DeviceInfo", key) != count) {
        eds.find("DeviceInfo", key + " is not the number of PDOs");
    }
}

}  // namespace

void check_pdos(StrictEds& eds) {
    check_direction(eds, "NrOfRXPDO", 0x1400, 0x1600, {"rww", "rw", "wo"});
    check_direction(eds, "NrOfTXPDO", 0x1800, 0x1A00, {"ro", "rwr", "rw", "const"});
}

}  // namespace cgw::test
