#include "canopen/emergency.hpp"

#include <algorithm>

#include "wire/little_endian.hpp"

namespace cgw::canopen {
namespace {

constexpr std::uint8_t frame_length = 8;
constexpr std::size_t register_place = 2;
constexpr std::size_t manufacturer_place = 3;

}  // namespace

frame::Frame emergency_frame(std::uint32_t cob_id, const Emergency& emergency) {
    frame::Frame frame;
    frame.id = cob_id;
    frame.length = frame_length;
    wire::store_u16(frame.data.data(), emergency.code);
    frame.data[register_place] = emergency.error_register;
    std::copy(emergency.manufacturer.begin(), emergency.manufacturer.end(),
              frame.data.begin() + manufacturer_place);
    return frame;
}

std::optional<ReceivedEmergency> read_emergency(const frame::Frame& frame) {
    const auto node_id = static_cast<std::uint8_t>(frame.id & cob::node_mask);
    const bool ours = frame.id == cob::emergency + node_id && node_id != 0;
    if (!ours || frame.extended || frame.remote || frame.length != frame_length) {
        return std::nullopt;
    }
    ReceivedEmergency received{node_id, {wire::load_u16(frame.data.data()), frame.data[register_place], {}}};
    std::copy(frame.data.begin() + manufacturer_place, frame.data.end(),
              received.emergency.manufacturer.begin());
    return received;
}

bool EmergencyProducer::report(const Emergency& emergency) {
    if (count_ == capacity) {
        ++counters_.dropped;
        return false;
    }
    waiting_[(first_ + count_) % capacity] = emergency;
    ++count_;
    return true;
}

Time EmergencyProducer::poll(Time now, frame::FramePort& port) {
    while (count_ != 0) {
        if (now < free_at_) {
            return free_at_;
        }
        refused_ = !port.send(emergency_frame(cob_id_, waiting_[first_]));
        if (refused_) {
            return never;
        }
        first_ = (first_ + 1) % capacity;
        --count_;
        ++counters_.sent;
        free_at_ = now + inhibit_;
    }
    return never;
}

void ErrorHistory::add(std::uint16_t code, std::uint16_t information) {
    if (entries_.empty()) {
        return;
    }
    std::shift_right(entries_.begin(), entries_.end(), 1);
    entries_.front() = static_cast<std::uint32_t>(information) << 16 | code;
    count_ = std::min(count_ + 1, entries_.size());
}

object::AbortCode ErrorHistory::read(std::uint8_t sub_index, std::uint32_t& value) const {
    if (sub_index > count_) {
        return object::AbortCode::no_data;
    }
    value = sub_index == 0 ? static_cast<std::uint32_t>(count_) : entries_[sub_index - 1U];
    return object::AbortCode::none;
}

object::AbortCode ErrorHistory::write(std::uint8_t sub_index, std::uint32_t value) {
    if (sub_index != 0) {
        return object::AbortCode::read_only;
    }
    if (value != 0) {
        return object::AbortCode::value_invalid;
    }
    count_ = 0;
    return object::AbortCode::none;
}

}  // namespace cgw::canopen
