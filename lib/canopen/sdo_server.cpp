#include "canopen/sdo_server.hpp"

#include "canopen/protocol.hpp"

namespace cgw::canopen {
namespace {

using object::AbortCode;
using object::Access;

bool readable(const object::ObjectEntry& entry) {
    return entry.access != Access::wo;
}

bool writable(const object::ObjectEntry& entry) {
    const bool by_access = entry.access != Access::ro && entry.access != Access::constant;
    return by_access && (entry.flags & object::flag_sdo_read_only) == 0;
}

AbortCode missing(object::Found found) {
    return found == object::Found::no_object ? AbortCode::object_missing : AbortCode::sub_index_missing;
}

// The length a download states: 4 - n when expedited, bytes 5..8 otherwise; `expected` when it states none.
std::uint32_t stated_length(const frame::Frame& request, std::uint32_t expected) {
    const std::uint8_t command = request.data[0];
    if ((command & sdo::size_stated) == 0) {
        return expected;
    }
    if ((command & sdo::expedited) == 0) {
        return sdo::payload(request);
    }
    return static_cast<std::uint32_t>(sdo::expedited_maximum -
                                      ((command >> sdo::unused_shift) & sdo::unused_mask));
}

}  // namespace

SdoServer::SdoServer(std::uint8_t node_id, object::ObjectTable objects, std::span<std::uint8_t> values)
    : answer_id_(cob::sdo_answer + node_id), objects_(objects), values_(values) {}

void SdoServer::receive(const frame::Frame& request) {
    if (!sdo::well_formed(request)) {
        return;
    }
    if (request.data[0] == sdo::abort) {
        clear();
        return;
    }
    if (count_ == capacity) {
        ++counters_.overflows;
        return;
    }
    answer(request, waiting_[(first_ + count_) % capacity]);
    ++count_;
}

bool SdoServer::send_pending(frame::FramePort& port) {
    while (count_ != 0) {
        if (!port.send(waiting_[first_])) {
            return false;
        }
        first_ = (first_ + 1) % capacity;
        --count_;
    }
    return true;
}

// Answers are built where they wait: an upload is the most frequent thing a master asks for.
void SdoServer::answer(const frame::Frame& request, frame::Frame& reply) {
    const sdo::Multiplexer object = sdo::multiplexer(request);
    if (request.data[0] == sdo::upload_request) {
        reply = upload(object);
    } else if ((request.data[0] & sdo::download_mask) == sdo::download_request) {
        reply = download(request, object);
    } else {
        reply = refuse(object, AbortCode::command_unknown);
    }
}

frame::Frame SdoServer::upload(sdo::Multiplexer object) {
    const object::ObjectTable::Lookup lookup = objects_.find(object.index, object.sub_index, last_found_);
    if (lookup.found != object::Found::yes) {
        return refuse(object, missing(lookup.found));
    }
    last_found_ = lookup.position;
    if (!readable(lookup.entry)) {
        return refuse(object, AbortCode::write_only);
    }
    ++counters_.answers;
    return sdo::make_frame(answer_id_, sdo::expedited_command(sdo::upload_answer, lookup.entry.length),
                           object, object::load_value(values_, lookup.entry));
}

// The order of the refusals is D51's.
frame::Frame SdoServer::download(const frame::Frame& request, sdo::Multiplexer object) {
    const object::ObjectTable::Lookup lookup = objects_.find(object.index, object.sub_index);
    if (lookup.found != object::Found::yes) {
        return refuse(object, missing(lookup.found));
    }
    const std::uint32_t length = stated_length(request, lookup.entry.length);
    if (length != lookup.entry.length) {
        const bool too_long = length > lookup.entry.length;
        return refuse(object, too_long ? AbortCode::length_too_high : AbortCode::length_too_low);
    }
    if (!writable(lookup.entry)) {
        return refuse(object, AbortCode::read_only);
    }
    if ((request.data[0] & sdo::expedited) == 0) {
        return refuse(object, AbortCode::command_unknown);  // segmented transfer, which no device here has
    }
    object::store_value(values_, lookup.entry, sdo::payload(request));
    ++counters_.answers;
    return sdo::make_frame(answer_id_, sdo::download_answer, object, 0);
}

frame::Frame SdoServer::refuse(sdo::Multiplexer object, AbortCode code) {
    ++counters_.aborts;
    return sdo::make_frame(answer_id_, sdo::abort, object, static_cast<std::uint32_t>(code));
}

}  // namespace cgw::canopen
