#include "canopen/pdo.hpp"

namespace cgw::canopen {
namespace {

bool follows(const MappedValue& before, const MappedValue& next) {
    return next.dummy == before.dummy && (next.dummy || next.offset == before.offset + before.length);
}

}  // namespace

std::size_t join_neighbours(std::span<MappedValue> mapping) {
    std::size_t count = 0;
    for (const MappedValue& value : mapping) {
        if (count != 0 && follows(mapping[count - 1], value)) {
            MappedValue& run = mapping[count - 1];
            run.length = static_cast<std::uint8_t>(run.length + value.length);
        } else {
            mapping[count++] = value;
        }
    }
    return count;
}

PdoTransmitter::PdoTransmitter(std::span<const PdoRow> rows, std::span<TransmitState> states,
                               std::span<const std::uint8_t> values)
    : rows_(rows), states_(states), values_(values) {}

void PdoTransmitter::request_if_changed(std::size_t position) {
    if (rows_[position].length != 0 && build(position).data != states_[position].last_sent) {
        request(position);
    }
}

void PdoTransmitter::cancel() {
    for (TransmitState& state : states_) {
        state.pending = false;
    }
    waiting_ = 0;
    next_ = 0;
}

bool PdoTransmitter::send_pending(frame::FramePort& port) {
    while (waiting_ != 0) {
        TransmitState& state = states_[next_];
        if (state.pending) {
            const frame::Frame frame = build(next_);
            if (!port.send(frame)) {
                ++counters_.deferred;
                return false;
            }
            state.pending = false;
            state.last_sent = frame.data;
            --waiting_;
            ++counters_.sent;
        }
        next_ = next_ + 1 == rows_.size() ? 0 : next_ + 1;
    }
    next_ = 0;
    return true;
}

frame::Frame PdoTransmitter::build(std::size_t position) const {
    const PdoRow& row = rows_[position];
    frame::Frame frame;
    frame.id = row.cob_id;
    frame.length = row.length;
    gather(row, values_, frame.data);
    return frame;
}

PdoReceiver::PdoReceiver(std::span<const PdoRow> rows, std::span<std::uint8_t> values)
    : rows_(rows), values_(values) {}

bool PdoReceiver::take(const PdoRow& row, const frame::Frame& frame) {
    if (frame.remote || frame.extended) {
        return false;
    }
    if (frame.length < row.length) {
        ++counters_.too_short;
        return false;
    }
    scatter(row, frame.data, values_);
    ++counters_.received;
    return true;
}

}  // namespace cgw::canopen
