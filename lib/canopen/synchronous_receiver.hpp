// Receive PDOs of the synchronous transmission types 0..240: their data take effect at the next SYNC. A
// device gives its other receive PDOs to PdoReceiver, and a frame to both.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canopen/pdo.hpp"

namespace cgw::canopen {

class SynchronousReceiver {
  public:
    static constexpr std::size_t maximum_rows = 32;

    struct Waiting {
        bool fresh = false;  // `data` came since the last SYNC
        PdoData data{};
    };

    SynchronousReceiver() = default;
    // One `waiting` per row, at most maximum_rows; everything outlives the receiver.
    SynchronousReceiver(std::span<const PdoRow> rows, std::span<Waiting> waiting,
                        std::span<std::uint8_t> values)
        : rows_(rows), waiting_(waiting), values_(values) {}

    // Position of the row that keeps the frame's data until the next SYNC; a later frame replaces them.
    // Nothing when it is none of ours, or too short (D28).
    std::optional<std::size_t> receive(const frame::Frame& frame);
    // Stores what came since the last SYNC. Bit n: row n was among it.
    std::uint32_t sync();
    // Operational ends: what waits is forgotten.
    void cancel();

  private:
    std::span<const PdoRow> rows_;
    std::span<Waiting> waiting_;
    std::span<std::uint8_t> values_;
};

}  // namespace cgw::canopen
