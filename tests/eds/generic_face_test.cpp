// The generic EDS against the one that the manual prints (chapter 10), key by key: every difference stands in
// tests/data/eds/generic-differences.txt with the ruling it follows, and none is without one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>

#include "eds/writer.hpp"
#include "profile/gateway.hpp"
#include "support/golden.hpp"
#include "support/strict_eds.hpp"

namespace cgw::eds {
namespace {

struct Entry {
    std::string section;
    std::string key;
    std::string value;
};

struct Difference {
    std::string section;
    std::string key;
    std::string printed;  // "(none)" where the key is not printed
    std::string written;  // "(none)" where cgw does not write it
};

constexpr std::string_view none = "(none)";

// Sections, keys and values as they stand there; spelling matters.
std::vector<Entry> entries_of(const std::string& text) {
    std::vector<Entry> entries;
    std::string section;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());
        const std::size_t equals = line.find('=');
        if (line.starts_with("[")) {
            section = line.substr(1, line.find(']') - 1);
        } else if (!line.starts_with(";") && equals != std::string::npos) {
            entries.push_back({section, line.substr(0, equals), line.substr(equals + 1)});
        }
    }
    return entries;
}

const Entry* find(const std::vector<Entry>& entries, const Entry& wanted) {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
        return entry.section == wanted.section && entry.key == wanted.key;
    });
    return found != entries.end() ? &*found : nullptr;
}

std::vector<Difference> differences(const std::vector<Entry>& printed, const std::vector<Entry>& written) {
    std::vector<Difference> found;
    for (const Entry& entry : printed) {
        const Entry* const other = find(written, entry);
        if (other == nullptr || other->value != entry.value) {
            found.push_back(
                {entry.section, entry.key, entry.value, other != nullptr ? other->value : std::string(none)});
        }
    }
    for (const Entry& entry : written) {
        if (find(printed, entry) == nullptr) {
            found.push_back({entry.section, entry.key, std::string(none), entry.value});
        }
    }
    return found;
}

bool same_number(const Difference& difference) {
    static const std::regex number("0x[0-9A-Fa-f]+|0|[1-9][0-9]*");
    return std::regex_match(difference.printed, number) && std::regex_match(difference.written, number) &&
           std::strtoull(difference.printed.c_str(), nullptr, 0) ==
               std::strtoull(difference.written.c_str(), nullptr, 0);
}

bool is_record(const std::string& section) {
    static const std::regex record("1018|1200|16[0-9A-F]{2}|1A[0-9A-F]{2}");
    return std::regex_match(section, record);
}

struct Reason {
    std::string_view ruling;
    std::string_view documented;  // as docs/rulings.md names the point in the table of D41; "" elsewhere
    bool (*applies)(const Difference&);
};

const std::array reasons{
    Reason{"D41", "`FileName=CANopenGateway.ed5`", [](const Difference& d) { return d.key == "FileName"; }},
    Reason{"D41", "`DefaultValue=0x0x00001B59` (1018h:2)",
           [](const Difference& d) { return d.section == "1018sub2" && d.key == "DefaultValue"; }},
    Reason{"D41", "`EDSVersion=4`", [](const Difference& d) { return d.key == "EDSVersion"; }},
    Reason{"D41", "`CreationTime=00:00AM`, `ModificationTime=00:00AM`",
           [](const Difference& d) { return d.printed == "00:00AM" && d.written == "12:00AM"; }},
    Reason{"D41", "`SimpleBoot-upMaster`, `SimpleBoot-upSlave`",
           [](const Difference& d) {
               return d.key.starts_with("SimpleBoot") && (d.printed == none || d.written == none);
           }},
    Reason{"D41", "`Defaultvalue` (2000h..2004h)",
           [](const Difference& d) {
               return d.key == "Defaultvalue" ||
                      (d.key == "DefaultValue" && d.printed == none && d.section.starts_with("200") &&
                       d.section.ends_with("sub0"));
           }},
    Reason{"D41", "`ObjectType=0x8` for 1018h, 1200h, 16xxh, 1Axxh",
           [](const Difference& d) {
               return d.key == "ObjectType" && is_record(d.section) && d.printed == "0x8" &&
                      d.written == "0x9";
           }},
    Reason{"D41", "numbers as `5`, `0x2`, `0x07`", same_number},
    Reason{"D41", "`ModifiedBy`, `[Comments]`",
           [](const Difference& d) { return d.key == "ModifiedBy" || d.section == "Comments"; }},
    Reason{"D43", "",
           [](const Difference& d) {
               return d.key == "DefaultValue" && d.printed == none &&
                      std::strtoull(d.written.c_str(), nullptr, 0) == 0;
           }},
};

