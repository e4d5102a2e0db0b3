#include "support/strict_eds.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <regex>
#include <set>

namespace cgw::test {
namespace {

const std::regex object_name("[0-9A-F]{4}");
const std::regex sub_name("([0-9A-F]{4})sub([1-9A-F][0-9A-F]?|0)");

const std::map<std::string, std::set<std::string>> required_keys{
    {"FileInfo",
     {"FileName", "FileVersion", "FileRevision", "EDSVersion", "Description", "CreationTime", "CreationDate",
      "CreatedBy", "ModificationTime", "ModificationDate", "ModifiedBy"}},
    {"DeviceInfo", {"VendorName",        "VendorNumber",   "ProductName",
                    "ProductNumber",     "RevisionNumber", "OrderCode",
                    "BaudRate_10",       "BaudRate_20",    "BaudRate_50",
                    "BaudRate_125",      "BaudRate_250",   "BaudRate_500",
                    "BaudRate_800",      "BaudRate_1000",  "SimpleBootUpMaster",
                    "SimpleBootUpSlave", "Granularity",    "DynamicChannelsSupported",
                    "GroupMessaging",    "NrOfRXPDO",      "NrOfTXPDO",
                    "LSS_Supported"}},
    {"DummyUsage",
     {"Dummy0001", "Dummy0002", "Dummy0003", "Dummy0004", "Dummy0005", "Dummy0006", "Dummy0007"}},
};
const std::set<std::string> variable_keys{"ParameterName", "ObjectType",   "DataType",
                                          "AccessType",    "DefaultValue", "PDOMapping"};
const std::set<std::string> variable_options{"LowLimit", "HighLimit"};
const std::set<std::string> group_keys{"ParameterName", "ObjectType", "SubNumber"};

const std::map<std::string, std::regex> text_patterns{
    {"FileName", std::regex("CANopenGateway\\.eds")},
    {"FileVersion", std::regex("[0-9]{1,3}")},
    {"FileRevision", std::regex("[0-9]{1,3}")},
    {"EDSVersion", std::regex("4\\.0")},
    {"Description", std::regex(".{1,243}")},
    {"CreationTime", std::regex("(0[1-9]|1[0-2]):[0-5][0-9][AP]M")},
    {"ModificationTime", std::regex("(0[1-9]|1[0-2]):[0-5][0-9][AP]M")},
    {"CreationDate", std::regex("(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])-[0-9]{4}")},
    {"ModificationDate", std::regex("(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])-[0-9]{4}")},
    {"CreatedBy", std::regex(".{1,245}")},
    {"ModifiedBy", std::regex(".{1,244}")},
};

const std::regex access_pattern("ro|wo|rw|rwr|rww|const");
const std::regex node_id_pattern("\\$NODEID\\+0x[0-9A-F]{1,8}");
const std::regex mapping_object("1[67AB][0-9A-F]{2}");

class Checker {
  public:
    explicit Checker(const std::string& text) : eds_(read_strictly(text)) {
        check_required();
        check_list("MandatoryObjects",
                   [](std::uint64_t i) { return i == 0x1000 || i == 0x1001 || i == 0x1018; });
        check_list("OptionalObjects", [](std::uint64_t i) {
            return i >= 0x1000 && (i < 0x2000 || i > 0x5FFF) && i != 0x1000 && i != 0x1001 && i != 0x1018;
        });
        check_list("ManufacturerObjects", [](std::uint64_t i) { return i >= 0x2000 && i < 0x6000; });
        check_sections();
        check_identity();
        check_pdos(eds_);
    }

    StrictEds take() { return std::move(eds_); }

  private:
    void find(const std::string& where, const std::string& what) { eds_.find(where, what); }
    bool has(const std::string& section) const { return eds_.has(section); }
    std::string value(const std::string& section, const std::string& key) { return eds_.value(section, key); }

    std::uint64_t numeric(const std::string& section, const std::string& key) {
        return eds_.number(section, key);
    }

    void check_keys(const std::string& section, const std::set<std::string>& required,
                    const std::set<std::string>& optional) {
        for (const std::string& key : required) {
            value(section, key);
        }
        for (const auto& [key, text] : eds_.sections[section]) {
            if (!required.contains(key) && !optional.contains(key)) {
                find(section, key + " is unknown");
            }
        }
    }

    void check_required() {
        for (const auto& [section, keys] : required_keys) {
            check_keys(section, keys, {});
        }
        for (const auto& [key, pattern] : text_patterns) {
            if (!std::regex_match(value("FileInfo", key), pattern)) {
                find("FileInfo", key + " is malformed");
            }
        }
    }

    template <typename InRange>
    void check_list(const std::string& list, InRange in_range) {
        const std::uint64_t count = numeric(list, "SupportedObjects");
        if (eds_.sections[list].size() != count + 1) {
            find(list, "SupportedObjects is not the number of entries");
        }
        for (std::uint64_t i = 1; i <= count; ++i) {
            const std::uint64_t index = numeric(list, std::to_string(i));
            const std::string name = hex_digits(index, 4);
            if (!in_range(index)) {
                find(list, name + " does not belong here");
            }
            if (!has(name)) {
                find(list, name + " has no section");
            }
            listed_.insert(name);
        }
        if (list == "MandatoryObjects" && count != 3) {
            find(list, "not all mandatory objects are listed");
        }
    }

