// The rows of the table of losses.
#include <array>
#include <utility>

#include "convert/losses.hpp"
#include "dictionary/data_types.hpp"
#include "eds/printer.hpp"
#include "xdd/dates.hpp"
#include "xdd/words.hpp"
#include "xdd/xml_printer.hpp"

namespace cgw::convert {
namespace {

using dictionary::Object;
using dictionary::Value;
using dictionary::Variable;

constexpr Media in_sheets = in(Medium::eds) | in(Medium::xdd);
constexpr Media in_xml = in(Medium::xdd) | in(Medium::xdc);
constexpr Media in_sections = in(Medium::eds) | in(Medium::dcf);
constexpr Media in_tables = in(Medium::markdown) | in(Medium::csv);
constexpr Media but_in_dcf = in_sheets | in_xml;

template <typename Visit>
void each_variable(Description& description, Visit visit) {
    for (Object& object : description.dictionary.objects) {
        for (Variable& variable : object.variables) {
            visit(variable);
        }
    }
}

template <typename Items>
std::size_t take_all(Items& items) {
    const std::size_t count = items.size();
    items.clear();
    return count;
}

std::size_t take(std::string& text) {
    return take_all(text) > 0 ? 1 : 0;
}

// Every text but those that objects hold, with the key that an EDS has for it. An object without sub-objects
// has one name.
template <typename Visit>
void each_text_of(std::vector<Object>& objects, Visit visit) {
    for (Object& object : objects) {
        visit("ParameterName", object.name);
        visit("Denotation", object.denotation);
        for (Variable& variable : object.variables) {
            if (has_sub_objects(object.code)) {
                visit("ParameterName", variable.name);
            } else {
                variable.name = object.name;
            }
            visit("Denotation", variable.denotation);
            visit("UploadFile", variable.upload_file);
            visit("DownloadFile", variable.download_file);
        }
    }
}

template <typename Visit>
void each_line(std::vector<std::string>& lines, Visit visit) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        visit("Line" + std::to_string(i + 1), lines[i]);
    }
}

template <typename Visit>
void each_text(Description& description, Visit visit) {
    dictionary::FileInformation& file = description.dictionary.file;
    visit("FileName", file.file_name);
    visit("EDSVersion", file.eds_version);
    visit("Description", file.description);
    visit("CreationTime", file.creation_time);
    visit("CreationDate", file.creation_date);
    visit("CreatedBy", file.created_by);
    visit("ModificationTime", file.modification_time);
    visit("ModificationDate", file.modification_date);
    visit("ModifiedBy", file.modified_by);
    dictionary::DeviceInformation& device = description.dictionary.device;
    visit("VendorName", device.vendor_name);
    visit("ProductName", device.product_name);
    visit("OrderCode", device.order_code);
    if (description.node) {
        visit("LastEDS", description.node->last_eds);
        visit("NodeName", description.node->node_name);
        visit("NetworkName", description.node->network_name);
    }
    each_line(description.dictionary.comments, visit);
    each_text_of(description.dictionary.objects, visit);
    for (dictionary::Module& module : description.dictionary.modules) {
        visit("ProductName", module.product_name);
        visit("OrderCode", module.order_code);
        each_line(module.comments, visit);
        each_text_of(module.fixed_objects, visit);
        for (dictionary::ModuleExtension& extension : module.extensions) {
            visit("ParameterName", extension.variable.name);
        }
    }
}

// Visits variables that hold strings.
template <typename Visit>
void each_string_variable(Description& description, Visit visit) {
    each_variable(description, [&](Variable& variable) {
        const dictionary::TypeKind kind = dictionary::row_of(variable.type).kind;
        if (kind == dictionary::TypeKind::visible_string || kind == dictionary::TypeKind::unicode_string) {
            visit(variable);
        }
    });
}

std::array<std::optional<Value>*, 3> stated_values(Variable& variable) {
    return {&variable.low_limit, &variable.high_limit, &variable.parameter_value};
}

std::size_t change_strings(Description& description, std::string (*changed)(std::string_view)) {
    std::size_t count = 0;
    const auto change = [&](Value& value) {
        std::string text = changed(value.bytes);
        count += text != value.bytes ? 1U : 0U;
        value.bytes = std::move(text);
    };
    each_string_variable(description, [&](Variable& variable) {
        change(variable.default_value);
        for (std::optional<Value>* const value : stated_values(variable)) {
            if (*value) {
                change(**value);
            }
        }
    });
    return count;
}

std::size_t lose_empty_strings(Description& description) {
    std::size_t count = 0;
    each_string_variable(description, [&](Variable& variable) {
        if (!variable.no_default && variable.default_value.bytes.empty()) {
            variable.no_default = true;
            ++count;
        }
        for (std::optional<Value>* const value : stated_values(variable)) {
            if (*value && (*value)->bytes.empty()) {
                value->reset();
                ++count;
            }
        }
    });
    return count;
}

std::size_t lose_links(Description& description) {
    std::size_t count = 0;
    for (Object& object : description.dictionary.objects) {
        count += take_all(object.object_links);
    }
    return count;
}

std::size_t lose_values(Description& description) {
    std::size_t count = 0;
    each_variable(description, [&count](Variable& variable) {
        count += variable.parameter_value ? 1U : 0U;
        variable.parameter_value.reset();
    });
    return count;
}

std::size_t lose_denotations(Description& description) {
    std::size_t count = 0;
    for (Object& object : description.dictionary.objects) {
        count += take(object.denotation);
    }
    each_variable(description, [&count](Variable& variable) { count += take(variable.denotation); });
    return count;
}

