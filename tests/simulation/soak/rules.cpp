#include "simulation/soak/rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "wire/little_endian.hpp"

namespace cgw::simulation::soak {
namespace {

constexpr std::size_t most_blamed = 5;
constexpr unsigned cycles_on_the_way = 3;  // from the governor to the PLC

bool initialised(GatewayState state) {
    return state != GatewayState::undefined && state != GatewayState::init;
}

}  // namespace

Rules::Rules(const image::Image& image) : image_(&image) {}

void Rules::blame(std::string_view rule, Time now, const std::string& what) {
    if (broken_.size() < most_blamed) {
        broken_.push_back(fmt::format("{} at {} us: {}", rule, now, what));
    }
}

void Rules::gateway_was_reset() {
    state_ = GatewayState::undefined;
    last_ = {};
    boot_up_due_.reset();
    waiting_.clear();
    binary_ = {};
}

void Rules::can2_was_cut() {
    ++cuts_;
    lost_ = taken_ - std::min(taken_, carried_);
}

void Rules::allow(const std::set<unsigned>& errors) {
    allowed_.insert(errors.begin(), errors.end());
    for (const device::FaultRow& row : device::fault_rows()) {
        if (row.error != 0 && errors.contains(row.canopen_error)) {
            allowed_.insert(row.error);
        }
    }
}

void Rules::allow_alarms(const std::set<Alarm>& alarms) {
    for (const Alarm alarm : alarms) {
        alarms_allowed_.set(static_cast<std::size_t>(alarm));
    }
}

void Rules::allow_none() {
    allowed_.clear();
    alarms_allowed_.reset();
}

// --- states, errors, boot-up ---

void Rules::look(const Look& look) {
    const GatewayState before = state_.value_or(GatewayState::undefined);
    follow(look.state, look.now, look.hides_states);
    const bool was_operational = before == GatewayState::operational ||
                                 look.state == GatewayState::operational ||
                                 look.operational_entries != last_.operational_entries;
    if (!was_operational && look.pdos_received != last_.pdos_received) {
        blame("rpdo-outside-operational", look.now, "taken");
    }
    judge_errors(look);
    judge_alarms(look);
    constexpr unsigned can2_bus_error = 1U << (12423 - facts::first_canopen_error);
    if (((unsigned{look.canopen_errors} | last_.canopen_errors) & can2_bus_error) != 0) {
        waiting_.erase(sdo_answer());  // dropped when the bus goes and when it comes back
    }
    if (look.state != last_.state || look.operational_entries != last_.operational_entries ||
        look.binary != last_.binary) {
        quiet_since_ = look.now;
        quiet_judged_ = false;
    }
    last_ = look;
    judge_binary(look.now);
    judge_waiting(look.now);
}

// Those that have just appeared, in 2005h and in 2000h:1..6.
void Rules::judge_errors(const Look& look) {
    const auto judge = [&](unsigned first, unsigned now, unsigned before) {
        const unsigned risen = now & ~before;
        for (unsigned bit = 0; (risen >> bit) != 0; ++bit) {
            if (((risen >> bit) & 1U) != 0 && !may_show(first + bit, look)) {
                blame("error-without-cause", look.now, fmt::format("{}", first + bit));
            }
        }
    };
    judge(facts::first_canopen_error, look.canopen_errors, last_.canopen_errors);
    for (unsigned word = 0; word < facts::error_words; ++word) {
        if (word != error_pair && word != error_pair + 1) {
            judge(facts::error_number(word * facts::word_bits), look.binary[word], last_.binary[word]);
        }
    }
}

void Rules::judge_alarms(const Look& look) {
    for (const AlarmRow& row : alarm_rows()) {
        const auto i = static_cast<std::size_t>(row.alarm);
        if (look.alarms[i] && !last_.alarms[i]) {
            ++alarms_;
            if (!alarms_allowed_[i]) {
                blame("alarm-without-cause", look.now, std::string(row.name));
            }
        }
    }
}

// A sensor's error is the governor's, and may follow from anything that keeps receive PDOs away.
bool Rules::may_show(unsigned error, const Look& look) const {
    constexpr unsigned first_sensor = 900;
    constexpr unsigned first_sensor_error = 3005;
    for (std::size_t i = 0; i < image_->sensor_count(); ++i) {
        if (error == first_sensor_error + image_->sensor(i).number - first_sensor) {
            return true;
        }
    }
    return allowed_.contains(error) ||
           (error == device::GatewayErrors::can_open_error && look.canopen_errors != 0);
}

void Rules::follow(GatewayState state, Time now, bool hides_states) {
    const GatewayState before = state_.value_or(state);
    state_ = state;
    if (before == state) {
        return;
    }
    if (!hides_states && !may_follow(before, state, now)) {
        blame("transition", now, fmt::format("{} to {}", to_text(before), to_text(state)));
    }
    if (!initialised(state)) {
        boot_up_due_.reset();
    } else if (!initialised(before)) {
        boot_up_due_ = now;
    }
    if (!initialised(state) || state == GatewayState::stopped) {
        waiting_.clear();
    } else if (state != GatewayState::operational) {
        std::erase_if(waiting_, [this](const auto& one) { return one.first != sdo_answer(); });
    }
}

// Between the states that CANopen knows only a command leads, at once, or an error that forces one of them.
bool Rules::may_follow(GatewayState before, GatewayState after, Time now) const {
    constexpr unsigned can2_bus = 12423;
    constexpr unsigned can2_overflow = 12424;
    const auto commanded = [&](canopen::NmtCommand command) {
        return initialised(before) && command_ == command && commanded_ == now;
    };
    switch (after) {
        case GatewayState::undefined:
        case GatewayState::init:
            return true;
        case GatewayState::pre_operational:
            return before == GatewayState::init || commanded(canopen::NmtCommand::enter_pre_operational) ||
                   (initialised(before) && allowed_.contains(can2_bus));
        case GatewayState::operational:
            return commanded(canopen::NmtCommand::start);
        case GatewayState::stopped:
            return commanded(canopen::NmtCommand::stop) ||
                   (initialised(before) && allowed_.contains(can2_overflow));
    }
    return false;
}

// Refused once, and not offered again although the port takes frames.
void Rules::judge_waiting(Time now) {
    const bool port_is_full = now - last_refusal_ <= patience;
    if (!port_is_full && !waiting_.empty()) {
        blame("pending-lost", now,
              fmt::format("{:03X}h, refused at {} us", waiting_.begin()->first, waiting_.begin()->second));
        waiting_.clear();
    }
    if (!port_is_full && boot_up_due_ && now - *boot_up_due_ > patience) {
        blame("boot-up-missing", now, fmt::format("initialised at {} us", *boot_up_due_));
        boot_up_due_.reset();
    }
}

// --- afterwards ---

void Rules::settle(const Settled& settled) {
    const Time now = settled.now;
    if (settled.state != GatewayState::operational) {
        blame("not-operational", now, std::string(to_text(settled.state)));
    }
    if (!settled.errors.empty()) {
        blame("error-stuck", now, fmt::format("{}", fmt::join(settled.errors, ", ")));
    }
    if (settled.alarms || !settled.engine_runs) {
        blame("alarm-stuck", now, settled.alarms ? "alarm" : "the engine does not run");
    }
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image_->pdo(position);
        const auto& received = settled.tpdos[position];
        const Time longest = pdo.effective_us + 5'000U;
        if (pdo.active && (!received || (pdo.effective_us != 0 && now - received->time > longest))) {
            blame("tpdo-late", now, fmt::format("TPDO{}", position + 1));
        }
    }
    const std::uint32_t producer = image_->heartbeat().producer_us;
    if (producer != 0 && (!last_life_sign_ || now - *last_life_sign_ > producer + patience)) {
        blame("heartbeat-late", now, fmt::format("every {} us", producer));
    }
    for (std::size_t position = facts::binary_tpdos; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image_->pdo(position);
        const auto& received = settled.tpdos[position];
        const unsigned age = received ? static_cast<std::uint16_t>(cycle_ - received->first_word) : 0U;
        if (pdo.active && pdo.cycles != 0 && age > pdo.cycles + cycles_on_the_way) {
            blame("tpdo-stale", now, fmt::format("TPDO{}: {} main cycles old", position + 1, age));
        }
    }
    constexpr std::size_t engine_state = 2;
    const auto& status = settled.tpdos[engine_state];
    if (image_->pdo(engine_state).active && status && status->first_word != settled.engine_state) {
        blame("tpdo-stale", now,
              fmt::format("TPDO3: {:02X}h instead of {:02X}h", status->first_word, settled.engine_state));
    }
    if (settled.sent != settled.obeyed) {
        blame(
            "rpdo-lost", now,
            fmt::format("{} sent, {} obeyed", fmt::join(settled.sent, " "), fmt::join(settled.obeyed, " ")));
    }
}

}  // namespace cgw::simulation::soak
