#include "simulation/soak/rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "wire/little_endian.hpp"

namespace cgw::simulation::soak {
namespace {

constexpr std::size_t most_blamed = 5;
constexpr std::size_t error_pair = 2;  // 2000h:3 and 4, where no error of the gateway's own is

bool may_follow(GatewayState before, GatewayState after) {
    switch (after) {
        case GatewayState::undefined:
        case GatewayState::init:
            return true;
        case GatewayState::pre_operational:
            return before != GatewayState::undefined;
        case GatewayState::operational:
        case GatewayState::stopped:
            return before != GatewayState::undefined && before != GatewayState::init;
    }
    return false;
}

bool initialised(GatewayState state) {
    return state != GatewayState::undefined && state != GatewayState::init;
}

// The first word is the number of the cycle; the others follow from it, all of them different.
std::uint16_t marked_word(std::uint16_t cycle, std::size_t tpdo, std::size_t word) {
    if (word == 0) {
        return cycle;
    }
    return static_cast<std::uint16_t>(cycle * 40503U + tpdo * 0x1357U + word * 0x02B1U);
}

std::uint16_t word_of(const frame::Frame& frame, std::size_t word) {
    return wire::load_u16(&frame.data[2 * word]);
}

std::uint8_t heartbeat_byte(GatewayState state) {
    switch (state) {
        case GatewayState::operational:
            return static_cast<std::uint8_t>(canopen::NmtState::operational);
        case GatewayState::stopped:
            return static_cast<std::uint8_t>(canopen::NmtState::stopped);
        case GatewayState::undefined:
        case GatewayState::init:
        case GatewayState::pre_operational:
            break;
    }
    return static_cast<std::uint8_t>(canopen::NmtState::pre_operational);
}

}  // namespace

Rules::Rules(const image::Image& image) : image_(&image) {}

void Rules::blame(std::string_view rule, Time now, const std::string& what) {
    if (broken_.size() < most_blamed) {
        broken_.push_back(fmt::format("{} at {} us: {}", rule, now, what));
    }
}

void Rules::mark(device::GovernorData& data, bool errors_flicker) {
    ++cycle_;
    for (std::size_t tpdo = 0; tpdo < data.analogue.size(); ++tpdo) {
        for (std::size_t word = 0; word < data.analogue[tpdo].size(); ++word) {
            data.analogue[tpdo][word] = marked_word(cycle_, tpdo, word);
        }
    }
    if (errors_flicker) {
        data.errors[error_pair] = cycle_;
        data.errors[error_pair + 1] = static_cast<std::uint16_t>(~cycle_);
    }
}

void Rules::gateway_was_reset() {
    state_ = GatewayState::undefined;
    last_ = {};
    boot_up_due_.reset();
    waiting_.clear();
}

void Rules::can2_was_cut() {
    ++cuts_;
}

void Rules::allow_none() {
    allowed_.clear();
    alarms_allowed_ = false;
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
    for (unsigned bit = 0; look.canopen_errors != last_.canopen_errors && bit < facts::word_bits; ++bit) {
        const unsigned error = facts::first_canopen_error + bit;
        if (((unsigned{look.canopen_errors} >> bit) & 1U) != 0 && !allowed_.contains(error)) {
            blame("error-without-cause", look.now, fmt::format("{}", error));
        }
    }
    if (look.alarms && !last_.alarms && !alarms_allowed_) {
        blame("alarm-without-cause", look.now, "of the engine");
    }
    constexpr unsigned can2_bus_error = 1U << (12423 - facts::first_canopen_error);
    if (((unsigned{look.canopen_errors} | last_.canopen_errors) & can2_bus_error) != 0) {
        waiting_.erase(sdo_answer());  // dropped when the bus goes and when it comes back
    }
    last_ = look;
    judge_waiting(look.now);
}

void Rules::follow(GatewayState state, Time now, bool hides_states) {
    const GatewayState before = state_.value_or(state);
    state_ = state;
    if (before == state) {
        return;
    }
    if (!hides_states && !may_follow(before, state)) {
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

// --- what the gateway sends ---

std::optional<std::size_t> Rules::tpdo_of(const frame::Frame& frame) const {
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image_->pdo(position);
        if (pdo.active && !frame.extended && !frame.remote && frame.id == pdo.cob_id) {
            return position;
        }
    }
    return std::nullopt;
}

std::uint32_t Rules::sdo_answer() const {
    return canopen::cob::sdo_answer + image_->can2().own_node;
}

void Rules::offer(const frame::Frame& frame, bool taken, const Offered& at) {
    const GatewayState state = at.state;
    const Time now = at.now;
    follow(state, now, at.hides_states);
    const bool life_sign = frame.id == canopen::cob::heartbeat + image_->can2().own_node;
    last_refusal_ = taken ? last_refusal_ : now;
    if (life_sign) {
        judge_boot_up(frame, taken, now);
        judge_heartbeat(frame, state, now);
    } else if (boot_up_due_) {
        blame("boot-up-overtaken", now, fmt::format("by {:03X}h", frame.id));
    }
    if (taken) {
        waiting_.erase(frame.id);
    } else if (!life_sign) {
        waiting_.emplace(frame.id, now);
    }
    if (const std::optional<std::size_t> position = tpdo_of(frame)) {
        taken_ += taken ? 1U : 0U;
        if (state != GatewayState::operational) {
            blame("tpdo-outside-operational", now, fmt::format("TPDO{}", *position + 1));
        }
        judge_words(*position, frame, now);
    }
}

void Rules::judge_boot_up(const frame::Frame& frame, bool taken, Time now) {
    if (frame.data[0] != 0 || !taken) {
        return;
    }
    if (!boot_up_due_) {
        blame("boot-up-twice", now, "no initialisation before it");
    }
    boot_up_due_.reset();
}

void Rules::judge_heartbeat(const frame::Frame& frame, GatewayState state, Time now) {
    if (frame.data[0] != 0 && frame.data[0] != heartbeat_byte(state)) {
        blame("heartbeat", now, fmt::format("{:02X}h in {}", frame.data[0], to_text(state)));
    }
}

void Rules::judge_words(std::size_t position, const frame::Frame& frame, Time now) {
    const image::Pdo pdo = image_->pdo(position);
    if (frame.length != 2 * pdo.word_count) {
        blame("length", now, fmt::format("TPDO{}: {} bytes", position + 1, frame.length));
    }
    if (position < facts::binary_tpdos) {
        if (position == 0) {
            judge_error_words(frame, now);
        }
        return;
    }
    const std::uint16_t cycle = word_of(frame, 0);
    for (std::size_t word = 1; word < pdo.word_count; ++word) {
        if (word_of(frame, word) != marked_word(cycle, position - facts::binary_tpdos, word)) {
            blame("word-torn", now, fmt::format("TPDO{} word {}", position + 1, word + 1));
        }
    }
    // Neither older than what was sent before, nor of a cycle to come.
    const auto behind = static_cast<std::int16_t>(cycle_ - cycle);
    const auto ahead = static_cast<std::int16_t>(cycle - last_cycle_.value_or(cycle));
    if (behind < 0 || ahead < 0) {
        blame("word-old", now, fmt::format("TPDO{}", position + 1));
    }
    last_cycle_ = cycle;
}

void Rules::judge_error_words(const frame::Frame& frame, Time now) {
    const unsigned first = word_of(frame, error_pair);
    const unsigned second = word_of(frame, error_pair + 1);
    if ((first != 0 || second != 0) && (first ^ second) != 0xFFFF) {
        blame("word-torn", now, "TPDO1 word 4");
    }
}

// --- what passes ---

void Rules::carry(const frame::Frame& frame, Time /*now*/) {
    carried_ += tpdo_of(frame) ? 1U : 0U;
    for (std::size_t rpdo = 0; rpdo < facts::rpdo_count; ++rpdo) {
        const image::Pdo pdo = image_->pdo(facts::tpdo_count + rpdo);
        if (!pdo.active || frame.extended || frame.remote || frame.id != pdo.cob_id ||
            frame.length < 2 * pdo.word_count) {
            continue;
        }
        Words words{};
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            const bool dummy = pdo.mapping[word].index == facts::object::unsigned16_dummy;
            words[word] = dummy ? std::uint16_t{0} : word_of(frame, word);
        }
        carried_rpdos_[rpdo].push_back(words);
        if (carried_rpdos_[rpdo].size() > remembered) {
            carried_rpdos_[rpdo].pop_front();
        }
    }
}

void Rules::forward(std::uint8_t rpdo, const Words& words, Time now) {
    ++forwarded_;
    std::deque<Words>& carried = carried_rpdos_[rpdo - 1U];
    const auto found = std::find(carried.begin(), carried.end(), words);
    if (found == carried.end()) {
        blame("rpdo-torn", now, fmt::format("RPDO{}: {:04X}h", rpdo, fmt::join(words, "h ")));
        return;
    }
    carried.erase(carried.begin(), found);  // what comes next is not older
}

bool Rules::all_carried() const {
    return carried_ <= taken_ && taken_ <= carried_ + cuts_;
}

void Rules::expect_all_carried(Time now) {
    if (!all_carried()) {
        blame("frame-lost", now, fmt::format("{} taken, {} on the bus, {} cuts", taken_, carried_, cuts_));
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