std::size_t lose_files(Description& description) {
    std::size_t count = 0;
    each_variable(description, [&count](Variable& variable) {
        count += take(variable.upload_file) + take(variable.download_file);
    });
    return count;
}

std::size_t lose_node(Description& description) {
    const bool is_there = description.node.has_value();
    description.node.reset();
    return is_there ? 1 : 0;
}

std::size_t lose_flags(Description& description) {
    std::size_t count = 0;
    for (Object& object : description.dictionary.objects) {
        count += std::exchange(object.flags, 0) != 0 ? 1U : 0U;
    }
    each_variable(description,
                  [&count](Variable& variable) { count += std::exchange(variable.flags, 0) != 0 ? 1U : 0U; });
    return count;
}

// All of something that stands there once.
template <typename Part>
std::size_t lose_part(Part& part) {
    return std::exchange(part, Part{}) != Part{} ? 1 : 0;
}

std::size_t lose_serial_number(Description& description) {
    return description.node && std::exchange(description.node->serial_number, 0) != 0 ? 1 : 0;
}

std::size_t lose_dummies(Description& description) {
    return std::erase_if(description.dictionary.supported_dummies,
                         [](std::uint8_t type) { return type == 0 || type > xdd::dummy_types; });
}

std::size_t lose_eds_version(Description& description) {
    const std::string standard = dictionary::FileInformation{}.eds_version;
    return std::exchange(description.dictionary.file.eds_version, standard) != standard ? 1 : 0;
}

std::size_t lose_other_dates(Description& description) {
    dictionary::FileInformation& file = description.dictionary.file;
    std::size_t count = 0;
    for (std::string* const date : {&file.creation_date, &file.modification_date}) {
        const std::string again = xdd::eds_date(xdd::xml_date(*date));
        count += std::exchange(*date, again) != again ? 1U : 0U;
    }
    for (std::string* const time : {&file.creation_time, &file.modification_time}) {
        const std::string again = xdd::eds_time(xdd::xml_time(*time));
        count += std::exchange(*time, again) != again ? 1U : 0U;
    }
    return count;
}

std::size_t lose_wide_texts(Description& description) {
    std::size_t count = 0;
    each_text(description, [&count](std::string_view key, std::string& text) {
        const std::string kept = eds::entry_text(key, text);
        count += std::exchange(text, kept) != kept ? 1U : 0U;
    });
    return count;
}

std::size_t lose_line_ends(Description& description) {
    return change_strings(description, eds::entry_value);
}

std::size_t lose_controls(Description& description) {
    std::size_t count = 0;
    each_text(description, [&count](std::string_view, std::string& text) {
        const std::string kept = xdd::xml_text(text);
        count += std::exchange(text, kept) != kept ? 1U : 0U;
    });
    return count + change_strings(description, xdd::xml_text);
}

}  // namespace

std::span<const LossRow> loss_rows() {
    static constexpr std::array rows{
        LossRow{"values that one node is given", in_sheets, lose_values},
        LossRow{"denotations", in_sheets | in_tables, lose_denotations},
        LossRow{"names of files of domains (UploadFile, DownloadFile)", but_in_dcf | in_tables, lose_files},
        LossRow{"name of the data sheet that a configuration comes from (LastEDS)", but_in_dcf | in_tables,
                [](Description& d) { return d.node ? take(d.node->last_eds) : 0; }},
        LossRow{"serial number for LSS", but_in_dcf | in(Medium::csv), lose_serial_number},
        LossRow{"list of connected modules", but_in_dcf | in(Medium::csv),
                [](Description& d) { return d.node ? take_all(d.node->connected_modules) : 0; }},
        LossRow{"node number, name, bit rate and network of one node", in_sheets | in(Medium::csv),
                lose_node},
        LossRow{"modules of a modular device", in_xml | in_tables,
                [](Description& d) { return take_all(d.dictionary.modules); }},
        LossRow{"links between objects (ObjectLinks)", in_xml | in_tables, lose_links},
        LossRow{"dummies of other types than 0001h to 0007h", in_xml | in_tables, lose_dummies},
        LossRow{"CompactPDO; the objects that it stands for are written out", in_xml | in_tables,
                [](Description& d) -> std::size_t {
                    return std::exchange(d.dictionary.device.compact_pdo, 0) != 0 ? 1 : 0;
                }},
        LossRow{"flags (ObjFlags)", in_tables, lose_flags},
        LossRow{"dummies", in_tables,
                [](Description& d) { return take_all(d.dictionary.supported_dummies); }},
        LossRow{"comments", in_tables, [](Description& d) { return take_all(d.dictionary.comments); }},
        LossRow{"vendor, product and features of the device", in(Medium::csv),
                [](Description& d) { return lose_part(d.dictionary.device); }},
        LossRow{"what the file says of itself", in(Medium::csv),
                [](Description& d) { return lose_part(d.dictionary.file); }},
        LossRow{"an EDSVersion that is not 4.0", in_xml, lose_eds_version},
        LossRow{"dates and times that are not mm-dd-yyyy and hh:mmAM", in_xml, lose_other_dates},
        LossRow{"in texts: control characters, and bytes that are not UTF-8, which become Latin-1", in_xml,
                lose_controls},
        LossRow{"in texts: accents and signs beyond ASCII, semicolons, what exceeds a line of 255",
                in_sections, lose_wide_texts},
        LossRow{"in strings that objects hold: line ends, and blanks at the ends",
                in_sections | in(Medium::markdown), lose_line_ends},
        LossRow{"empty strings that objects hold, which become no value", in_sections | in_tables,
                lose_empty_strings},
    };
    return rows;
}

}  // namespace cgw::convert
