// One variable of a device: what its object says, and what its parameter does.
#include <fmt/format.h>

#include <array>

#include "base/ascii.hpp"
#include "diagnostic/rules/xdd.hpp"
#include "dictionary/data_types.hpp"
#include "eds/words.hpp"
#include "xdd/reading.hpp"
#include "xdd/words.hpp"

namespace cgw::xdd {
namespace {

namespace rules = diagnostic::rules;
using dictionary::TypeRow;
using dictionary::Value;
using dictionary::Variable;
using object::Access;
using object::ObjectCode;

class VariableReader {
  public:
    VariableReader(Source& source, const Parameters& parameters) : source_(source), parameters_(parameters) {}

    std::optional<Variable> read(const Element& here, ObjectCode code) {
        const TypeRow* const type = type_of(here, code);
        if (type == nullptr) {
            return std::nullopt;
        }
        const std::optional<Access> access =
            code == ObjectCode::type_definition ? Access::ro : access_of(here);
        if (!access) {
            return std::nullopt;
        }
        Variable variable;
        variable.type = type->type;
        variable.access = *access;
        variable.pdo_mapping = is_mapped(here);
        variable.flags =
            static_cast<std::uint32_t>(source_.hexadecimal(here.object, "objFlags", 0xFFFFFFFF).value_or(0));
        const auto default_value = value_of(here, "defaultValue", *type);
        variable.no_default = !default_value;
        variable.default_value = default_value.value_or(Value{});
        variable.parameter_value = value_of(here, "actualValue", *type);
        read_limits(here, *type, variable);
        variable.denotation = denotation_of(parameters_, here);
        return variable;
    }

  private:
    const TypeRow* type_of(const Element& here, ObjectCode code) {
        const TypeRow* const of_parameter = parameters_.type(here.parameter);
        const pugi::xml_attribute attribute = here.object.attribute("dataType");
        const auto number = source_.hexadecimal(here.object, "dataType", 0xFFFF);
        if (!number) {
            if (of_parameter == nullptr && code == ObjectCode::domain) {
                return &dictionary::row_of(object::DataType::domain);
            }
            if (of_parameter != nullptr || *attribute.value() != '\0') {
                return of_parameter;
            }
            const bool has_lost_parameter = here.object.attribute("uniqueIDRef") && !here.parameter;
            if (has_lost_parameter || parameters_.names_type(here.parameter)) {
                source_.report(rules::xdd_absent, here.object,
                               fmt::format("{} has no data type that stands in the file; it is left out",
                                           element_name(here.object)));
                return nullptr;
            }
            source_.report(rules::xdd_no_type, here.object,
                           fmt::format("{} {}; it is read as DOMAIN", element_name(here.object),
                                       parameters_.is_bit_string(here.parameter)
                                           ? "is a BITSTRING, which has no length, and states no dataType"
                                           : "has no data type, and neither has a parameter of it"));
            return &dictionary::row_of(object::DataType::domain);  // D74
        }
        const TypeRow* const type = dictionary::find_type(*number);
        if (type == nullptr) {
            source_.report(rules::xdd_data_type, here.object, attribute,
                           fmt::format("{}, which is no data type of CiA 301; {} is left out",
                                       quoted(attribute), element_name(here.object)));
        } else if (of_parameter != nullptr && of_parameter != type) {
            source_.report(rules::xdd_contradiction, here.object, attribute,
                           fmt::format("{}, {}, and its parameter is of type {}; the object counts",
                                       quoted(attribute), type->name, of_parameter->name));
        }
        return type;
    }

    // rwr and rww are what the parameter, or the mapping, says of an object that is rw.
    std::optional<Access> access_of(const Element& here) {
        const std::optional<Access> of_object = object_access(here.object);
        const std::optional<Access> of_parameter = parameter_access(here);
        if (!of_object && !of_parameter && !here.parameter) {
            if (*here.object.attribute("accessType").value() == '\0') {
                source_.report(
                    rules::xdd_absent, here.object,
                    fmt::format("{} has no accessType; it is left out", element_name(here.object)));
            }
            return std::nullopt;
        }
        if (!of_object || !of_parameter) {
            return refined(here.object, of_object ? *of_object : of_parameter.value_or(Access::ro));
        }
        if (!agree(*of_object, *of_parameter)) {
            const AccessWords& words = access_words.at(static_cast<std::size_t>(*of_parameter));
            source_.report(rules::xdd_contradiction, here.object, here.object.attribute("accessType"),
                           fmt::format("{}, and access of its parameter is {}; the object counts",
                                       quoted(here.object.attribute("accessType")), words.parameter));
            return refined(here.object, *of_object);
        }
        return refined(here.object, *of_object == Access::rw ? *of_parameter : *of_object);
    }

    // A tool that has no word for const writes read.
    static bool agree(Access a, Access b) {
        const auto without_shade = [](Access each) {
            return each == Access::constant                     ? Access::ro
                   : each == Access::rwr || each == Access::rww ? Access::rw
                                                                : each;
        };
        return without_shade(a) == without_shade(b);
    }

