// The rules about frames and words: what the gateway sends, and what passes between PLC and governor.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "canopen/nmt.hpp"
#include "simulation/soak/rules.hpp"
#include "wire/little_endian.hpp"

namespace cgw::simulation::soak {
namespace {

constexpr std::size_t binary_words[] = {4, 2, 1};  // of TPDO1..3 (D20)

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

bool is(const frame::Frame& frame, std::uint32_t id) {
    return !frame.extended && !frame.remote && frame.id == id;
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

// --- what the gateway sends ---

std::optional<std::size_t> Rules::tpdo_of(const frame::Frame& frame) const {
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image_->pdo(position);
        if (pdo.active && is(frame, pdo.cob_id)) {
            return position;
        }
    }
    return std::nullopt;
}

std::uint32_t Rules::life_sign() const {
    return canopen::cob::heartbeat + image_->can2().own_node;
}

std::uint32_t Rules::sdo_answer() const {
    return canopen::cob::sdo_answer + image_->can2().own_node;
}

void Rules::offer(const frame::Frame& frame, bool taken, const Offered& at) {
    const GatewayState state = at.state;
    const Time now = at.now;
    follow(state, now, at.hides_states);
    const bool life_sign = is(frame, this->life_sign());
    if (!taken) {
        ++refused_;
        last_refusal_ = quiet_since_ = now;
        quiet_judged_ = false;
    }
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
        if (taken && *position < facts::binary_tpdos) {
            binary_[*position] = frame;
        }
        if (state != GatewayState::operational) {
            blame("tpdo-outside-operational", now, fmt::format("TPDO{}", *position + 1));
        }
        judge_words(*position, frame, now);
    } else if (!life_sign) {
        judge_answer(frame, state, now);
    }
}

// What is neither a life sign nor an active TPDO must be an SDO answer.
void Rules::judge_answer(const frame::Frame& frame, GatewayState state, Time now) {
    if (!is(frame, sdo_answer())) {
        blame("stray-frame", now, fmt::format("{:03X}h", frame.id));
    } else if (state != GatewayState::pre_operational && state != GatewayState::operational) {
        blame("answer-outside-its-states", now, std::string(to_text(state)));
    }
}

void Rules::judge_boot_up(const frame::Frame& frame, bool taken, Time now) {
    if (frame.data[0] != 0 || !taken) {
        return;
    }
    if (!boot_up_due_) {
        blame("boot-up-twice", now, "no initialisation before it");
    }
    ++boot_ups_;
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

void Rules::carry(const frame::Frame& frame, Time now) {
    if (tpdo_of(frame)) {
        ++pdos_;
        ++carried_;
        lost_ = std::min(lost_, taken_ - std::min(taken_, carried_));
    }
    if (const auto command = canopen::nmt_command(frame, image_->can2().own_node)) {
        command_ = command;
        commanded_ = now;
    }
    if (is(frame, life_sign())) {
        last_life_sign_ = now;
    }
    for (std::size_t rpdo = 0; rpdo < facts::rpdo_count; ++rpdo) {
        const image::Pdo pdo = image_->pdo(facts::tpdo_count + rpdo);
        if (!pdo.active || !is(frame, pdo.cob_id) || frame.length < 2 * pdo.word_count) {
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
    return lost_ <= cuts_ && taken_ == carried_ + lost_;
}

void Rules::expect_all_carried(Time now) {
    if (!all_carried()) {
        blame("frame-lost", now, fmt::format("{} taken, {} on the bus, {} cuts", taken_, carried_, cuts_));
    }
    taken_ = carried_;
    cuts_ = lost_ = 0;
}

void Rules::judge_binary(Time now) {
    if (quiet_judged_ || now - quiet_since_ <= binary_patience || last_.state != GatewayState::operational) {
        return;
    }
    quiet_judged_ = true;
    std::size_t next = 0;
    for (std::size_t position = 0; position < facts::binary_tpdos; ++position) {
        const image::Pdo pdo = image_->pdo(position);
        for (std::size_t word = 0; pdo.active && word < pdo.word_count; ++word) {
            const std::uint16_t wanted = last_.binary[next + word];
            if (!binary_[position] || word_of(*binary_[position], word) != wanted) {
                blame("tpdo-stale", now, fmt::format("TPDO{} word {}", position + 1, word + 1));
            }
        }
        next += binary_words[position];
    }
}

}  // namespace cgw::simulation::soak
