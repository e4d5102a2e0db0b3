#include "simulation/plant.hpp"

namespace cgw::simulation {

unsigned bus_bit_rate_kbit(const image::Bus& bus) {
    return bus.manual_timing ? manual_bit_rate_kbit : bus.bit_rate_kbit;
}

Plant::Plant(const image::Image& gateway, const image::Image& governor)
    : gateway_image_(&gateway),
      can1_(bus_bit_rate_kbit(gateway.can1())),
      can2_(bus_bit_rate_kbit(gateway.can2())),
      governor_(can1_, governor),
      gateway_(can1_, can2_) {
    reset_gateway();
}

void Plant::reset_gateway() {
    gateway_.link.open(*gateway_image_, ++gateway_boot_);
    status_ = gateway_.gateway.open(*gateway_image_, now());
    for (const device::FaultRow& row : device::fault_rows()) {
        if (present(row.fault)) {
            pass_on(row.fault);
        }
    }
}

void Plant::reset_governor() {
    governor_.reset();
}

void Plant::report(device::Fault fault, bool present) {
    if (present) {
        causes_.insert(fault);
    } else {
        causes_.erase(fault);
    }
    pass_on(fault);
}

// Reported by name, or brought about by a bus that is cut.
bool Plant::present(device::Fault fault) const {
    return causes_.contains(fault) || (fault == device::Fault::can1_bus && !can1_.connected()) ||
           (fault == device::Fault::can2_bus && !can2_.connected());
}

void Plant::pass_on(device::Fault fault) {
    if (fault == device::Fault::governor_can_bus) {
        governor_.report_can_bus_error(present(fault));
    } else if (fault == device::Fault::governor_can_comm) {
        governor_.report_can_comm_error(present(fault));
    } else {
        gateway_.gateway.report(fault, present(fault), now());
    }
}

void Plant::connect(BusName name, bool connected) {
    bus(name).connect(connected);
    pass_on(name == BusName::can1 ? device::Fault::can1_bus : device::Fault::can2_bus);
}

}  // namespace cgw::simulation
