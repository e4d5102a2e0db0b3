#include <fmt/format.h>

#include <algorithm>

#include "base/abort_codes.hpp"
#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "facts/gateway.hpp"
#include "scenario/act.hpp"
#include "scenario/names.hpp"
#include "scenario/range.hpp"
#include "scenario/run.hpp"
#include "simulation/scaling.hpp"
#include "simulation/text.hpp"
#include "wire/little_endian.hpp"

namespace cgw::scenario {
namespace {

using canopen::NmtState;
using device::GatewayState;
using SdoStatus = canopen::SdoClient::Status;

constexpr GatewayState states[] = {GatewayState::undefined, GatewayState::init, GatewayState::pre_operational,
                                   GatewayState::operational, GatewayState::stopped};
constexpr Word state_names[] = {
    {"undefined", ""}, {"init", ""}, {"pre-operational", ""}, {"operational", ""}, {"stopped", ""}};
static_assert(std::size(states) == std::size(state_names));

constexpr NmtState node_states[] = {NmtState::pre_operational, NmtState::operational, NmtState::stopped};
constexpr Word node_state_names[] = {{"pre-operational", ""}, {"operational", ""}, {"stopped", ""}};
static_assert(std::size(node_states) == std::size(node_state_names));

simulation::Installation& plant_of(Run& run) {
    return run.installation();
}

std::vector<std::uint16_t> errors_of(Run& run) {
    return plant_of(run).error_numbers();
}

std::string error_list(const std::vector<std::uint16_t>& errors) {
    std::vector<std::string> texts;
    std::transform(errors.begin(), errors.end(), std::back_inserter(texts), error_text);
    return fmt::format("{}", fmt::join(texts, ", "));
}

bool shows(Run& run, std::int64_t error) {
    const std::vector<std::uint16_t> errors = errors_of(run);
    return std::find(errors.begin(), errors.end(), error) != errors.end();
}

std::string within_text(const Step& step) {
    return fmt::format("within {} s", base::to_text(step.values[1].number));
}

bool recent(Run& run, const Step& step, Time heard) {
    return plant_of(run).now() - heard <= static_cast<Time>(step.values[1].integer);
}

std::optional<simulation::MasterNode::Received> last_tpdo(Run& run, const Step& step) {
    const image::Pdo pdo = plant_of(run).image().pdo(static_cast<std::size_t>(step.subject().integer - 1));
    return plant_of(run).node().received(pdo.cob_id);
}

// "the last one is 0.125 s old", or that there was none (nullptr).
std::string age_text(Run& run, const Time* last) {
    if (last == nullptr) {
        return "there was none";
    }
    return fmt::format("the last one is {:.3f} s old",
                       static_cast<double>(plant_of(run).now() - *last) / 1e6);
}

std::string answer_text(const canopen::SdoClient& sdo) {
    switch (sdo.status()) {
        case SdoStatus::idle:
        case SdoStatus::busy:
            return "there is no answer yet";
        case SdoStatus::aborted:
            return base::abort_text(static_cast<std::uint32_t>(sdo.abort_code()));
        case SdoStatus::done:
            break;
    }
    return sdo.length() == 0 ? "it was written"
                             : fmt::format("it is 0x{:0{}X}", sdo.value(), 2 * sdo.length());
}

}  // namespace

std::span<const Word> state_words() {
    return state_names;
}
std::span<const Word> node_state_words() {
    return node_state_names;
}

Outcome expect_state(Run& run, const Step& step) {
    const GatewayState wanted = states[step.subject().integer];
    const GatewayState state = plant_of(run).plant().gateway().state();
    return {fmt::format("the gateway is {}", simulation::to_text(wanted)), state == wanted,
            fmt::format("it is {}", simulation::to_text(state))};
}

Outcome expect_error(Run& run, const Step& step) {
    const std::vector<std::uint16_t> errors = errors_of(run);
    return {fmt::format("error {}", error_text(static_cast<std::uint16_t>(step.subject().integer))),
            shows(run, step.subject().integer),
            errors.empty()
                ? "there is none"
                : fmt::format("there {} only {}", errors.size() == 1 ? "is" : "are", error_list(errors))};
}

Outcome expect_no_error(Run& run, const Step& step) {
    if (step.subject().text == "any") {
        const std::vector<std::uint16_t> errors = errors_of(run);
        return {"no error", errors.empty(),
                fmt::format("there {} {}", errors.size() == 1 ? "is" : "are", error_list(errors))};
    }
    return {fmt::format("no error {}", error_text(static_cast<std::uint16_t>(step.subject().integer))),
            !shows(run, step.subject().integer), "it is there"};
}

Outcome expect_word(Run& run, const Step& step) {
    const image::Image& image = plant_of(run).image();
    const auto number = static_cast<std::uint16_t>(step.subject().integer);
    Outcome outcome{fmt::format("{} {}", simulation::parameter_text(image, number),
                                range_text(step, simulation::unit_text(image, number)))};
    const auto words = simulation::received_words(plant_of(run).node(), image);
    const auto found = words.find(number);
    if (found == words.end()) {
        outcome.met = false;
        outcome.instead = "not received";
        return outcome;
    }
    outcome.met = in_range(step, simulation::scale_of(image, number, 0, 100).to_engineering(found->second));
    outcome.instead = fmt::format("it is {}", simulation::value_text(image, number, found->second));
    return outcome;
}

Outcome expect_tpdo(Run& run, const Step& step) {
    const auto last = last_tpdo(run, step);
    return {fmt::format("TPDO{} {}", step.subject().integer, within_text(step)),
            last && recent(run, step, last->time), age_text(run, last ? &last->time : nullptr)};
}

Outcome expect_no_tpdo(Run& run, const Step& step) {
    const auto last = last_tpdo(run, step);
    return {fmt::format("no TPDO{} {}", step.subject().integer, within_text(step)),
            !last || !recent(run, step, last->time), age_text(run, last ? &last->time : nullptr)};
}

Outcome expect_heartbeat(Run& run, const Step& step) {
    const NmtState wanted = node_states[step.subject().integer];
    const std::uint8_t gateway = plant_of(run).image().can2().own_node;
    const auto& all = plant_of(run).node().heartbeats();
    const auto found = std::find_if(all.rbegin(), all.rend(),
                                    [gateway](const auto& heard) { return heard.node_id == gateway; });
    const auto* const last = found == all.rend() ? nullptr : &*found;
    const bool fresh = last && recent(run, step, last->time);
    return {fmt::format("heartbeat {} {}", simulation::to_text(wanted), within_text(step)),
            fresh && last->state == wanted,
            fresh ? fmt::format("it says {}", simulation::to_text(last->state))
                  : age_text(run, last ? &last->time : nullptr)};
}

Outcome expect_boot_ups(Run& run, const Step& step) {
    const std::uint8_t gateway = plant_of(run).image().can2().own_node;
    const auto& all = plant_of(run).node().boot_ups();
    const auto heard = std::count_if(all.begin(), all.end(),
                                     [gateway](const auto& boot_up) { return boot_up.node_id == gateway; });
    return {
        fmt::format("{} boot-up{} so far", step.subject().integer, step.subject().integer == 1 ? "" : "s"),
        heard == step.subject().integer, fmt::format("there {} {}", heard == 1 ? "was" : "were", heard)};
}

Outcome expect_answer(Run& run, const Step& step) {
    const canopen::SdoClient& sdo = plant_of(run).node().master().sdo();
    return {fmt::format("answer 0x{:X}", step.subject().integer),
            sdo.status() == SdoStatus::done && sdo.length() != 0 && sdo.value() == step.subject().integer,
            answer_text(sdo)};
}

Outcome expect_abort(Run& run, const Step& step) {
    const canopen::SdoClient& sdo = plant_of(run).node().master().sdo();
    return {base::abort_text(static_cast<std::uint32_t>(step.subject().integer)),
            sdo.status() == SdoStatus::aborted &&
                static_cast<std::int64_t>(sdo.abort_code()) == step.subject().integer,
            answer_text(sdo)};
}

}  // namespace cgw::scenario
