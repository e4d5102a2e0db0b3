// Elements and attributes that the reader makes no use of: what is not in the table below. Words that only
// say how the file is made up stand in it as well.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/utf8.hpp"
#include "xdd/reading.hpp"
#include "xdd/words.hpp"

namespace cgw::xdd {
namespace {

constexpr std::size_t most_attributes = 16;
constexpr unsigned deepest = 16;  // elements in each other; what is read lies less deep

struct ElementRow {
    std::string_view name;
    std::array<std::string_view, most_attributes> attributes{};  // that are read
    bool single = false;  // of several in one element the first is read
    bool whole = false;   // what it contains is known to say nothing more
};

constexpr std::array rows{
    ElementRow{"ISO15745Profile"},
    ElementRow{"ProfileHeader", {}, false, true},
    ElementRow{"ProfileBody",
               {"formatName", "formatVersion", "fileName", "fileCreator", "fileCreationDate",
                "fileCreationTime", "fileModifiedBy", "fileModificationDate", "fileModificationTime",
                "fileVersion", "supportedLanguages"}},

    ElementRow{"DeviceIdentity", {}, true},
    ElementRow{"vendorName", {"readOnly"}, true},
    ElementRow{"vendorID", {"readOnly"}, true},
    ElementRow{"productName", {"readOnly"}, true},
    ElementRow{"productID", {"readOnly"}, true},
    ElementRow{"productText", {"readOnly"}, true},
    ElementRow{"description", {"lang"}, true},
    ElementRow{"orderNumber", {"readOnly"}, true},
    ElementRow{"version", {"versionType", "readOnly"}, true},
    ElementRow{"DeviceManager", {}, true},
    ElementRow{"DeviceFunction", {}, true},
    ElementRow{"capabilities", {}, true},
    ElementRow{"characteristicsList"},
    ElementRow{"characteristic"},
    ElementRow{"characteristicName", {}, true},
    ElementRow{"characteristicContent"},

    ElementRow{"ApplicationProcess"},
    ElementRow{"dataTypeList", {}, true},
    ElementRow{"derived", {"uniqueID", "name"}},
    ElementRow{"enum", {"uniqueID", "name"}},
    ElementRow{"templateList", {}, true},
    ElementRow{"parameterTemplate", {"uniqueID", "access"}},
    ElementRow{"parameterList", {}, true},
    ElementRow{"parameter", {"uniqueID", "access", "templateIDRef"}},
    ElementRow{"dataTypeIDRef", {"uniqueIDRef"}, true},
    ElementRow{"label", {"lang"}, true},
    ElementRow{"denotation", {}, true},
    ElementRow{"defaultValue", {"value"}, true},
    ElementRow{"actualValue", {"value"}, true},
    ElementRow{"allowedValues", {}, true},
    ElementRow{"range"},
    ElementRow{"minValue", {"value"}, true},
    ElementRow{"maxValue", {"value"}, true},
    ElementRow{type_without_width},

    ElementRow{"ApplicationLayers", {"conformanceClass", "communicationEntityType"}},
    ElementRow{"CANopenObjectList", {"mandatoryObjects", "optionalObjects", "manufacturerObjects"}, true},
    ElementRow{
        "CANopenObject",
        {"index", "name", "objectType", "dataType", "lowLimit", "highLimit", "accessType", "defaultValue",
         "actualValue", "denotation", "PDOmapping", "objFlags", "uniqueIDRef", "subNumber"}},
    ElementRow{"CANopenSubObject",
               {"subIndex", "name", "objectType", "dataType", "lowLimit", "highLimit", "accessType",
                "defaultValue", "actualValue", "denotation", "PDOmapping", "objFlags", "uniqueIDRef"}},
    ElementRow{"dummyUsage", {}, true},
    ElementRow{"dummy", {"entry"}},
    ElementRow{"TransportLayers", {}, true},
    ElementRow{"PhysicalLayer", {}, true},
    ElementRow{"baudRate", {}, true},
    ElementRow{"supportedBaudRate", {"value"}},
    ElementRow{"NetworkManagement", {}, true},
    ElementRow{"CANopenGeneralFeatures",
               {"groupMessaging", "dynamicChannels", "granularity", "nrOfRxPDO", "nrOfTxPDO", "bootUpSlave",
                "layerSettingServiceSlave"},
               true},
    ElementRow{"CANopenMasterFeatures", {"bootUpMaster"}, true},
    ElementRow{"deviceCommissioning",
               {"NodeID", "nodeName", "actualBaudRate", "networkNumber", "networkName", "CANopenManager"},
               true},
};

const ElementRow* row_of(std::string_view name) {
    const auto* const found =
        std::find_if(rows.begin(), rows.end(), [name](const ElementRow& row) { return row.name == name; });
    return found != rows.end() ? found : nullptr;
}

bool is_elementary_type(std::string_view name) {
    return std::any_of(elementary_types.begin(), elementary_types.end(),
                       [name](const ElementaryType& each) { return each.element == name; });
}

// Name spaces, where schemas lie, and what is so by default.
bool says_nothing(pugi::xml_attribute attribute) {
    const std::string_view name = attribute.name();
    const std::string_view value = attribute.value();
    return name.starts_with("xmlns") || name.starts_with("xsi:") || value.empty() || value == "false" ||
           value == "0";
}

class Finder {
  public:
    void look_into(pugi::xml_node element) {
        Seen seen{};
        for (const pugi::xml_node child : element.children()) {
            if (child.type() == pugi::node_comment) {
                ++comments_;
            } else if (child.type() == pugi::node_element) {
                look_at(child, seen);
            }
        }
    }

