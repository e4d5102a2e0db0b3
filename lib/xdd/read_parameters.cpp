#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "diagnostic/rules/xdd.hpp"
#include "xdd/reading.hpp"
#include "xdd/words.hpp"

namespace cgw::xdd {
namespace {

constexpr unsigned deepest_type = 8;
constexpr std::size_t most_looked_through = 64U * 1024U * 1024U;

struct List {
    std::string_view list;
    std::string_view element;
};

// What has a uniqueID that something read here refers to.
constexpr std::array lists{
    List{"dataTypeList", "derived"},
    List{"dataTypeList", "enum"},
    List{"templateList", "parameterTemplate"},
    List{"parameterList", "parameter"},
};

}  // namespace

std::string label_of(pugi::xml_node element) {
    return Source::child(element, "label").text().get();
}

Parameters::Parameters(Source& source, pugi::xml_node device_body) : source_(source) {
    Source::each_child(device_body, "ApplicationProcess", [this](pugi::xml_node process) {
        for (const List& row : lists) {
            Source::each_child(Source::child(process, row.list), row.element, [this](pugi::xml_node each) {
                const pugi::xml_attribute id = each.attribute("uniqueID");
                const bool is_new = !id || by_id_.emplace(id.value(), Named{each, length_of(each)}).second;
                if (!is_new) {
                    source_.report(diagnostic::rules::xdd_twice, each, id,
                                   fmt::format("{} is the uniqueID of another element already; this one is "
                                               "not read",
                                               quoted(id.value())));
                }
            });
        }
    });
}

pugi::xml_node Parameters::find(const char* id) const {
    const auto found = by_id_.find(id);
    return found != by_id_.end() && looked_through_ <= most_looked_through ? found->second.element
                                                                           : pugi::xml_node();
}

void Parameters::charge(const char* id) const {
    const auto found = by_id_.find(id);
    if (found == by_id_.end() || looked_through_ > most_looked_through) {
        return;
    }
    looked_through_ += found->second.length;
    if (looked_through_ > most_looked_through) {
        source_.report_whole_file(
            diagnostic::rules::xdd_reference,
            fmt::format(
                "objects refer to long parameters so often that more than {} MiB would have to be read; "
                "what they say is left out from here on",
                most_looked_through / 1024 / 1024));
    }
}

// From its name to that of the element behind it.
std::size_t Parameters::length_of(pugi::xml_node element) const {
    for (pugi::xml_node at = element; at; at = at.parent()) {
        if (const pugi::xml_node next = at.next_sibling()) {
            return static_cast<std::size_t>(
                std::max<std::ptrdiff_t>(next.offset_debug() - element.offset_debug(), 0));
        }
    }
    return source_.length() - static_cast<std::size_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0));
}

pugi::xml_node Parameters::of(pugi::xml_node object) {
    const pugi::xml_attribute reference = object.attribute("uniqueIDRef");
    if (!reference || *reference.value() == '\0') {
        return {};
    }
    charge(reference.value());
    const pugi::xml_node parameter = find(reference.value());
    if (!parameter) {
        source_.report(diagnostic::rules::xdd_reference, object, reference,
                       fmt::format("{} names no parameter of this file", quoted(reference.value())));
    }
    charge(parameter.attribute("templateIDRef").value());
    return parameter;
}

pugi::xml_node Parameters::template_of(pugi::xml_node parameter) const {
    return find(parameter.attribute("templateIDRef").value());
}

pugi::xml_node Parameters::child(pugi::xml_node parameter, std::string_view name) const {
    const pugi::xml_node own = Source::child(parameter, name);
    return own ? own : Source::child(template_of(parameter), name);
}

std::string_view Parameters::access(pugi::xml_node parameter) const {
    for (const pugi::xml_node each : {parameter, template_of(parameter)}) {
        const pugi::xml_attribute access = each.attribute("access");
        if (access && *access.value() != '\0') {
            return access.value();
        }
    }
    return "";
}

const dictionary::TypeRow* Parameters::type_in(pugi::xml_node element, unsigned depth) const {
    for (const pugi::xml_node child : element.children()) {
        const std::string_view name = local_name(child.name());
        const auto* const row =
            std::find_if(elementary_types.begin(), elementary_types.end(),
                         [name](const ElementaryType& each) { return each.element == name; });
        if (row != elementary_types.end()) {
            return &dictionary::row_of(row->type);
        }
        if (name == "dataTypeIDRef" && depth < deepest_type) {
            charge(child.attribute("uniqueIDRef").value());
            return type_in(find(child.attribute("uniqueIDRef").value()), depth + 1);
        }
    }
    return nullptr;
}

const dictionary::TypeRow* Parameters::type(pugi::xml_node parameter) const {
    const dictionary::TypeRow* const own = type_in(parameter, 0);
    return own != nullptr ? own : type_in(template_of(parameter), 0);
}

bool Parameters::is_bit_string(pugi::xml_node parameter) const {
    return Source::child(parameter, type_without_width) ||
           Source::child(template_of(parameter), type_without_width);
}

bool Parameters::names_type(pugi::xml_node parameter) const {
    return Source::child(parameter, "dataTypeIDRef") ||
           Source::child(template_of(parameter), "dataTypeIDRef");
}

}  // namespace cgw::xdd
