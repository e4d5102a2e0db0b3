// Which nodes the device watches by their heartbeat.
#include <fmt/format.h>

#include <map>

#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/context.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {

void check_heartbeat_consumers(const Context& context) {
    constexpr std::uint16_t index = 0x1016;
    constexpr std::uint32_t highest_node = 127;
    const Group* const group = context.model.find(index);
    if (group == nullptr || group->object == nullptr || !group->has_section ||
        !object::has_sub_objects(group->object->code)) {
        return;
    }
    std::map<std::uint32_t, std::uint8_t> watched;  // node, and the sub-index that has it
    for (const dictionary::Variable& variable : group->object->variables) {
        const auto value = variable.sub_index != 0 ? number_of(&variable) : std::nullopt;
        const auto node = static_cast<std::uint32_t>(value.value_or(0) >> 16U);
        const auto time = static_cast<std::uint32_t>(value.value_or(0) & eds::highest_u16);
        if (time == 0) {
            continue;
        }
        const Span place = context.value_place(*group, variable.sub_index);
        const auto [first, is_new] = watched.try_emplace(node, variable.sub_index);
        if (node < 1 || node > highest_node) {
            context.reading.report(
                diagnostic::rules::eds_heartbeat_consumer, place,
                fmt::format("the heartbeat of node {} is watched, every {} ms; nodes are 1 to {}", node, time,
                            highest_node));
        } else if (context.node_id() == node) {
            context.reading.report(
                diagnostic::rules::eds_heartbeat_consumer, place,
                fmt::format("the heartbeat of node {} is watched, which is this node", node));
        } else if (!is_new) {
            context.reading.report(
                diagnostic::rules::eds_heartbeat_consumer, place,
                fmt::format("the heartbeat of node {} is watched already", node), "",
                {{context.reading.location(context.value_place(*group, first->second)), "here"}});
        }
    }
}

}  // namespace cgw::eds_check