    void check_sections() {
        const std::set<std::string> known{"FileInfo",           "DeviceInfo",       "DummyUsage",
                                          "Comments",           "MandatoryObjects", "OptionalObjects",
                                          "ManufacturerObjects"};
        std::vector<std::string> names;
        for (const auto& [name, keys] : eds_.sections) {
            names.push_back(name);
        }
        for (const std::string& name : names) {
            std::smatch match;
            if (std::regex_match(name, object_name)) {
                check_object(name);
            } else if (std::regex_match(name, match, sub_name)) {
                if (!has(match[1]) || value(match[1], "ObjectType") == "0x7") {
                    find(name, "sub-object without its object");
                }
            } else if (!known.contains(name)) {
                find(name, "section is unknown");
            }
        }
    }

    void check_object(const std::string& name) {
        if (!listed_.contains(name)) {
            find(name, "object is not listed");
        }
        const std::string type = value(name, "ObjectType");
        if (type == "0x7") {
            check_variable(name);
            return;
        }
        if (type != "0x8" && type != "0x9") {
            find(name, "ObjectType is none of VAR, ARRAY, RECORD");
        }
        check_name(name);
        check_keys(name, group_keys, {});
        check_sub_objects(name);
    }

    std::vector<std::string> sections_of(const std::string& name) const {
        std::vector<std::string> names;
        const std::string prefix = name + "sub";
        for (auto at = eds_.sections.lower_bound(prefix);
             at != eds_.sections.end() && at->first.starts_with(prefix); ++at) {
            names.push_back(at->first);
        }
        return names;
    }

    void check_sub_objects(const std::string& name) {
        std::uint64_t present = 0;
        unsigned long long highest = 0;
        std::set<std::string> names;
        for (const std::string& section : sections_of(name)) {
            present += 1;
            highest = std::max(highest, std::strtoull(section.c_str() + name.size() + 3, nullptr, 16));
            check_variable(section);
            if (!names.insert(value(section, "ParameterName")).second) {
                find(section, "name appears twice in the object");
            }
        }
        if (numeric(name, "SubNumber") != present) {
            find(name, "SubNumber is not the number of sections");
        }
        const std::string first = name + "sub0";
        const std::uint64_t entries = numeric(first, "DefaultValue");
        const bool mapping = std::regex_match(name, mapping_object);
        if (mapping ? entries > highest : entries != highest) {
            find(first, "DefaultValue does not fit the highest sub-index");
        }
        if (value(first, "DataType") != "0x0005" || value(first, "AccessType") != "ro") {
            find(first, "sub 0 is no read-only UNSIGNED8");
        }
    }

    void check_name(const std::string& section) {
        const std::string name = value(section, "ParameterName");
        if (name.empty() || name.size() > 241) {
            find(section, "ParameterName is empty or too long");
        }
    }

    void check_variable(const std::string& section) {
        check_name(section);
        check_keys(section, variable_keys, variable_options);
        const unsigned bits = bits_of(numeric(section, "DataType"));
        const std::string access = value(section, "AccessType");
        if (bits == 0 || value(section, "ObjectType") != "0x7") {
            find(section, "DataType or ObjectType is wrong");
        }
        if (!std::regex_match(access, access_pattern)) {
            find(section, "AccessType is unknown: " + access);
        }
        const std::string mappable = value(section, "PDOMapping");
        if (mappable != "0" && mappable != "1") {
            find(section, "PDOMapping is neither 0 nor 1");
        }
        if (mappable == "1" && access == "rw") {
            find(section, "mappable object is rw instead of rwr or rww");
        }
        check_value(section, bits);
    }

    void check_value(const std::string& section, unsigned bits) {
        const std::string text = value(section, "DefaultValue");
        if (text.find("NODEID") != std::string::npos) {
            if (!std::regex_match(text, node_id_pattern)) {
                find(section, "DefaultValue does not begin with $NODEID");
            }
            return;
        }
        const std::uint64_t limit = bits == 32 ? 0xFFFFFFFFU : (std::uint64_t{1} << bits) - 1;
        const std::uint64_t value = numeric(section, "DefaultValue");
        if (value > limit) {
            find(section, "DefaultValue does not fit the type");
        }
        const EdsSection& keys = eds_.sections[section];
        if ((keys.contains("LowLimit") && value < numeric(section, "LowLimit")) ||
            (keys.contains("HighLimit") && value > numeric(section, "HighLimit"))) {
            find(section, "DefaultValue is outside the limits");
        }
    }

    void check_identity() {
        const std::map<std::string, std::string> same{
            {"VendorNumber", "1018sub1"}, {"ProductNumber", "1018sub2"}, {"RevisionNumber", "1018sub3"}};
        for (const auto& [key, section] : same) {
            if (numeric("DeviceInfo", key) != numeric(section, "DefaultValue")) {
                find("DeviceInfo", key + " differs from " + section);
            }
        }
    }

    StrictEds eds_;
    std::set<std::string> listed_;
};

}  // namespace

StrictEds check_strictly(const std::string& text) {
    return Checker(text).take();
}

}  // namespace cgw::test
