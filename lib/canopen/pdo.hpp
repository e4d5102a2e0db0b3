// The PDO engine: mapped values to frames and back, over tables resolved once at start. When to send is the
// device's business; that nothing is lost between the wish and the wire is this file's.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "frame/frame.hpp"
#include "wire/copy.hpp"

namespace cgw::canopen {

// A mapped value, or several that follow each other in the value block (join_neighbours): where they stand,
// or a dummy (0006h) that only takes up room.
struct MappedValue {
    std::uint16_t offset = 0;  // bytes
    std::uint8_t length = 0;   // bytes
    bool dummy = false;
};

// Makes one of values that follow each other in the value block, and of dummies that follow each other, so
// that they are copied at once. Returns how many are left, at the front of `mapping`.
std::size_t join_neighbours(std::span<MappedValue> mapping);

// One row of a PDO table. The mapping's lengths add up to `length`; 0: the PDO is not active.
struct PdoRow {
    std::uint16_t cob_id = 0;
    std::uint8_t length = 0;  // bytes, 0..8
    std::span<const MappedValue> mapping;
};

using PdoData = std::array<std::uint8_t, 8>;

// A copy of known length is an instruction or two, any other a call.
inline void copy_run(const std::uint8_t* from, std::size_t length, std::uint8_t* to) {
    switch (length) {
        case 2:
            wire::copy(from, 2, to);
            break;
        case 4:
            wire::copy(from, 4, to);
            break;
        case 8:
            wire::copy(from, 8, to);
            break;
        default:
            wire::copy(from, length, to);
            break;
    }
}

// From the value block to the bytes of a PDO; dummies and what is not mapped stay as they are in `data`.
inline void gather(const PdoRow& row, std::span<const std::uint8_t> values, PdoData& data) {
    std::uint8_t* to = data.data();
    for (const MappedValue& value : row.mapping) {
        if (!value.dummy) {
            copy_run(values.data() + value.offset, value.length, to);
        }
        to += value.length;
    }
}

// From the bytes of a PDO to the value block.
inline void scatter(const PdoRow& row, const PdoData& data, std::span<std::uint8_t> values) {
    const std::uint8_t* from = data.data();
    for (const MappedValue& value : row.mapping) {
        if (!value.dummy) {
            copy_run(from, value.length, values.data() + value.offset);
        }
        from += value.length;
    }
}

struct TransmitState {
    bool pending = false;
    PdoData last_sent{};
};

class PdoTransmitter {
  public:
    struct Counters {
        std::uint32_t sent = 0;
        std::uint32_t deferred = 0;    // times the port said "not now"
        std::uint32_t superseded = 0;  // requested again while still waiting: one frame with the newest data
    };

    PdoTransmitter() = default;
    // One state per row; rows, states and values outlive the transmitter.
    PdoTransmitter(std::span<const PdoRow> rows, std::span<TransmitState> states,
                   std::span<const std::uint8_t> values);

    void request(std::size_t position) {
        TransmitState& state = states_[position];
        if (state.pending) {
            ++counters_.superseded;
        } else if (rows_[position].length != 0) {
            state.pending = true;
            ++waiting_;
        }
    }
    // Requests when the data differ from what was last really sent.
    void request_if_changed(std::size_t position);
    // Leaving Operational: what waits is not sent any more.
    void cancel();

    // Sends what waits, with the values of this moment. False: the port did not take all of it. The next call
    // goes on where this one stopped, so that a slow port starves no PDO.
    bool send_pending(frame::FramePort& port);

    bool pending() const { return waiting_ != 0; }
    bool pending(std::size_t position) const { return states_[position].pending; }
    const Counters& counters() const { return counters_; }

  private:
    frame::Frame build(std::size_t position) const;

    std::span<const PdoRow> rows_;
    std::span<TransmitState> states_;
    std::span<const std::uint8_t> values_;
    std::size_t next_ = 0;
    std::size_t waiting_ = 0;
    Counters counters_;
};

class PdoReceiver {
  public:
    struct Counters {
        std::uint32_t received = 0;
        std::uint32_t too_short = 0;  // shorter than mapped: not processed (D28)
    };

    PdoReceiver() = default;
    PdoReceiver(std::span<const PdoRow> rows, std::span<std::uint8_t> values);

    // Position of the row whose values were taken from the frame. Nothing when it is no receive PDO of ours,
    // or too short (D28); a longer one gives its first bytes.
    std::optional<std::size_t> receive(const frame::Frame& frame) {
        for (std::size_t position = 0; position < rows_.size(); ++position) {
            const PdoRow& row = rows_[position];
            if (row.cob_id == frame.id && row.length != 0) {
                return take(row, frame) ? std::optional(position) : std::nullopt;
            }
        }
        return std::nullopt;
    }

    const Counters& counters() const { return counters_; }

  private:
    bool take(const PdoRow& row, const frame::Frame& frame);

    std::span<const PdoRow> rows_;
    std::span<std::uint8_t> values_;
    Counters counters_;
};

}  // namespace cgw::canopen
