#include "simulation/faults.hpp"

namespace cgw::simulation {
namespace {

using enum device::Fault;
using enum EngineFault;

// Errors of the devices: those of the Gateway's table (device/gateway_errors.cpp).
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
    {"oil-leak", oil_leak, "the engine loses its oil: its pressure falls within 20 s"},
    {"cooling-failure", cooling_failure, "the engine's coolant gets hot within a minute"},
    {"charge-air-cooler", charge_air_cooler, "the charge air is no longer cooled, and gets hot under load"},
    {"load-rejection", load_rejection, "the engine's load is gone at once"},
    {"actuator-stuck", actuator_stuck,
     "the actuator stays where it is; an emergency stop still cuts the fuel"},
};

}  // namespace

std::span<const NamedFault> named_faults() {
    return table;
}

}  // namespace cgw::simulation
