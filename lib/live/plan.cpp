#include "live/plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "base/canopen_text.hpp"
#include "facts/communication.hpp"
#include "facts/gateway.hpp"

namespace cgw::live {
namespace {

using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;
using Kind = Question::Kind;

namespace objects = facts::object;

constexpr std::uint8_t vendor_sub = 1;
constexpr std::uint8_t product_sub = 2;
constexpr std::uint8_t revision_sub = 3;

// Objects of CiA 301 that this device has not (D42), and what would follow the last of its kind.
constexpr std::array<std::uint16_t, 13> foreign_objects{
    0x1003, 0x1005, 0x1010, 0x1011, 0x1012, 0x1014, 0x1280, 0x1404, 0x1604, 0x1810, 0x1A10, 0x2006, 0x6000};

// What kind of device it is.
bool identifies(std::uint16_t index, std::uint8_t sub_index) {
    return index == objects::device_type ||
           (index == objects::identity && (sub_index == vendor_sub || sub_index == product_sub));
}

// Version and serial number, of which a file need not know anything.
bool is_specimen(std::uint16_t index, std::uint8_t sub_index) {
    return index == objects::identity && sub_index >= revision_sub;
}

std::string name_of(const Object& object, const Variable& variable) {
    return object.code == object::ObjectCode::var ? object.name
                                                  : fmt::format("{}, {}", object.name, variable.name);
}

Question question(const Object& object, const Variable& variable, std::uint8_t node_id) {
    Question result;
    result.index = object.index;
    result.sub_index = variable.sub_index;
    result.is_variable = object.code == object::ObjectCode::var;
    result.length = object::size_of(variable.type);
    result.name = name_of(object, variable);
    result.expected = static_cast<std::uint32_t>(variable.default_value.resolve(node_id));
    result.identifies = identifies(object.index, variable.sub_index);
    const bool unknown = is_specimen(object.index, variable.sub_index) && result.expected == 0;
    result.kind = variable.run_time || unknown ? Kind::type : Kind::value;
    return result;
}

void ask_values(const Dictionary& dictionary, std::uint8_t node_id, std::vector<Question>& questions) {
    for (const Object& object : dictionary.objects) {
        for (const Variable& variable : object.variables) {
            questions.push_back(question(object, variable, node_id));
        }
    }
    std::stable_partition(questions.begin(), questions.end(), [](const Question& q) { return q.identifies; });
}

bool refuses_writing(const Variable& variable) {
    return variable.access == object::Access::ro || variable.access == object::Access::constant ||
           only_by_pdo(variable);
}

void ask_for_refusal(const Dictionary& dictionary, std::vector<Question>& questions) {
    const std::size_t values = questions.size();
    for (std::size_t i = 0; i < values; ++i) {
        const Variable* variable = dictionary.find(questions[i].index, questions[i].sub_index);
        if (variable != nullptr && refuses_writing(*variable)) {
            Question write = questions[i];
            write.kind = Kind::not_writable;
            write.identifies = false;
            write.read_by = i;
            questions.push_back(std::move(write));
        }
    }
}

void ask_for_absence(const Dictionary& dictionary, std::vector<Question>& questions) {
    for (const Object& object : dictionary.objects) {
        Question& beyond = questions.emplace_back();
        beyond.kind = Kind::no_sub_index;
        beyond.index = object.index;
        beyond.sub_index = static_cast<std::uint8_t>(object.variables.back().sub_index + 1);
        beyond.name = object.name;
    }
    for (const std::uint16_t index : foreign_objects) {
        if (dictionary.find(index) == nullptr) {
            Question& foreign = questions.emplace_back();
            foreign.kind = Kind::no_object;
            foreign.index = index;
            foreign.is_variable = true;
        }
    }
}

}  // namespace

std::string Question::object_text() const {
    return is_variable ? base::object_text(index) : base::object_text(index, sub_index);
}

bool only_by_pdo(const Variable& variable) {
    return variable.access == object::Access::rww;
}

std::vector<Question> plan(const Dictionary& dictionary, std::uint8_t node_id, PlanOptions options) {
    std::vector<Question> questions;
    ask_values(dictionary, node_id, questions);
    if (options.write) {
        ask_for_refusal(dictionary, questions);
    }
    ask_for_absence(dictionary, questions);
    return questions;
}

}  // namespace cgw::live
