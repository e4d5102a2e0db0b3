#include "canopen/sdo_client.hpp"

namespace cgw::canopen {

using object::AbortCode;

bool SdoClient::upload(sdo::Multiplexer object) {
    return begin(sdo::make_frame(cob::sdo_request + node_id_, sdo::upload_request, object, 0));
}

bool SdoClient::download(sdo::Multiplexer object, std::uint32_t value, std::uint8_t length) {
    const std::uint8_t command = sdo::expedited_command(sdo::download_request, length);
    return begin(sdo::make_frame(cob::sdo_request + node_id_, command, object, value));
}

bool SdoClient::begin(const frame::Frame& request) {
    if (status_ == Status::busy) {
        return false;
    }
    request_ = request;
    status_ = Status::busy;
    to_send_ = true;
    deadline_ = never;
    value_ = 0;
    length_ = 0;
    abort_code_ = AbortCode::none;
    return true;
}

void SdoClient::receive(const frame::Frame& frame) {
    const bool ours = frame.id == cob::sdo_answer + node_id_ && sdo::well_formed(frame);
    if (!ours || status_ != Status::busy || to_send_ ||
        sdo::multiplexer(frame) != sdo::multiplexer(request_)) {
        return;
    }
    const bool uploading = request_.data[0] == sdo::upload_request;
    if (frame.data[0] == sdo::abort) {
        status_ = Status::aborted;
        abort_code_ = static_cast<AbortCode>(sdo::payload(frame));
        deadline_ = never;
    } else if (uploading && (frame.data[0] & sdo::expedited_answer_mask) == sdo::expedited_answer) {
        take_upload(frame);
    } else if (!uploading && frame.data[0] == sdo::download_answer) {
        status_ = Status::done;
        deadline_ = never;
    } else {
        give_up(AbortCode::command_unknown);
    }
}

void SdoClient::take_upload(const frame::Frame& answer) {
    const std::uint8_t command = answer.data[0];
    const bool stated = (command & sdo::size_stated) != 0;
    const int unused = stated ? (command >> sdo::unused_shift) & sdo::unused_mask : 0;
    length_ = static_cast<std::uint8_t>(sdo::expedited_maximum - unused);
    value_ = sdo::payload(answer) & (0xFFFFFFFFU >> (8 * unused));
    status_ = Status::done;
    deadline_ = never;
}

// The server is told, so that it does not answer later.
void SdoClient::give_up(AbortCode code) {
    const sdo::Multiplexer object = sdo::multiplexer(request_);
    request_ = sdo::make_frame(request_.id, sdo::abort, object, static_cast<std::uint32_t>(code));
    to_send_ = true;
    status_ = Status::aborted;
    abort_code_ = code;
    deadline_ = never;
}

Time SdoClient::poll(Time now, frame::FramePort& port) {
    if (now >= deadline_) {
        give_up(AbortCode::timed_out);
    }
    if (to_send_ && port.send(request_)) {
        to_send_ = false;
        deadline_ = status_ == Status::busy ? now + timeout_ : never;
    }
    return deadline_;
}

}  // namespace cgw::canopen
