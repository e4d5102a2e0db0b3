#include "scenario/commentary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/abort_codes.hpp"
#include "base/canopen_text.hpp"
#include "facts/gateway.hpp"
#include "scenario/names.hpp"
#include "simulation/engine_state_word.hpp"
#include "simulation/text.hpp"

namespace cgw::scenario {
namespace {

constexpr std::string_view kind_texts[] = {"boot-up", "nmt",   "state",  "error", "monitor", "link",
                                           "engine",  "alarm", "answer", "step",  "expect"};

// What `numbers` has and `others` has not.
std::vector<std::uint16_t> missing_in(const std::vector<std::uint16_t>& others,
                                      const std::vector<std::uint16_t>& numbers) {
    std::vector<std::uint16_t> missing;
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(missing), [&](std::uint16_t number) {
        return std::find(others.begin(), others.end(), number) == others.end();
    });
    return missing;
}

}  // namespace

std::string_view to_text(EventKind kind) {
    return kind_texts[static_cast<std::size_t>(kind)];
}

std::string seconds_text(Time time) {
    const canopen::Time milliseconds = time / 1000;
    return fmt::format("{:4}.{:03} s", milliseconds / 1000, milliseconds % 1000);
}

std::string line_of(const Event& event) {
    const bool judged = event.kind == EventKind::expected || (event.kind == EventKind::step && event.bad);
    const std::string_view word = !judged ? to_text(event.kind) : event.bad ? "FAILED" : "ok";
    return simulation::clipped(fmt::format("{}  {:<8} {}", seconds_text(event.time), word, event.text),
                               simulation::line_width);
}

Commentary::Commentary(simulation::Installation& installation, EventListener listener)
    : installation_(&installation),
      listener_(std::move(listener)),
      engine_(simulation::engine_text(installation.plant().governor().engine().state())) {
    installation.plant().can2().attach_clock(*this);
    installation.plant().can2().observe(
        [this](const frame::Frame& frame, Time /*now*/) { watch_commands(frame); });
}

void Commentary::tell(EventKind kind, std::string text, bool bad) const {
    listener_({installation_->now(), kind, std::move(text), bad});
}

Time Commentary::poll(Time /*now*/) {
    watch_boot_ups();
    watch_state();
    watch_link();
    watch_monitors();
    watch_errors();
    watch_engine();
    watch_alarms();
    watch_answer();
    return canopen::never;
}

void Commentary::watch_commands(const frame::Frame& frame) {
    if (frame.id != canopen::cob::nmt || frame.extended || frame.remote || frame.length != 2) {
        return;
    }
    const std::string_view name = simulation::to_text(static_cast<canopen::NmtCommand>(frame.data[0]));
    const std::string what = name.empty() ? fmt::format("command {:02X}h", frame.data[0]) : std::string(name);
    tell(EventKind::command, frame.data[1] == canopen::all_nodes
                                 ? fmt::format("{}, all nodes", what)
                                 : fmt::format("{}, node {}", what, frame.data[1]));
}

void Commentary::watch_boot_ups() {
    const auto& heard = installation_->node().boot_ups();
    for (; boot_ups_ < heard.size(); ++boot_ups_) {
        tell(EventKind::boot_up, fmt::format("node {}", heard[boot_ups_].node_id));
    }
}

void Commentary::watch_state() {
    const device::GatewayState state = installation_->plant().gateway().state();
    if (state != state_) {
        state_ = state;
        tell(EventKind::state, std::string(simulation::to_text(state)));
    }
}

void Commentary::watch_errors() {
    const std::vector<std::uint16_t> now = installation_->error_numbers();
    if (now == errors_) {
        return;
    }
    tell_errors(missing_in(errors_, now), true);
    tell_errors(missing_in(now, errors_), false);
    errors_ = now;
}

// As many in a line as it holds.
void Commentary::tell_errors(const std::vector<std::uint16_t>& errors, bool come) const {
    constexpr std::size_t widest = 48;
    std::string line;
    std::size_t count = 0;
    const auto tell_line = [&] {
        if (count != 0) {
            tell(EventKind::error,
                 fmt::format("{} {}", line,
                             come ? (count == 1 ? "comes" : "come") : (count == 1 ? "goes" : "go")),
                 come);
        }
        line.clear();
        count = 0;
    };
    for (const std::uint16_t error : errors) {
        const std::string text = error_text(error);
        if (line.size() + text.size() > widest) {
            tell_line();
        }
        line += (count == 0 ? "" : ", ") + text;
        ++count;
    }
    tell_line();
}

