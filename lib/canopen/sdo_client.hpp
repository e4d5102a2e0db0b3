// The SDO client: one expedited transfer at a time with one server, as a state machine that never blocks.
#pragma once

#include <cstdint>

#include "canopen/protocol.hpp"
#include "canopen/sdo.hpp"
#include "frame/frame.hpp"
#include "object/vocabulary.hpp"

namespace cgw::canopen {

class SdoClient {
  public:
    enum class Status : std::uint8_t {
        idle,
        busy,
        done,     // an upload's value() and length() hold, or the download was accepted
        aborted,  // abort_code() tells why; timed_out when the server never answered
    };

    // `timeout` in microseconds, counted from the moment the port took the request.
    SdoClient(std::uint8_t server_node_id, Time timeout) : node_id_(server_node_id), timeout_(timeout) {}

    // False, and nothing changes, while a transfer is busy. `length` is 1, 2 or 4 bytes.
    bool upload(sdo::Multiplexer object);
    bool download(sdo::Multiplexer object, std::uint32_t value, std::uint8_t length);

    // Any frame; those that do not answer the running transfer are ignored, another object's late answer too.
    void receive(const frame::Frame& frame);

    // Sends the request when the port takes it, and gives up with 0504 0000h when the answer stays out.
    // Returns the next deadline; while pending() is true, call again as soon as the port has room.
    Time poll(Time now, frame::FramePort& port);
    bool pending() const { return to_send_; }

    Status status() const { return status_; }
    std::uint32_t value() const { return value_; }
    std::uint8_t length() const { return length_; }
    object::AbortCode abort_code() const { return abort_code_; }

  private:
    bool begin(const frame::Frame& request);
    void take_upload(const frame::Frame& answer);
    void give_up(object::AbortCode code);

    std::uint8_t node_id_;
    Time timeout_;
    Status status_ = Status::idle;
    bool to_send_ = false;  // request_ waits for the port
    frame::Frame request_;
    Time deadline_ = never;
    std::uint32_t value_ = 0;
    std::uint8_t length_ = 0;
    object::AbortCode abort_code_ = object::AbortCode::none;
};

}  // namespace cgw::canopen
