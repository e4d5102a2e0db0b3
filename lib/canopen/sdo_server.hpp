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

// A device's say in objects whose entry has a handler number other than 0: what the number means is the
// device's own. An abort code other than `none` refuses the request, and nothing is stored.
class ObjectHandler {
  public:
    // An upload: `value` holds what is stored, and on return what is answered.
    virtual object::AbortCode read(const object::ObjectEntry& entry, std::uint32_t& value) = 0;
    // A download that access and length allow, before it is stored: the device checks the value and acts on
    // it. Bits beyond the entry's length are 0.
    virtual object::AbortCode write(const object::ObjectEntry& entry, std::uint32_t value) = 0;

  protected:
    ~ObjectHandler() = default;
};

// What a server serves. `values` holds every value that the table names; all outlive the server.
struct SdoObjects {
    object::ObjectTable table;
    std::span<std::uint8_t> values;
    ObjectHandler* handler = nullptr;  // none: every object is plain memory
};

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

    // With every reset, before anything else; drops what waits.
    void open(std::uint8_t node_id, const SdoObjects& served);

    // A frame with the server's request identifier. Its answer is offered to `port`, after older ones;
    // without a port, or when it takes nothing, it waits for send_pending(). 80h cancels the answers not yet
    // sent. False: an overflow, the request is dropped.
    bool receive(const frame::Frame& request, frame::FramePort* port = nullptr);

    // Offers the waiting answers. False: the port did not take all of them.
    bool send_pending(frame::FramePort& port);

    void clear() { count_ = 0; }  // drops the waiting answers: Stopped and reset answer nothing
    bool pending() const { return count_ != 0; }
    const Counters& counters() const { return counters_; }

  private:
    SdoObjects served_;
    std::array<frame::Frame, capacity> waiting_{};  // ring; identifier and length are written once
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::size_t last_found_ = 0;  // masters read one object again and again, or all of them in order
    Counters counters_;
};

}  // namespace cgw::canopen