void Commentary::watch_monitors() {
    const device::GatewayStatus& status = installation_->plant().gateway().status();
    for (unsigned rpdo = 1; rpdo <= facts::rpdo_count; ++rpdo) {
        const unsigned bit = 1U << (rpdo - 1);
        if (((unsigned{status.late_rpdos} ^ late_rpdos_) & bit) != 0) {
            const bool late = (status.late_rpdos & bit) != 0;
            tell(EventKind::monitor, fmt::format("RPDO{} is {}", rpdo, late ? "late" : "no longer late"),
                 late);
        }
    }
    late_rpdos_ = status.late_rpdos;
    if (status.heartbeat_lost != heartbeat_lost_) {
        heartbeat_lost_ = status.heartbeat_lost;
        tell(EventKind::monitor,
             fmt::format("the heartbeat of node {} is {}", installation_->image().heartbeat().consumer_node,
                         heartbeat_lost_ ? "lost" : "no longer missed"),
             heartbeat_lost_);
    }
}

void Commentary::watch_link() {
    const link::GovernorEnd& governor = installation_->plant().governor().link();
    if (governor.failed_attempts() > failed_attempts_) {
        const link::GatewayEnd& gateway = installation_->plant().gateway_link();
        const link::Refusal& refusal = gateway.refusal();
        const bool differs = refusal.incomplete || refusal.received != refusal.expected.value;
        tell(EventKind::link,
             gateway.answer() == link::Answer::refused && differs
                 ? fmt::format("refused: {}", simulation::refusal_text(refusal))
                 : std::string("an attempt to initialise the gateway failed"),
             true);
    }
    failed_attempts_ = governor.failed_attempts();
    if (governor.phase() != phase_ && governor.phase() == link::GovernorEnd::Phase::given_up) {
        tell(EventKind::link, "the governor gives up until errors are cleared", true);
    }
    phase_ = governor.phase();
}

void Commentary::watch_engine() {
    const std::string_view engine =
        simulation::engine_text(installation_->plant().governor().engine().state());
    if (engine != engine_) {
        engine_ = engine;
        tell(EventKind::engine, std::string(engine));
    }
}

void Commentary::watch_alarms() {
    const simulation::SimulatedGovernor& governor = installation_->plant().governor();
    for (const simulation::AlarmRow& row : simulation::alarm_rows()) {
        const bool now = governor.alarms().present(row.alarm);
        if (now != alarms_.present(row.alarm)) {
            tell(EventKind::alarm,
                 fmt::format("{} {}, at {:.{}f} {}", row.text, now ? "comes" : "goes",
                             row.value(governor.engine().state()), row.decimals, row.unit),
                 now);
        }
    }
    if (governor.alarms().emergency_stop() != alarms_.emergency_stop()) {
        const bool now = governor.alarms().emergency_stop();
        tell(EventKind::alarm, fmt::format("emergency stop {}", now ? "comes" : "goes"), now);
    }
    alarms_ = governor.alarms();
}

void Commentary::watch_answer() {
    const canopen::SdoClient& sdo = installation_->node().master().sdo();
    const canopen::SdoClient::Status before = sdo_;
    sdo_ = sdo.status();
    if (before != canopen::SdoClient::Status::busy || sdo_ == before) {
        return;
    }
    if (sdo_ == canopen::SdoClient::Status::aborted) {
        tell(EventKind::answer,
             fmt::format("{}: {}", object_, base::abort_text(static_cast<std::uint32_t>(sdo.abort_code()))));
    } else if (sdo.length() == 0) {
        tell(EventKind::answer, fmt::format("{}: written", object_));
    } else {
        tell(EventKind::answer, fmt::format("{}: 0x{:0{}X}", object_, sdo.value(), 2 * sdo.length()));
    }
}

}  // namespace cgw::scenario
