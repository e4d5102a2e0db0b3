#include "canopen/pdo.hpp"

#include <algorithm>

namespace cgw::canopen {

PdoTransmitter::PdoTransmitter(std::span<const PdoRow> rows, std::span<TransmitState> states,
                               std::span<const std::uint8_t> values)
    : rows_(rows), states_(states), values_(values) {}

void PdoTransmitter::request(std::size_t position) {
    if (rows_[position].length == 0) {
        return;
    }
    TransmitState& state = states_[position];
    if (state.pending) {
        ++counters_.superseded;
        return;
    }
    state.pending = true;
    ++waiting_;
}

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
    std::uint8_t* to = frame.data.data();
    for (const MappedValue& value : row.mapping) {
        to = std::copy_n(values_.data() + value.offset, value.length, to);
    }
    return frame;
}

PdoReceiver::PdoReceiver(std::span<const PdoRow> rows, std::span<std::uint8_t> values)
    : rows_(rows), values_(values) {}

std::optional<std::size_t> PdoReceiver::receive(const frame::Frame& frame) {
    if (frame.remote || frame.extended) {
        return std::nullopt;
    }
    for (std::size_t position = 0; position < rows_.size(); ++position) {
        const PdoRow& row = rows_[position];
        if (row.length == 0 || row.cob_id != frame.id) {
            continue;
        }
        if (frame.length < row.length) {
            ++counters_.too_short;
            return std::nullopt;
        }
        const std::uint8_t* from = frame.data.data();
        for (const MappedValue& value : row.mapping) {
            if (!value.dummy) {
                std::copy_n(from, value.length, values_.data() + value.offset);
            }
            from += value.length;
        }
        ++counters_.received;
        return position;
    }
    return std::nullopt;
}

}  // namespace cgw::canopen