    static Access refined(pugi::xml_node object, Access access) {
        const std::string_view mapping = object.attribute("PDOmapping").value();
        if (access != Access::rw) {
            return access;
        }
        return mapping == "TPDO" ? Access::rwr : mapping == "RPDO" ? Access::rww : Access::rw;
    }

    // Also in the words of an EDS, rwr and rww.
    std::optional<Access> object_access(pugi::xml_node object) {
        const pugi::xml_attribute attribute = object.attribute("accessType");
        const std::string_view word = attribute.value();
        for (std::size_t i = 0; i < eds::access_types.size(); ++i) {
            if (eds::access_types[i].size() == word.size() &&
                base::equal_ignoring_case(eds::access_types[i], word)) {
                return static_cast<Access>(i);
            }
        }
        if (!word.empty()) {
            source_.report(rules::xdd_access, object, attribute,
                           fmt::format("{}; it can be ro, wo, rw or const{}", quoted(attribute),
                                       object.attribute("uniqueIDRef") ? "" : "; the object is left out"));
        }
        return std::nullopt;
    }

    std::optional<Access> parameter_access(const Element& here) {
        const std::string_view word = parameters_.access(here.parameter);
        if (word.empty()) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < access_words.size(); ++i) {
            if (access_words[i].parameter == word) {
                return static_cast<Access>(i);
            }
        }
        const pugi::xml_attribute attribute = here.parameter.attribute("access");
        if (word == "noAccess") {
            source_.report(rules::xdd_no_access, here.parameter, attribute,
                           "a parameter without access is read as ro");
            return Access::ro;
        }
        source_.report(rules::xdd_access, here.parameter, attribute,
                       fmt::format("access is {}; it can be read, write, readWrite, readWriteInput, "
                                   "readWriteOutput, const or noAccess",
                                   quoted(word)));
        return std::nullopt;
    }

    bool is_mapped(const Element& here) {
        const pugi::xml_attribute attribute = here.object.attribute("PDOmapping");
        const std::string_view word = attribute.value();
        for (const std::string_view known : {"default", "optional", "TPDO", "RPDO"}) {
            if (word == known) {
                return true;
            }
        }
        if (!word.empty() && word != "no") {
            source_.report(
                rules::xdd_value, here.object, attribute,
                fmt::format("{}; it can be no, default, optional, TPDO or RPDO", quoted(attribute)));
        }
        return false;
    }

    // Of the object, or of the parameter's child element of the same name.
    std::optional<Value> value_of(const Element& here, const char* name, const TypeRow& type) {
        const pugi::xml_node child = parameters_.child(here.parameter, name);
        const std::optional<Value> of_object = source_.value(here.object, name, type);
        const std::optional<Value> of_parameter = child ? source_.value(child, "value", type) : std::nullopt;
        if (of_object && of_parameter && *of_object != *of_parameter) {
            source_.report(rules::xdd_contradiction, here.object, here.object.attribute(name),
                           fmt::format("{}, and {} of its parameter is {}; the object counts",
                                       quoted(here.object.attribute(name)), name,
                                       quoted(child.attribute("value").value())));
        }
        return of_object ? of_object : of_parameter;
    }

    // A list of single values, or of several ranges, is no limit.
    void read_limits(const Element& here, const TypeRow& type, Variable& variable) {
        variable.low_limit = source_.value(here.object, "lowLimit", type);
        variable.high_limit = source_.value(here.object, "highLimit", type);
        const pugi::xml_node allowed = parameters_.child(here.parameter, "allowedValues");
        const pugi::xml_node range = Source::child(allowed, "range");
        std::size_t count = 0;
        for (const pugi::xml_node child : allowed.children()) {
            count += child.type() == pugi::node_element ? 1U : 0U;
        }
        if (!range || count != 1 || variable.low_limit || variable.high_limit) {
            return;
        }
        variable.low_limit = source_.value(Source::child(range, "minValue"), "value", type);
        variable.high_limit = source_.value(Source::child(range, "maxValue"), "value", type);
    }

    static std::string element_name(pugi::xml_node object) {
        const pugi::xml_attribute index = object.attribute("index");
        return index ? fmt::format("object {}", quoted(index.value()))
                     : fmt::format("sub-object {} of {}", quoted(object.attribute("subIndex").value()),
                                   quoted(object.parent().attribute("index").value()));
    }

    Source& source_;
    const Parameters& parameters_;
};

}  // namespace

std::string name_of(const Element& here) {
    const pugi::xml_attribute name = here.object.attribute("name");
    return name ? name.value() : label_of(here.parameter);
}

std::string denotation_of(const Parameters& parameters, const Element& here) {
    const pugi::xml_attribute denotation = here.object.attribute("denotation");
    return denotation ? denotation.value() : label_of(parameters.child(here.parameter, "denotation"));
}

std::optional<Variable> read_variable(Source& source, const Parameters& parameters, const Element& here,
                                      ObjectCode code) {
    return VariableReader(source, parameters).read(here, code);
}

}  // namespace cgw::xdd
