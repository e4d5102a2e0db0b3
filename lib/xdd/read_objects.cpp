// The objects of a device, and which sub-objects they have.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "diagnostic/rules/xdd.hpp"
#include "xdd/reading.hpp"

namespace cgw::xdd {
namespace {

namespace rules = diagnostic::rules;
using dictionary::Object;
using dictionary::Variable;
using object::ObjectCode;

constexpr std::array object_codes{
    ObjectCode::null, ObjectCode::domain, ObjectCode::type_definition, ObjectCode::structure_definition,
    ObjectCode::var,  ObjectCode::array,  ObjectCode::record};

class ObjectReader {
  public:
    ObjectReader(Source& source, Parameters& parameters) : source_(source), parameters_(parameters) {}

    std::vector<Object> read(pugi::xml_node list) {
        std::vector<Object> objects;
        std::array<bool, 0x10000> taken{};
        Source::each_child(list, "CANopenObject", [&](pugi::xml_node element) {
            const auto index = required(element, "index", 0xFFFF);
            if (!index || is_taken(taken[*index], element, "index")) {
                return;
            }
            Object object;
            object.index = static_cast<std::uint16_t>(*index);
            if (read_object(element, object)) {
                objects.push_back(std::move(object));
            }
        });
        std::sort(objects.begin(), objects.end(),
                  [](const Object& a, const Object& b) { return a.index < b.index; });
        return objects;
    }

  private:
    std::optional<std::uint64_t> required(pugi::xml_node element, const char* name, std::uint64_t highest) {
        const auto number = source_.hexadecimal(element, name, highest);
        if (!number && *element.attribute(name).value() == '\0') {
            source_.report(rules::xdd_absent, element,
                           fmt::format("{} has no {}; it is left out", local_name(element.name()), name));
        }
        return number;
    }

    bool is_taken(bool& taken, pugi::xml_node element, const char* name) {
        if (taken) {
            const pugi::xml_attribute attribute = element.attribute(name);
            source_.report(
                rules::xdd_twice, element, attribute,
                fmt::format("{}: this stands in the file already, and is not read again", quoted(attribute)));
        }
        return std::exchange(taken, true);
    }

    // False for an object without data, or after a finding.
    bool read_object(pugi::xml_node element, Object& object) {
        const Element here{element, parameters_.of(element)};
        object.name = name_of(here);
        object.code = code_of(element);
        if (object.code == ObjectCode::null) {
            return false;
        }
        if (!has_sub_objects(object.code)) {
            std::optional<Variable> variable = read_variable(source_, parameters_, here, object.code);
            if (variable) {
                variable->name = object.name;
                object.variables.push_back(std::move(*variable));
            }
            return variable.has_value();
        }
        object.flags =
            static_cast<std::uint32_t>(source_.hexadecimal(element, "objFlags", 0xFFFFFFFF).value_or(0));
        object.denotation = denotation_of(parameters_, here);
        read_sub_objects(element, object);
        return true;
    }

    void read_sub_objects(pugi::xml_node element, Object& object) {
        std::array<bool, 0x100> taken{};
        std::size_t count = 0;
        Source::each_child(element, "CANopenSubObject", [&](pugi::xml_node sub) {
            ++count;
            const auto sub_index = required(sub, "subIndex", 0xFF);
            if (!sub_index || is_taken(taken[*sub_index], sub, "subIndex")) {
                return;
            }
            const Element here{sub, parameters_.of(sub)};
            std::optional<Variable> variable = read_variable(source_, parameters_, here, sub_code_of(sub));
            if (variable) {
                variable->sub_index = static_cast<std::uint8_t>(*sub_index);
                variable->name = name_of(here);
                object.variables.push_back(std::move(*variable));
            }
        });
        std::sort(object.variables.begin(), object.variables.end(),
                  [](const Variable& a, const Variable& b) { return a.sub_index < b.sub_index; });
        const pugi::xml_attribute stated = element.attribute("subNumber");
        const auto number = source_.number(element, "subNumber", 0xFF);
        if (number && *number != count) {
            source_.report(rules::xdd_sub_number, element, stated,
                           fmt::format("{}, and {} sub-object{} there", quoted(stated), count,
                                       count == 1 ? " stands" : "s stand"));
        }
    }

    std::optional<ObjectCode> stated_code(pugi::xml_node element) {
        const auto number = source_.number(element, "objectType", 0xFF);
        if (!number) {
            return std::nullopt;
        }
        const auto* const code = std::find_if(object_codes.begin(), object_codes.end(), [&](ObjectCode each) {
            return static_cast<std::uint64_t>(each) == *number;
        });
        if (code == object_codes.end()) {
            const pugi::xml_attribute attribute = element.attribute("objectType");
            source_.report(rules::xdd_object_type, element, attribute,
                           fmt::format("{}, which is no object type of CiA 301", quoted(attribute)));
            return std::nullopt;
        }
        return *code;
    }

    ObjectCode sub_code_of(pugi::xml_node sub) {
        const ObjectCode code = stated_code(sub).value_or(ObjectCode::var);
        if (code != ObjectCode::var && code != ObjectCode::domain) {
            const pugi::xml_attribute stated = sub.attribute("objectType");
            source_.report(rules::xdd_sub_object_type, sub, stated,
                           fmt::format("{}; a sub-object is 7 (VAR) or 2 (DOMAIN)", quoted(stated)));
            return ObjectCode::var;
        }
        return code;
    }

    ObjectCode code_of(pugi::xml_node element) {
        const std::optional<ObjectCode> stated = stated_code(element);
        if (!Source::child(element, "CANopenSubObject") || (stated && has_sub_objects(*stated))) {
            return stated.value_or(ObjectCode::var);
        }
        source_.report(rules::xdd_object_type, element, element.attribute("objectType"),
                       fmt::format("{}; the object has sub-objects and is read as a record",
                                   stated ? quoted(element.attribute("objectType")) + ", which has none"
                                          : std::string("the objectType is missing")));
        return ObjectCode::record;
    }

    Source& source_;
    Parameters& parameters_;
};

}  // namespace

std::vector<Object> read_objects(Source& source, const Parts& parts, Parameters& parameters) {
    return ObjectReader(source, parameters).read(parts.objects);
}

}  // namespace cgw::xdd
