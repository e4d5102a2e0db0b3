#include "signals/frames.hpp"

#include <fmt/format.h>

#include "dbc/names.hpp"
#include "facts/communication.hpp"
#include "signals/parts.hpp"

namespace cgw::signals {
namespace {

using config::WordKind;

std::vector<Signal> signals_of(const Origin& origin, const PlacedWord& placed) {
    switch (placed.word.kind) {
        case WordKind::errors:
            return error_signals(origin, placed);
        case WordKind::engine_state:
            return engine_state_signals(placed);
        case WordKind::measurement:
            return {measurement_signal(origin, placed)};
        case WordKind::switches:
            return switch_signals(origin, placed);
        case WordKind::sensor_flags:
            return sensor_flag_signals(origin, placed);
        case WordKind::sensor:
            return {sensor_signal(origin, placed)};
        case WordKind::dummy:
            break;
    }
    return {};
}

Frame frame_of(const Origin& origin, const config::Pdo& pdo) {
    namespace objects = facts::object;
    const bool transmit = pdo.direction == config::Direction::transmit;
    const unsigned offset = pdo.number - 1U;
    const auto object = [offset](unsigned first) { return static_cast<std::uint16_t>(first + offset); };
    Frame frame{.name = pdo.name(),
                .direction = pdo.direction,
                .number = pdo.number,
                .identifier = pdo.cob_id,
                .length = pdo.length(),
                .period_us = transmit ? pdo.time.effective_us : 0,
                .monitoring_us = transmit ? 0 : pdo.time.effective_us,
                .communication = object(transmit ? objects::tpdo_communication : objects::rpdo_communication),
                .mapping = object(transmit ? objects::tpdo_mapping : objects::rpdo_mapping)};
    dbc::Names names;
    unsigned first_bit = 0;
    for (const config::MappedWord& word : pdo.mapping) {
        frame.words.push_back({word.kind, word.index, word.sub_index});
        for (Signal& signal : signals_of(origin, {word, first_bit})) {
            signal.name = names.take(signal.name);
            frame.signals.push_back(std::move(signal));
        }
        first_bit += config::word_bits;
    }
    return frame;
}

}  // namespace

std::string_view to_text(Kind kind) {
    switch (kind) {
        case Kind::error:
            return "error";
        case Kind::engine_state:
            return "engine-state";
        case Kind::measurement:
            return "measurement";
        case Kind::switch_function:
            return "switch";
        case Kind::sensor_flag:
            return "sensor-flag";
        case Kind::sensor:
            break;
    }
    return "sensor";
}

std::string Source::label() const {
    return name.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, name);
}

std::vector<Frame> frames_of(const parameter::Settings& settings, const parameter::Catalogue& catalogue,
                             const config::Configuration& configuration) {
    std::vector<Frame> frames;
    for (const config::Pdo& pdo : configuration.pdos) {
        if (pdo.active) {
            frames.push_back(frame_of({settings, catalogue, configuration}, pdo));
        }
    }
    return frames;
}

}  // namespace cgw::signals
