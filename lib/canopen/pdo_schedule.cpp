#include "canopen/pdo_schedule.hpp"

#include <algorithm>

namespace cgw::canopen {
namespace {

bool event_driven(const PdoTiming& timing) {
    return timing.type >= transmission::event_manufacturer;
}

bool cyclic(const PdoTiming& timing) {
    return timing.type != transmission::synchronous_acyclic && timing.type <= transmission::highest_cyclic;
}

Time after(Time now, Time period) {
    return period == 0 ? never : now + period;
}

}  // namespace

void PdoSchedule::start(Time now) {
    for (std::size_t position = 0; position < states_.size(); ++position) {
        const PdoTiming& timing = timings_[position];
        PdoScheduleState& state = states_[position];
        state = {};
        state.counting = timing.sync_start == 0;
        if (event_driven(timing) && rows_[position].length != 0) {
            state.event = true;
            state.timer = after(now, timing.event_period);
        }
    }
}

void PdoSchedule::stop() {
    std::fill(states_.begin(), states_.end(), PdoScheduleState{});
}

void PdoSchedule::sync(std::uint8_t counter) {
    for (std::size_t position = 0; position < states_.size(); ++position) {
        const PdoTiming& timing = timings_[position];
        PdoScheduleState& state = states_[position];
        if (timing.type == transmission::synchronous_acyclic) {
            state.due = state.due || state.event;
            state.event = false;
        } else if (cyclic(timing)) {
            sync_cyclic(position, counter);
        } else if (timing.type == transmission::remote_synchronous) {
            gather(rows_[position], values_, state.sample);
            state.sampled = true;
        }
    }
}

// A start value needs a SYNC with a counter; without one, counting begins at once.
void PdoSchedule::sync_cyclic(std::size_t position, std::uint8_t counter) {
    const PdoTiming& timing = timings_[position];
    PdoScheduleState& state = states_[position];
    if (!state.counting) {
        state.counting = counter == 0 || counter == timing.sync_start;
        if (!state.counting) {
            return;
        }
        if (counter != 0) {
            state.syncs = static_cast<std::uint8_t>(timing.type - 1);  // this one is the first to be sent at
        }
    }
    if (++state.syncs >= timing.type) {
        state.syncs = 0;
        state.due = true;
    }
}

bool PdoSchedule::remote_request(const frame::Frame& frame) {
    if (!frame.remote || frame.extended) {
        return false;
    }
    for (std::size_t position = 0; position < rows_.size(); ++position) {
        const PdoTiming& timing = timings_[position];
        if (rows_[position].cob_id != frame.id || rows_[position].length == 0 || !timing.remote_allowed) {
            continue;
        }
        PdoScheduleState& state = states_[position];
        if (timing.type == transmission::remote_synchronous) {
            state.sample_due = state.sampled;
        } else if (event_driven(timing)) {
            state.event = true;
        } else {
            state.due = true;
        }
        return true;
    }
    return false;
}

void PdoSchedule::request_due(Time now, PdoTransmitter& transmitter) {
    for (std::size_t position = 0; position < states_.size(); ++position) {
        PdoScheduleState& state = states_[position];
        if (state.due) {
            transmitter.request(position);
            state.due = false;
        }
        if (!event_driven(timings_[position])) {
            continue;
        }
        if (now >= state.timer) {
            state.event = true;
            state.timer = never;
        }
        if (state.requested && transmitter.pending(position)) {
            state.event = false;  // what waits leaves with the newest data
        } else if (state.event && !state.requested && now >= state.free_at) {
            transmitter.request(position);
            state.requested = true;
            state.event = false;
        }
    }
}

Time PdoSchedule::note_sent(Time now, const PdoTransmitter& transmitter) {
    Time next = never;
    for (std::size_t position = 0; position < states_.size(); ++position) {
        const PdoTiming& timing = timings_[position];
        PdoScheduleState& state = states_[position];
        if (state.requested && !transmitter.pending(position)) {
            state.requested = false;
            state.free_at = now + timing.inhibit;
            state.timer = after(now, timing.event_period);
        }
        if (event_driven(timing) && !state.requested) {
            next = std::min(next, state.event ? state.free_at : state.timer);
        }
    }
    return next;
}

bool PdoSchedule::send_samples(frame::FramePort& port) {
    for (std::size_t position = 0; position < states_.size(); ++position) {
        PdoScheduleState& state = states_[position];
        if (!state.sample_due) {
            continue;
        }
        frame::Frame frame;
        frame.id = rows_[position].cob_id;
        frame.length = rows_[position].length;
        frame.data = state.sample;
        if (!port.send(frame)) {
            return false;
        }
        state.sample_due = false;
    }
    return true;
}

}  // namespace cgw::canopen
