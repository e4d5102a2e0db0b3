// What the two buses, the governor's half and the heartbeats must agree on.
#include "facts/gateway.hpp"
#include "image/verify.hpp"
#include "wire/search.hpp"

namespace cgw::image {
namespace {

// With manual timing the automatic bit rate means nothing; it may stand there or be 0.
bool is_bit_rate(std::uint16_t kbit, bool manual) {
    return (manual && kbit == 0) || wire::contains(facts::bit_rates_kbit, kbit);
}

bool is_heartbeat_time(std::uint32_t time_us) {
    return time_us % facts::gateway_main_cycle_us == 0 &&
           time_us / facts::gateway_main_cycle_us <= facts::maximum_heartbeat_cycles;
}

}  // namespace

bool buses_fit(const Image& image) {
    const Bus can1 = image.can1();
    const Bus can2 = image.can2();
    const Governor governor = image.governor();
    const bool rates = is_bit_rate(can1.bit_rate_kbit, can1.manual_timing) &&
                       is_bit_rate(can2.bit_rate_kbit, can2.manual_timing) &&
                       is_bit_rate(governor.bit_rate_kbit, governor.manual_timing);
    const bool same_rate =
        can1.manual_timing || governor.manual_timing || can1.bit_rate_kbit == governor.bit_rate_kbit;
    const bool crossed = can1.own_node <= facts::maximum_hzm_node && can1.own_node == governor.gateway_node &&
                         can1.peer_node == governor.own_node;
    return rates && same_rate && crossed && can2.own_node != can2.peer_node && can2.start_up_delay_ms == 0;
}

bool heartbeats_fit(const Image& image) {
    const Heartbeat heartbeat = image.heartbeat();
    const bool watched = heartbeat.consumer_us == 0 || heartbeat.consumer_node != 0;  // D14
    return is_heartbeat_time(heartbeat.producer_us) && is_heartbeat_time(heartbeat.consumer_us) && watched &&
           heartbeat.consumer_node == image.can2().peer_node;
}

}  // namespace cgw::image
