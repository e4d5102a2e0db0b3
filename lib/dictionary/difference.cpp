#include "dictionary/difference.hpp"

#include <fmt/format.h>

#include "dictionary/data_types.hpp"
#include "dictionary/difference_rows.hpp"
#include "dictionary/value_text.hpp"

namespace cgw::dictionary {
namespace {

constexpr std::string_view missing = "missing";

std::string sub_index_count(std::size_t count) {
    return fmt::format("{} sub-ind{}", count, count == 1 ? "ex" : "ices");
}

// Whether equal variables mean the same is seen without making texts of them.
bool plainly_same(const Variable& a, const Variable& b, bool same_node) {
    return same_node && a == b;
}

class Comparer {
  public:
    Comparer(const Side& a, const Side& b, const DifferenceOptions& options)
        : a_(a), b_(b), bare_(a.bare || b.bare) {
        const std::optional<std::uint8_t> either = a.node_id ? a.node_id : b.node_id;
        node_a_ = options.node_id ? options.node_id : a.node_id ? a.node_id : either;
        node_b_ = options.node_id ? options.node_id : b.node_id ? b.node_id : either;
    }

    Differences run() {
        if (bare_) {
            result_.not_compared = {"device information", "names", "object types", "limits", "ObjFlags"};
        } else {
            compare_rows<DeviceInformation>(device_rows(), a_.dictionary.device, b_.dictionary.device);
            report_if({"dummies", "data types for dummy mapping"}, dummies_text(a_.dictionary),
                      dummies_text(b_.dictionary));
            compare_nodes();
        }
        compare_objects(a_.dictionary.objects, b_.dictionary.objects);
        if (!bare_) {
            compare_modules();
        }
        return std::move(result_);
    }

  private:
    void report_if(Difference difference, std::string a, std::string b) {
        if (a != b) {
            difference.a = std::move(a);
            difference.b = std::move(b);
            result_.all.push_back(std::move(difference));
        }
    }

    template <typename Of>
    void compare_rows(std::span<const AspectRow<Of>> rows, const Of& a, const Of& b,
                      const Difference& place = {}) {
        for (const AspectRow<Of>& row : rows) {
            if (row.in_bare || !bare_) {
                Difference difference = place;
                difference.aspect = row.name;
                difference.aspect_text = row.text;
                report_if(std::move(difference), row.value(a), row.value(b));
            }
        }
    }

    bool both_configured() const { return a_.commissioning != nullptr && b_.commissioning != nullptr; }

    void compare_nodes() {
        if (both_configured()) {
            compare_rows<Commissioning>(node_rows(), *a_.commissioning, *b_.commissioning);
        } else if (has_modules(a_) || has_modules(b_)) {
            result_.not_compared.emplace_back("connected modules");
        }
    }

    static bool has_modules(const Side& side) {
        return side.commissioning != nullptr && !side.commissioning->connected_modules.empty();
    }

    // Both ascending; calls `only_a`, `only_b` or `both` for each item.
    template <typename Item, typename Key, typename OnlyA, typename OnlyB, typename Both>
    static void merge(const std::vector<Item>& a, const std::vector<Item>& b, Key key, OnlyA only_a,
                      OnlyB only_b, Both both) {
        auto of_a = a.begin();
        auto of_b = b.begin();
        while (of_a != a.end() || of_b != b.end()) {
            if (of_b == b.end() || (of_a != a.end() && (*of_a).*key < (*of_b).*key)) {
                only_a(*of_a++);
            } else if (of_a == a.end() || (*of_b).*key < (*of_a).*key) {
                only_b(*of_b++);
            } else {
                both(*of_a++, *of_b++);
            }
        }
    }

    static std::string object_summary(const Object& object) {
        return object::has_sub_objects(object.code) ? fmt::format("{} of {}", object_code_text(object.code),
                                                                  sub_index_count(object.variables.size()))
                                                    : std::string(object_code_text(object.code));
    }

    void compare_objects(const std::vector<Object>& a, const std::vector<Object>& b) {
        const auto only = [this](const Object& object, std::string text_a, std::string text_b) {
            result_.all.push_back(
                {"object", "object", object.index, {}, object.name, std::move(text_a), std::move(text_b)});
        };
        merge(
            a, b, &Object::index,
            [&](const Object& object) { only(object, object_summary(object), std::string(missing)); },
            [&](const Object& object) { only(object, std::string(missing), object_summary(object)); },
            [&](const Object& of_a, const Object& of_b) { compare_object(of_a, of_b); });
    }

    void compare_object(const Object& a, const Object& b) {
        const std::string& name = a.name.empty() ? b.name : a.name;
        const bool subs = object::has_sub_objects(a.code) || object::has_sub_objects(b.code);
        const Difference place{{}, {}, a.index, {}, name};
        compare_rows<Object>(object_rows(), a, b, place);
        if (subs) {
            compare_rows<Object>(sub_object_rows(), a, b, place);
        }
        if (both_configured()) {
            compare_rows<Object>(configured_object_rows(), a, b, place);
        }
        merge(
            a.variables, b.variables, &Variable::sub_index,
            [&](const Variable& variable) { only_one(a.index, variable, true); },
            [&](const Variable& variable) { only_one(a.index, variable, false); },
            [&](const Variable& of_a, const Variable& of_b) { compare_variable(a.index, of_a, of_b, subs); });
    }

    void only_one(std::uint16_t index, const Variable& variable, bool in_a) {
        std::string there = std::string(row_of(variable.type).name);
        Difference difference{"sub-object", "sub-object", index, variable.sub_index, variable.name};
        difference.a = in_a ? there : std::string(missing);
        difference.b = in_a ? std::string(missing) : there;
        result_.all.push_back(std::move(difference));
    }

    void compare_variable(std::uint16_t index, const Variable& a, const Variable& b, bool sub_object) {
        if (plainly_same(a, b, node_a_ == node_b_)) {
            return;
        }
        Difference place{{}, {}, index, {}, a.name.empty() ? b.name : a.name};
        if (sub_object) {
            place.sub_index = a.sub_index;
        }
        const Place at_a{index, a, node_a_};
        const Place at_b{index, b, node_b_};
        compare_rows<Place>(variable_rows(), at_a, at_b, place);
        if (sets_value(at_a) || sets_value(at_b)) {
            compare_rows<Place>(set_value_rows(), at_a, at_b, place);
        }
        if (both_configured()) {
            compare_rows<Place>(configured_variable_rows(), at_a, at_b, place);
        }
    }

    void compare_modules() {
        const auto place = [](const Module& module) {
            return Difference{"module", "module", {}, {}, fmt::format("module {}", module.number)};
        };
        merge(
            a_.dictionary.modules, b_.dictionary.modules, &Module::number,
            [&](const Module& module) {
                report_if(place(module), module.product_name, std::string(missing));
            },
            [&](const Module& module) {
                report_if(place(module), std::string(missing), module.product_name);
            },
            [&](const Module& of_a, const Module& of_b) {
                compare_rows<Module>(module_rows(), of_a, of_b, place(of_a));
                const bool same_objects =
                    of_a.fixed_objects == of_b.fixed_objects && of_a.extensions == of_b.extensions;
                report_if(place(of_a), "its objects", same_objects ? "its objects" : "other objects");
            });
    }

    const Side& a_;
    const Side& b_;
    bool bare_;
    std::optional<std::uint8_t> node_a_;
    std::optional<std::uint8_t> node_b_;
    Differences result_;
};

}  // namespace

Differences differences(const Side& a, const Side& b, const DifferenceOptions& options) {
    return Comparer(a, b, options).run();
}

}  // namespace cgw::dictionary
