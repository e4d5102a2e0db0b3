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

// What goes into a reply: the command byte and bytes 4 to 7.
struct Answer {
    std::uint32_t payload;
    std::uint8_t command;
};

Answer refuse(AbortCode code) {
    return {static_cast<std::uint32_t>(code), sdo::abort};
}

bool asks_device(const SdoObjects& served, const object::ObjectEntry& entry) {
    return entry.handler != 0 && served.handler != nullptr;
}

Answer upload(const object::ObjectEntry& entry, std::uint32_t value) {
    return {value, sdo::expedited_command(sdo::upload_answer, entry.length)};
}

Answer ask_for_value(const SdoObjects& served, object::ObjectEntry entry) {
    std::uint32_t value = object::load_value(served.values, entry);
    const AbortCode code = served.handler->read(entry, value);
    return code == AbortCode::none ? upload(entry, value & object::value_mask(entry.length)) : refuse(code);
}

Answer read(const SdoObjects& served, const object::ObjectEntry& entry) {
    if (!readable(entry)) {
        return refuse(AbortCode::write_only);
    }
    return asks_device(served, entry) ? ask_for_value(served, entry)
                                      : upload(entry, object::load_value(served.values, entry));
}

AbortCode ask_to_write(const SdoObjects& served, object::ObjectEntry entry, std::uint32_t value) {
    return served.handler->write(entry, value);
}

// The order of the refusals is D51's.
Answer write(const SdoObjects& served, const object::ObjectEntry& entry, const frame::Frame& request) {
    const std::uint32_t length = stated_length(request, entry.length);
    if (length != entry.length) {
        return refuse(length > entry.length ? AbortCode::length_too_high : AbortCode::length_too_low);
    }
    if (!writable(entry)) {
        return refuse(AbortCode::read_only);
    }
    if ((request.data[0] & sdo::expedited) == 0) {
        return refuse(AbortCode::command_unknown);  // segmented transfer, which no device here has
    }
    const std::uint32_t value = sdo::payload(request) & object::value_mask(entry.length);
    if (asks_device(served, entry)) {
        const AbortCode code = ask_to_write(served, entry, value);
        if (code != AbortCode::none) {
            return refuse(code);
        }
    }
    object::store_value(served.values, entry, value);
    return {0, sdo::download_answer};
}

// `last_found` is where the table's search begins.
Answer answer_to(const frame::Frame& request, const SdoObjects& served, std::size_t& last_found) {
    const std::uint8_t command = request.data[0];
    const bool download = (command & sdo::download_mask) == sdo::download_request;
    if (command != sdo::upload_request && !download) {
        return refuse(AbortCode::command_unknown);
    }
    const sdo::Multiplexer object = sdo::multiplexer(request);
    const object::ObjectTable::Place place = served.table.locate(object.index, object.sub_index, last_found);
    if (place.found != object::Found::yes) {
        return refuse(missing(place.found));
    }
    last_found = place.position;
    const object::ObjectEntry entry = served.table.entry(place.position);
    return download ? write(served, entry, request) : read(served, entry);
}

}  // namespace

void SdoServer::open(std::uint8_t node_id, const SdoObjects& served) {
    served_ = served;
    last_found_ = 0;
    counters_ = {};
    clear();
    for (frame::Frame& reply : waiting_) {
        reply.id = cob::sdo_answer + node_id;
        reply.length = sdo::frame_length;
    }
}

bool SdoServer::receive(const frame::Frame& request, frame::FramePort* port) {
    if (!sdo::well_formed(request)) {
        return true;
    }
    if (request.data[0] == sdo::abort) {
        clear();
        return true;
    }
    if (count_ == capacity) {
        ++counters_.overflows;
        return false;
    }
    frame::Frame& reply = waiting_[(first_ + count_) % capacity];
    const Answer answer = answer_to(request, served_, last_found_);
    reply.data = request.data;  // index and sub-index are the request's, whatever the answer
    reply.data[0] = answer.command;
    wire::store_u32(&reply.data[4], answer.payload);
    ++(answer.command == sdo::abort ? counters_.aborts : counters_.answers);
    if (count_ == 0 && port != nullptr && port->send(reply)) {
        return true;
    }
    ++count_;
    if (count_ > 1 && port != nullptr) {
        send_pending(*port);
    }
    return true;
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

}  // namespace cgw::canopen