    std::vector<Unread> take() const {
        std::vector<Unread> all;
        for (const auto& [name, count] : elements_) {
            all.push_back({"element " + base::printable(name), count});
        }
        for (const auto& [name, count] : attributes_) {
            all.push_back({"attribute " + base::printable(name), count});
        }
        if (comments_ != 0) {
            all.push_back({"comments", comments_});
        }
        return all;
    }

  private:
    using Seen = std::array<bool, rows.size()>;  // by row: one stands in the same element already

    void look_at(pugi::xml_node element, Seen& seen) {
        const std::string_view name = local_name(element.name());
        const ElementRow* const row = row_of(name);
        if (is_elementary_type(name)) {
            return;
        }
        if (depth_ == deepest || row == nullptr || is_passed_over(element) || is_repeated(*row, seen)) {
            ++elements_[name];
            return;
        }
        if (row->whole) {
            return;
        }
        for (const pugi::xml_attribute attribute : element.attributes()) {
            const bool is_read = std::find(row->attributes.begin(), row->attributes.end(),
                                           local_name(attribute.name())) != row->attributes.end();
            if (!is_read && !says_nothing(attribute)) {
                ++attributes_[attribute.name()];
            }
        }
        ++depth_;
        look_into(element);
        --depth_;
    }

    static bool is_repeated(const ElementRow& row, Seen& seen) {
        return std::exchange(seen.at(static_cast<std::size_t>(&row - rows.data())), true) && row.single;
    }

    // Known elements of which only some are read, by what they say.
    static bool is_passed_over(pugi::xml_node element) {
        const std::string_view name = local_name(element.name());
        if (name == "description") {
            return local_name(element.parent().name()) != "productText";
        }
        if (name == "version") {
            return std::string_view(element.attribute("versionType").value()) != "FW";
        }
        if (name == "characteristic") {
            const std::string label = label_of(Source::child(element, "characteristicName"));
            return label != comments_characteristic && label != protocol_characteristic;
        }
        if (name == "allowedValues") {
            const auto children = element.children();
            const auto is_element = [](pugi::xml_node each) { return each.type() == pugi::node_element; };
            return std::count_if(children.begin(), children.end(), is_element) != 1 ||
                   !Source::child(element, "range");
        }
        return false;
    }

    std::map<std::string_view, std::size_t> elements_;
    std::map<std::string_view, std::size_t> attributes_;
    std::size_t comments_ = 0;
    unsigned depth_ = 0;
};

}  // namespace

std::vector<Unread> find_unread(pugi::xml_node root) {
    Finder finder;
    finder.look_into(root);
    return finder.take();
}

}  // namespace cgw::xdd