const Reason* reason_for(const Difference& difference) {
    const auto* const found = std::find_if(reasons.begin(), reasons.end(),
                                           [&](const Reason& reason) { return reason.applies(difference); });
    return found != reasons.end() ? found : nullptr;
}

std::string generic_eds() {
    profile::GatewayDocument document;
    document.tool_version = "0.1.0";
    return write(profile::generic_gateway_dictionary(document));
}

std::vector<Difference> differences_from_print() {
    return differences(entries_of(test::read_text(CGW_TEST_DATA "/eds/printed.eds")),
                       entries_of(generic_eds()));
}

// First cells of the table below the heading of D41.
std::set<std::string> documented_points() {
    std::istringstream lines(test::read_text(CGW_TEST_DATA "/../../docs/rulings.md"));
    std::set<std::string> points;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("### ")) {
            inside = line.starts_with("### D41 ");
        } else if (inside && line.starts_with("| ") && !line.starts_with("| Printed")) {
            points.insert(line.substr(2, line.find(" | ") - 2));
        }
    }
    return points;
}

}  // namespace

TEST(GenericEds, differs_from_the_print_only_where_a_ruling_says_so) {
    std::string text;
    for (const Difference& difference : differences_from_print()) {
        const Reason* const reason = reason_for(difference);
        EXPECT_NE(reason, nullptr) << "no ruling for [" << difference.section << "] " << difference.key
                                   << ": " << difference.printed << " -> " << difference.written;
        text += "[" + difference.section + "] " + difference.key + ": " + difference.printed + " -> " +
                difference.written + "  " + (reason != nullptr ? std::string(reason->ruling) : "?") + "\n";
    }
    test::expect_golden("eds/generic-differences.txt", text);
}

TEST(GenericEds, mends_every_point_of_the_documented_table_and_no_other) {
    std::set<std::string> applied;
    for (const Difference& difference : differences_from_print()) {
        const Reason* const reason = reason_for(difference);
        if (reason != nullptr && reason->ruling == "D41") {
            applied.emplace(reason->documented);
        }
    }
    EXPECT_EQ(applied, documented_points());
}

TEST(GenericEds, is_accepted_by_strict_importers) {
    EXPECT_EQ(test::check_strictly(generic_eds()).findings, std::vector<std::string>{});
}

TEST(GenericEds, keeps_the_identifiers_as_printed) {
    test::StrictEds eds = test::read_strictly(generic_eds());
    EXPECT_EQ(eds.value("1403sub1", "DefaultValue"), "$NODEID+0x80000500");
    EXPECT_EQ(eds.value("1803sub1", "DefaultValue"), "$NODEID+0x80000480");
    EXPECT_EQ(eds.value("1804sub1", "DefaultValue"), "$NODEID+0x80000000");
    EXPECT_EQ(eds.value("180Fsub1", "DefaultValue"), "$NODEID+0x80000000");
}

TEST(GenericEds, has_the_entries_that_every_configuration_has) {
    test::StrictEds eds = test::read_strictly(generic_eds());
    EXPECT_EQ(eds.value("2000", "SubNumber"), "7");
    EXPECT_EQ(eds.value("1600", "SubNumber"), "1");
    EXPECT_FALSE(eds.has("1600sub1"));
    EXPECT_FALSE(eds.has("2001sub1"));
}

TEST(GenericEds, says_whose_file_it_was_and_who_mended_it) {
    test::StrictEds eds = test::read_strictly(generic_eds());
    EXPECT_EQ(eds.value("FileInfo", "CreatedBy"), "Heinzmann GmbH & Co. KG");
    EXPECT_EQ(eds.value("FileInfo", "CreationDate"), "05-19-2004");
    EXPECT_EQ(eds.value("FileInfo", "ModifiedBy"), "cgw 0.1.0");
    EXPECT_EQ(eds.value("FileInfo", "Description"), "EDS for Heinzmann CANopen Gateway");
}

}  // namespace cgw::eds
