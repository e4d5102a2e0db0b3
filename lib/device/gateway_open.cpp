// Start: from the image's tables to the places in the value block, once.
#include "device/gateway.hpp"
#include "facts/communication.hpp"

namespace cgw::device {
namespace {

using facts::word_bytes;
using facts::words_per_pdo;

bool find(const object::ObjectTable& objects, std::uint16_t index, std::uint8_t sub_index,
          object::ObjectEntry& entry) {
    const object::ObjectTable::Lookup lookup = objects.find(index, sub_index);
    entry = lookup.entry;
    return lookup.found == object::Found::yes;
}

}  // namespace

std::string_view to_text(OpenStatus status) {
    switch (status) {
        case OpenStatus::ok:
            return "ok";
        case OpenStatus::values_too_large:
            return "the value block is larger than this gateway can hold";
        case OpenStatus::object_missing:
            return "an object that the gateway writes is missing";
    }
    return "unknown";
}

OpenStatus Gateway::open(const image::Image& image, canopen::Time now) {
    const OpenStatus status = take(image, now);
    open_ = status == OpenStatus::ok;
    if (!open_) {
        errors_.set(Fault::data, true);
        publish(GatewayState::undefined);
    }
    governor_->status_changed(status_);  // whatever it knew of the time before
    return status;
}

OpenStatus Gateway::take(const image::Image& image, canopen::Time now) {
    open_ = false;
    slave_.initialise();
    errors_.reset();
    status_ = {};
    operational_entries_ = 0;
    governor_errors_ = {};
    if (image.initial_values().size() > value_capacity) {
        return OpenStatus::values_too_large;
    }
    objects_ = image.objects();
    initial_values_ = image.initial_values();
    if (!find_places()) {
        return OpenStatus::object_missing;
    }
    for (std::size_t position = 0; position < pdos; ++position) {
        resolve(position, image.pdo(position));
    }
    configure(image, now);
    return OpenStatus::ok;
}

bool Gateway::find_places() {
    bool all = find(objects_, facts::object::error_register, 0, places_.error_register) &&
               find(objects_, facts::object::canopen_errors, 0, places_.canopen_errors);
    for (std::size_t word = 0; word < error_words; ++word) {
        const auto sub_index = static_cast<std::uint8_t>(word + 1);
        all = all && find(objects_, facts::object::errors, sub_index, places_.errors[word]);
    }
    places_.has_engine_state =
        find(objects_, facts::object::errors, facts::object::engine_state_sub, places_.engine_state);
    return all;
}

void Gateway::resolve(std::size_t position, const image::Pdo& pdo) {
    canopen::PdoRow& row = rows_[position];
    row = {};
    if (position < transmit_pdos) {
        const bool cyclic = pdo.active && position >= binary_pdos;
        rhythms_[position] = {cyclic ? pdo.cycles : std::uint16_t{0}, 0};
        transmit_states_[position] = {};
    } else {
        receive_monitors_[position - transmit_pdos] =
            canopen::ArrivalMonitor(pdo.active ? pdo.effective_us : 0);
    }
    if (!pdo.active) {
        return;
    }
    canopen::MappedValue* const places = &mapping_[position * words_per_pdo];
    for (std::size_t word = 0; word < pdo.word_count; ++word) {
        places[word] = place_of(pdo.mapping[word]);
    }
    row.cob_id = pdo.cob_id;
    row.length = static_cast<std::uint8_t>(pdo.word_count * word_bytes);
    row.mapping = {places, canopen::join_neighbours({places, pdo.word_count})};
}

// In a valid image every mapped object exists and is one word long.
canopen::MappedValue Gateway::place_of(const image::MappedObject& mapped) const {
    if (mapped.index == facts::object::unsigned16_dummy) {
        return {0, word_bytes, true};
    }
    return {objects_.find(mapped.index, mapped.sub_index).entry.offset, word_bytes, false};
}

void Gateway::configure(const image::Image& image, canopen::Time now) {
    const std::span<const canopen::PdoRow> rows(rows_);
    canopen::Slave::Tables tables;
    tables.node_id = image.can2().own_node;
    tables.heartbeat_period = image.heartbeat().producer_us;
    tables.objects = objects_;
    tables.values = {values_.data(), initial_values_.size()};
    tables.transmit = rows.first(transmit_pdos);
    tables.transmit_states = transmit_states_;
    tables.receive = rows.subspan(transmit_pdos);
    tables.receive_monitors = receive_monitors_;
    tables.partner_node = image.heartbeat().consumer_node;
    tables.partner_period = image.heartbeat().consumer_us;
    slave_.configure(tables);
    // 400: for so long after a reset nobody is missed.
    start_up_end_ = now + canopen::Time{image.can1().start_up_delay_ms} * 1000;
    governor_deadline_ = start_up_end_ + governor_silence;
    next_announcement_ = canopen::never;
    initialise(GatewayState::undefined);
}

}  // namespace cgw::device
