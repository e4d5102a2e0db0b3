#include "eds_check/keys.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/ascii.hpp"
#include "dictionary/data_types.hpp"

namespace cgw::eds_check {
namespace {

using eds::SectionKind;

// In the order of their sections.
constexpr std::array key_rows{
    KeyRow{SectionKind::file_info, "FileName", Holds::text, Tail::none, true},
    KeyRow{SectionKind::file_info, "FileVersion", Holds::number, Tail::none, true},
    KeyRow{SectionKind::file_info, "FileRevision", Holds::number, Tail::none, true},
    KeyRow{SectionKind::file_info, "EDSVersion", Holds::text},
    KeyRow{SectionKind::file_info, "Description", Holds::text},
    KeyRow{SectionKind::file_info, "CreationTime", Holds::text},
    KeyRow{SectionKind::file_info, "CreationDate", Holds::text},
    KeyRow{SectionKind::file_info, "CreatedBy", Holds::text},
    KeyRow{SectionKind::file_info, "ModificationTime", Holds::text},
    KeyRow{SectionKind::file_info, "ModificationDate", Holds::text},
    KeyRow{SectionKind::file_info, "ModifiedBy", Holds::text},
    KeyRow{SectionKind::file_info, "LastEDS", Holds::text},

    KeyRow{SectionKind::device_info, "VendorName", Holds::text, Tail::none, true},
    KeyRow{SectionKind::device_info, "VendorNumber", Holds::number, Tail::none, true},
    KeyRow{SectionKind::device_info, "ProductName", Holds::text, Tail::none, true},
    KeyRow{SectionKind::device_info, "ProductNumber", Holds::number, Tail::none, true},
    KeyRow{SectionKind::device_info, "RevisionNumber", Holds::number, Tail::none, true},
    KeyRow{SectionKind::device_info, "OrderCode", Holds::text},
    KeyRow{SectionKind::device_info, "BaudRate_10"},
    KeyRow{SectionKind::device_info, "BaudRate_20"},
    KeyRow{SectionKind::device_info, "BaudRate_50"},
    KeyRow{SectionKind::device_info, "BaudRate_125"},
    KeyRow{SectionKind::device_info, "BaudRate_250"},
    KeyRow{SectionKind::device_info, "BaudRate_500"},
    KeyRow{SectionKind::device_info, "BaudRate_800"},
    KeyRow{SectionKind::device_info, "BaudRate_1000"},
    KeyRow{SectionKind::device_info, "SimpleBootUpMaster"},
    KeyRow{SectionKind::device_info, "SimpleBootUpSlave"},
    KeyRow{SectionKind::device_info, "Granularity"},
    KeyRow{SectionKind::device_info, "DynamicChannelsSupported"},
    KeyRow{SectionKind::device_info, "GroupMessaging"},
    KeyRow{SectionKind::device_info, "NrOfRXPDO", Holds::number, Tail::none, true},
    KeyRow{SectionKind::device_info, "NrOfTXPDO", Holds::number, Tail::none, true},
    KeyRow{SectionKind::device_info, "LSS_Supported"},
    KeyRow{SectionKind::device_info, "CompactPDO"},

    KeyRow{SectionKind::commissioning, "NodeID"},
    KeyRow{SectionKind::commissioning, "NodeName", Holds::text},
    KeyRow{SectionKind::commissioning, "Baudrate"},
    KeyRow{SectionKind::commissioning, "NetNumber"},
    KeyRow{SectionKind::commissioning, "NetworkName", Holds::text},
    KeyRow{SectionKind::commissioning, "CANopenManager"},
    KeyRow{SectionKind::commissioning, "LSS_SerialNumber"},

    KeyRow{SectionKind::dummy_usage, "Dummy", Holds::number, Tail::type_number},

    KeyRow{SectionKind::comments, "Lines"},
    KeyRow{SectionKind::comments, "Line", Holds::text, Tail::number},

    KeyRow{SectionKind::mandatory_objects, "SupportedObjects", Holds::number, Tail::none, true},
    KeyRow{SectionKind::mandatory_objects, "", Holds::number, Tail::number},
    KeyRow{SectionKind::optional_objects, "SupportedObjects", Holds::number, Tail::none, true},
    KeyRow{SectionKind::optional_objects, "", Holds::number, Tail::number},
    KeyRow{SectionKind::manufacturer_objects, "SupportedObjects", Holds::number, Tail::none, true},
    KeyRow{SectionKind::manufacturer_objects, "", Holds::number, Tail::number},

    KeyRow{SectionKind::supported_modules, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::connected_modules, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::connected_modules, "", Holds::number, Tail::number},

    KeyRow{SectionKind::dynamic_channels, "NrOfSeg", Holds::number, Tail::none, true},
    KeyRow{SectionKind::dynamic_channels, "Type", Holds::number, Tail::number},
    KeyRow{SectionKind::dynamic_channels, "Dir", Holds::number, Tail::number},
    KeyRow{SectionKind::dynamic_channels, "Range", Holds::number, Tail::number},
    KeyRow{SectionKind::dynamic_channels, "PPOffset", Holds::number, Tail::number},

    KeyRow{SectionKind::tools, "Items"},

    KeyRow{SectionKind::object, "ParameterName", Holds::text},
    KeyRow{SectionKind::object, "ObjectType"},
    KeyRow{SectionKind::object, "DataType"},
    KeyRow{SectionKind::object, "AccessType", Holds::text},
    KeyRow{SectionKind::object, "DefaultValue", Holds::value},
    KeyRow{SectionKind::object, "PDOMapping"},
    KeyRow{SectionKind::object, "SubNumber"},
    KeyRow{SectionKind::object, "LowLimit", Holds::value},
    KeyRow{SectionKind::object, "HighLimit", Holds::value},
    KeyRow{SectionKind::object, "ObjFlags"},
    KeyRow{SectionKind::object, "CompactSubObj"},
    KeyRow{SectionKind::object, "ParameterValue", Holds::value},
    KeyRow{SectionKind::object, "Denotation", Holds::text},
    KeyRow{SectionKind::object, "UploadFile", Holds::text},
    KeyRow{SectionKind::object, "DownloadFile", Holds::text},

    KeyRow{SectionKind::names, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::names, "", Holds::text, Tail::number},
    KeyRow{SectionKind::values, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::values, "", Holds::value, Tail::number},
    KeyRow{SectionKind::denotations, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::denotations, "", Holds::text, Tail::number},
    KeyRow{SectionKind::object_links, "ObjectLinks", Holds::number, Tail::none, true},
    KeyRow{SectionKind::object_links, "", Holds::number, Tail::number},

    KeyRow{SectionKind::module_info, "ProductName", Holds::text},
    KeyRow{SectionKind::module_info, "ProductVersion"},
    KeyRow{SectionKind::module_info, "ProductRevision"},
    KeyRow{SectionKind::module_info, "OrderCode", Holds::text},
    KeyRow{SectionKind::module_comments, "Lines"},
    KeyRow{SectionKind::module_comments, "Line", Holds::text, Tail::number},
    KeyRow{SectionKind::module_fixed_objects, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::module_fixed_objects, "", Holds::number, Tail::number},
    KeyRow{SectionKind::module_sub_extends, "NrOfEntries", Holds::number, Tail::none, true},
    KeyRow{SectionKind::module_sub_extends, "", Holds::number, Tail::number},
    KeyRow{SectionKind::module_sub_extension, "ParameterName", Holds::text},
    KeyRow{SectionKind::module_sub_extension, "ObjectType"},
    KeyRow{SectionKind::module_sub_extension, "DataType"},
    KeyRow{SectionKind::module_sub_extension, "AccessType", Holds::text},
    KeyRow{SectionKind::module_sub_extension, "DefaultValue", Holds::value},
    KeyRow{SectionKind::module_sub_extension, "PDOMapping"},
    KeyRow{SectionKind::module_sub_extension, "LowLimit", Holds::value},
    KeyRow{SectionKind::module_sub_extension, "HighLimit", Holds::value},
    KeyRow{SectionKind::module_sub_extension, "ObjFlags"},
    KeyRow{SectionKind::module_sub_extension, "Count"},
    KeyRow{SectionKind::module_sub_extension, "ObjExtend"},
};

bool is_tail(Tail tail, std::string_view text) {
    constexpr std::size_t type_digits = 4;
    switch (tail) {
        case Tail::none:
            return text.empty();
        case Tail::number:
            return base::consists_of(text, base::digits);
        case Tail::type_number:
            return text.size() == type_digits && base::consists_of(text, base::hexadecimal_digits) &&
                   dictionary::find_type(std::stoul(std::string(text), nullptr, 16)) != nullptr;
    }
    return false;
}

// Which keys a section of this kind has is said of another kind.
SectionKind model_of(SectionKind kind) {
    return kind == SectionKind::sub_object ? SectionKind::object : kind;
}

constexpr std::size_t kinds = static_cast<std::size_t>(SectionKind::module_sub_extension) + 1;

// Looked up for every line of a file.
const std::array<std::span<const KeyRow>, kinds> ranges = [] {
    std::array<std::span<const KeyRow>, kinds> result;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const SectionKind wanted = model_of(static_cast<SectionKind>(kind));
        const auto same = [wanted](const KeyRow& row) { return row.kind == wanted; };
        const auto* const begin = std::find_if(key_rows.begin(), key_rows.end(), same);
        result[kind] = {begin, std::find_if_not(begin, key_rows.end(), same)};
    }
    return result;
}();

}  // namespace

std::span<const KeyRow> rows_of(SectionKind kind) {
    return ranges[static_cast<std::size_t>(kind)];
}

const KeyRow* find_key(SectionKind kind, std::string_view key) {
    for (const KeyRow& row : rows_of(kind)) {
        if (key.size() >= row.name.size() && is_tail(row.tail, key.substr(row.name.size())) &&
            base::equal_ignoring_case(key.substr(0, row.name.size()), row.name)) {
            return &row;
        }
    }
    return nullptr;
}

bool is_spelt_as(const KeyRow& row, std::string_view key) {
    return key.starts_with(row.name);
}

}  // namespace cgw::eds_check
