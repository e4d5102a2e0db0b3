// The SDO server: expedited transfers over an object table and its value block (manual 5.2, D51, D58).
// An answer the port does not take is kept, in order; nothing is answered late with another object's data.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canopen/sdo.hpp"
#include "frame/frame.hpp"
#include "object/object_table.hpp"

namespace cgw::canopen {

class SdoServer {
  public:
    // Answers that may wait for a port that says "not now". A client waits for its answer, so more than one
    // means several clients on one channel, or one that gave up and asked again.
    static constexpr std::size_t capacity = 4;

    struct Counters {
        std::uint32_t answers = 0;    // uploads and downloads accepted
        std::uint32_t aborts = 0;     // requests refused with an abort code
        std::uint32_t overflows = 0;  // requests dropped because `capacity` answers were waiting
    };

    SdoServer() = default;
    // `values` must hold every value the table names and outlive the server, as must the table's bytes.
    SdoServer(std::uint8_t node_id, object::ObjectTable objects, std::span<std::uint8_t> values);

    // A frame with the server's request identifier: its answer waits for send_pending(). 80h cancels the
    // answers not yet sent.
    void receive(const frame::Frame& request);

    // Offers the waiting answers. False: the port did not take all of them.
    bool send_pending(frame::FramePort& port);

    void clear() { count_ = 0; }  // drops the waiting answers: Stopped and reset answer nothing
    bool pending() const { return count_ != 0; }
    const Counters& counters() const { return counters_; }

  private:
    void answer(const frame::Frame& request, frame::Frame& reply);
    frame::Frame upload(sdo::Multiplexer object);
    frame::Frame download(const frame::Frame& request, sdo::Multiplexer object);
    frame::Frame refuse(sdo::Multiplexer object, object::AbortCode code);

    std::uint32_t answer_id_ = 0;
    object::ObjectTable objects_;
    std::span<std::uint8_t> values_;
    std::array<frame::Frame, capacity> waiting_{};  // ring
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::size_t last_found_ = 0;  // masters read one object again and again, or all of them in order
    Counters counters_;
};

}  // namespace cgw::canopen
