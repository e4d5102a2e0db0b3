#include "runtime/gateway_node.hpp"

#include <algorithm>

#include "link/telegram.hpp"

namespace cgw::runtime {
namespace {

using device::Fault;

// What the fault table knows of a connection's troubles (GWM 9.4, 9.5).
Fault bus_fault(Side side) {
    return side == Side::can1 ? Fault::can1_bus : Fault::can2_bus;
}
Fault overflow_fault(Side side) {
    return side == Side::can1 ? Fault::can1_overflow : Fault::can2_receive_overflow;
}

}  // namespace

GatewayNode::GatewayNode(const image::Image& image, Connection can1, Connection can2, std::uint8_t boot,
                         Events& events)
    : events_(&events), image_(&image) {
    end(Side::can1).view.name = can1.name;
    end(Side::can2).view.name = can2.name;
    end(Side::can1).connection = std::move(can1);
    end(Side::can2).connection = std::move(can2);
    if (!channel_on(Side::can1)) {
        simulated_.emplace(image, can1_place_);
        simulated_->bus.observe(
            [this](const frame::Frame& frame, Time) { events_->frame(Side::can1, frame); });
        end(Side::can1).view.up = true;
    }
    link_.connect(gateway_);
    link_.open(image, boot);
    status_ = gateway_.open(image, now_);
}

std::optional<std::uint32_t> GatewayNode::bit_rate(Side side) const {
    return channel_on(side) ? end(side).connection.channel->bit_rate() : std::nullopt;
}

void GatewayNode::clear_errors(Time steady_now) {
    service({}, steady_now);
    link_.clear_errors(now_);
    link_deadline_ = link_.poll(now_);
}

Diagnosis GatewayNode::diagnosis() const {
    Diagnosis diagnosis;
    diagnosis.image = image_;
    diagnosis.gateway = &gateway_;
    diagnosis.can1 = end(Side::can1).view;
    diagnosis.can2 = end(Side::can2).view;
    diagnosis.now = now_;
    for (std::size_t node = 0; node < heard_.size(); ++node) {
        if (heard_[node] && now_ - *heard_[node] <= link::silence) {
            diagnosis.governors_heard |= 1U << node;
        }
    }
    return diagnosis;
}

void GatewayNode::watch(std::vector<pollfd>& entries) const {
    for (const End& end : ends_) {
        if (const media::Channel* const channel = end.connection.channel.get(); channel != nullptr) {
            entries.push_back({channel->descriptor(), channel->events(), 0});
        }
    }
}

Time GatewayNode::deadline() const {
    Time own = std::min(gateway_deadline_, link_deadline_);
    if (simulated_) {
        own = std::min(own, simulated_->bus.next_event());
    }
    Time next = clock_.steady_at(own);
    for (const End& end : ends_) {
        if (end.connection.channel != nullptr) {
            next = std::min(next, end.connection.channel->deadline());
        }
    }
    return next;
}

// The simulated bus runs up to now before anything of now comes from outside, so that the gateway's time
// never goes backwards. After every service of a channel the gateway is asked again, which is when frames
// that had no room are offered anew.
void GatewayNode::service(std::span<const pollfd> entries, Time steady_now) {
    if (!started_) {
        started_ = true;
        clock_ = RunClock(steady_now);
    }
    now_ = clock_.at(steady_now);
    if (clock_.left_out() != 0) {
        events_->left_out(clock_.left_out());
    }
    run_simulation();
    std::size_t position = 0;
    serve(Side::can1, entries, position, steady_now);
    serve(Side::can2, entries, position, steady_now);
    gateway_deadline_ = gateway_.poll(now_);
    link_deadline_ = link_.poll(now_);
    run_simulation();
    hear_refusal();
}

void GatewayNode::serve(Side side, std::span<const pollfd> entries, std::size_t& position, Time steady_now) {
    if (!channel_on(side)) {
        return;
    }
    media::Channel& channel = *end(side).connection.channel;
    const bool ready = position < entries.size() && entries[position].revents != 0;
    ++position;
    if (ready || channel.deadline() <= steady_now) {
        channel.service(steady_now, listeners_[static_cast<std::size_t>(side)]);
    }
}

void GatewayNode::run_simulation() {
    if (simulated_) {
        simulated_->bus.run_until(now_);
    }
}

void GatewayNode::take_can1(const frame::Frame& frame, Time now) {
    ++end(Side::can1).view.received;
    if (const auto telegram = link::read_telegram(frame); telegram) {
        const link::Address self{link::DeviceType::gateway, image_->can1().own_node};
        if (telegram->from.type == link::DeviceType::governor && telegram->to == self) {
            heard_[telegram->from.node % heard_.size()] = now;
        }
    }
    link_.receive(frame, now);
}

void GatewayNode::hear_refusal() {
    if (link_.refusals() != refusals_) {
        refusals_ = link_.refusals();
        events_->governor_refused(link_.refusal());
    }
}

bool GatewayNode::Port::send(const frame::Frame& frame) {
    const bool channel = of->channel_on(where);
    frame::FramePort& port =
        channel ? static_cast<frame::FramePort&>(*of->end(where).connection.channel) : of->simulated_->port;
    if (!port.send(frame)) {
        return false;
    }
    ++of->end(where).view.sent;
    if (channel) {
        of->events_->frame(where, frame);
    }
    return true;
}

void GatewayNode::Listener::frame(const frame::Frame& frame, Time) {
    of->events_->frame(where, frame);
    if (where == Side::can1) {
        of->take_can1(frame, of->now_);
    } else {
        ++of->end(where).view.received;
        of->gateway_.receive(frame, of->now_);
    }
}

void GatewayNode::Listener::link_changed(media::LinkState state, std::string_view reason, Time) {
    of->end(where).view.up = state == media::LinkState::up;
    of->events_->link_changed(where, state, reason);
    of->gateway_.report(bus_fault(where), state == media::LinkState::down, of->now_);
}

void GatewayNode::Listener::frames_lost(std::uint64_t count, Time) {
    of->end(where).view.lost += count;
    of->events_->frames_lost(where, count);
    of->gateway_.report(overflow_fault(where), true, of->now_);
    of->gateway_.report(overflow_fault(where), false, of->now_);
}

void GatewayNode::StatusTap::status_changed(const device::GatewayStatus& status) {
    of->link_.status_changed(status);
    const device::GatewayStatus before = of->told_;
    of->told_ = status;
    of->events_->status_changed(before, status);
}

void GatewayNode::StatusTap::process_data(std::uint8_t rpdo, const device::PdoWords& words) {
    of->link_.process_data(rpdo, words);
}

Time GatewayNode::Can1Place::poll(Time now) {
    return of->link_.poll(now);
}

void GatewayNode::Can1Place::receive(const frame::Frame& frame, Time now) {
    of->take_can1(frame, now);
}

}  // namespace cgw::runtime
