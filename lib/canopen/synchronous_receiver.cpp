#include "canopen/synchronous_receiver.hpp"

namespace cgw::canopen {

std::optional<std::size_t> SynchronousReceiver::receive(const frame::Frame& frame) {
    for (std::size_t position = 0; position < rows_.size(); ++position) {
        const PdoRow& row = rows_[position];
        if (row.cob_id != frame.id || row.length == 0) {
            continue;
        }
        if (frame.remote || frame.extended || frame.length < row.length) {
            return std::nullopt;
        }
        waiting_[position] = {true, frame.data};
        return position;
    }
    return std::nullopt;
}

std::uint32_t SynchronousReceiver::sync() {
    std::uint32_t stored = 0;
    for (std::size_t position = 0; position < rows_.size(); ++position) {
        Waiting& waiting = waiting_[position];
        if (waiting.fresh) {
            scatter(rows_[position], waiting.data, values_);
            waiting.fresh = false;
            stored |= std::uint32_t{1} << position;
        }
    }
    return stored;
}

void SynchronousReceiver::cancel() {
    for (Waiting& waiting : waiting_) {
        waiting.fresh = false;
    }
}

}  // namespace cgw::canopen
