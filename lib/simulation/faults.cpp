#include "simulation/faults.hpp"

namespace cgw::simulation {
namespace {

using enum device::Fault;

// Errors: those of the Gateway's table (device/gateway_errors.cpp).
constexpr NamedFault table[] = {
    {"governor-can-bus", governor_can_bus, "the governor's CAN controller has left the bus"},
    {"governor-can-comm", governor_can_comm, "the governor lost CAN telegrams"},
    {"can1-bus", can1_bus, "the gateway's controller of CAN1 has left the bus"},
    {"can1-overflow", can1_overflow, "a buffer of CAN1 at the gateway overflows"},
    {"node-number-twice", node_number_twice, "another gateway on CAN1 has the same number"},
    {"can2-bus", can2_bus, "the gateway's controller of CAN2 has left the bus"},
    {"can2-overflow", can2_receive_overflow, "the receive buffer of CAN2 at the gateway overflows"},
    {"parameter-store", parameter_store, "the gateway's parameters cannot be read"},
    {"program-memory", program_memory, "the gateway's program memory is damaged"},
    {"working-memory", working_memory, "the gateway's working memory is damaged"},
    {"supply-voltage", supply_voltage, "the gateway's supply voltage is out of range"},
    {"data", data, "the gateway has no valid configuration"},
    {"stack", stack, "the gateway's stack overflows"},
    {"internal", internal, "the gateway's program is disturbed"},
};

}  // namespace

std::span<const NamedFault> named_faults() {
    return table;
}

}  // namespace cgw::simulation
