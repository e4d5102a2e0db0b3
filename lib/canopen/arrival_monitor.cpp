#include "canopen/arrival_monitor.hpp"

namespace cgw::canopen {

void ArrivalMonitor::arm(Time now) {
    last_ = now;
    armed_ = true;
    tripped_ = false;
}

void ArrivalMonitor::disarm() {
    armed_ = false;
    tripped_ = false;
}

void ArrivalMonitor::arrived(Time now) {
    if (!active()) {
        return;
    }
    expire(now);
    if (tripped_) {
        tripped_ = !arrived_since_trip_ || now - last_ > period_;
        arrived_since_trip_ = true;
    }
    last_ = now;
}

}  // namespace cgw::canopen
