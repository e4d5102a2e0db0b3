#include "simulation/soak/disturbances.hpp"

#include "simulation/faults.hpp"

namespace cgw::simulation::soak {
namespace {

using canopen::NmtCommand;
using BusName = Plant::BusName;

void command(World& world) {
    constexpr NmtCommand commands[] = {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
                                       NmtCommand::reset_node, NmtCommand::reset_communication};
    const std::uint8_t own = world.installation().image().can2().own_node;
    const std::uint8_t nodes[] = {0, own, static_cast<std::uint8_t>(own + 1)};
    world.installation().node().master().command(commands[world.below(5)], nodes[world.below(3)]);
}

void ask(World& world) {
    canopen::SdoClient& sdo = world.installation().node().master().sdo();
    constexpr std::uint16_t objects[] = {0x1000, 0x1018, 0x2000, 0x2005, 0x2003, 0x5000};
    const canopen::sdo::Multiplexer object{objects[world.below(6)],
                                           static_cast<std::uint8_t>(world.below(3))};
    if (world.below(2) == 0) {
        sdo.upload(object);
    } else {
        sdo.download(object, world.below(0x10000), 2);
    }
}

void babble(World& world) {
    const std::uint32_t own = world.installation().image().can2().own_node;
    const std::uint32_t partner = world.installation().image().heartbeat().consumer_node;
    const std::uint32_t known[] = {0x000,       0x600 + own, 0x200 + own,     0x300 + own,
                                   0x400 + own, 0x500 + own, 0x700 + partner, 0x700 + own};
    frame::Frame frame;
    frame.id = world.below(3) == 0 ? world.below(0x800) : known[world.below(8)];
    frame.extended = world.below(8) == 0;
    frame.remote = world.below(8) == 0;
    frame.length = static_cast<std::uint8_t>(world.below(9));
    for (std::uint8_t& byte : frame.data) {
        byte = static_cast<std::uint8_t>(world.below(256));
    }
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        if (frame.id == world.installation().image().pdo(position).cob_id) {
            return;  // nobody else sends the gateway's own
        }
    }
    world.stranger().send(frame);
}

Disturbance cut(BusName bus, std::string name, std::set<unsigned> errors) {
    return {std::move(name), std::move(errors), [bus](World& world) { world.connect(bus, false); },
            [bus](World& world) { world.connect(bus, true); }};
}

Disturbance jam(BusName bus, std::string name, std::set<unsigned> errors) {
    return {std::move(name), std::move(errors),
            [bus](World& world) {
                frame::Frame frame;
                frame.id = 1;
                frame.length = static_cast<std::uint8_t>(world.below(9));
                world.installation().jammer(bus).start(frame, canopen::never);
            },
            [bus](World& world) { world.installation().jammer(bus).start({}, 0); }};
}

Disturbance device_fault(const NamedFault& named, device::Fault cause) {
    // 0 stands for none, which nobody shows.
    std::set<unsigned> errors{12411, device::row_of(cause).error, device::row_of(cause).canopen_error};
    return {std::string(named.name), std::move(errors),
            [cause](World& world) { world.plant().report(cause, true); },
            [cause](World& world) { world.plant().report(cause, false); }};
}

std::set<Alarm> alarms_of(EngineFault fault) {
    switch (fault) {
        case EngineFault::oil_leak:
            return {Alarm::low_oil_pressure, Alarm::lost_oil_pressure};
        case EngineFault::cooling_failure:
            return {Alarm::hot_coolant, Alarm::overheated_coolant};
        case EngineFault::charge_air_cooler:
            return {Alarm::hot_charge_air};
        case EngineFault::load_rejection:
        case EngineFault::actuator_stuck:
            return {Alarm::overspeed};
    }
    return {};
}

Disturbance engine_fault(const NamedFault& named, EngineFault cause) {
    Disturbance disturbance{std::string(named.name),
                            {},
                            [cause](World& world) { world.plant().report(cause, true); },
                            [cause](World& world) { world.plant().report(cause, false); }};
    disturbance.alarms = alarms_of(cause);
    disturbance.lasts = 30 * second;  // nothing breaks from one moment to the next
    return disturbance;
}

Disturbance fault(const NamedFault& named) {
    const auto* const engine = std::get_if<EngineFault>(&named.cause);
    return engine != nullptr ? engine_fault(named, *engine)
                             : device_fault(named, std::get<device::Fault>(named.cause));
}

Disturbance silent_rpdos() {
    return {"silent RPDOs",
            {12413},
            [](World& world) { world.installation().plc().silence_rpdo(2, true); },
            [](World& world) { world.installation().plc().silence_rpdo(2, false); }};
}

Disturbance silent_heartbeat() {
    return {"silent heartbeat",
            {12420},
            [](World& world) { world.installation().plc().silence_heartbeat(true); },
            [](World& world) { world.installation().plc().silence_heartbeat(false); }};
}

Disturbance other_outputs() {
    const auto change = [](World& world) {
        Plc& plc = world.installation().plc();
        const image::Image& image = world.installation().image();
        for (std::size_t i = 0; i < image.sensor_count(); ++i) {
            plc.set_sensor(image.sensor(i).number, static_cast<std::uint16_t>(world.below(0x10000)));
        }
        plc.flag_sensor(world.below(2) == 0 ? 900 : 906, world.below(2) == 0);
        plc.set_switch(world.below(2) == 0 ? 811 : 835, world.below(2) == 0);
        plc.send_outputs();
    };
    return {"other outputs",
            {},
            change,
            [](World& world) {
                world.installation().plc().set_healthy_outputs();
                world.installation().plc().send_outputs();
            },
            change};
}

Disturbance flickering_errors() {
    return {"flickering errors of the governor",
            {},
            [](World& world) { world.inspector().let_errors_flicker(true); },
            [](World& world) { world.inspector().let_errors_flicker(false); }};
}

}  // namespace

std::vector<Disturbance> disturbances() {
    std::vector<Disturbance> all{
        silent_rpdos(),
        silent_heartbeat(),
        other_outputs(),
        flickering_errors(),
        cut(BusName::can2, "cut CAN2", {12423, 12413, 12420}),
        cut(BusName::can1, "cut CAN1", {12421, 12422, 12415, 12412, 12419, 12411}),
        jam(BusName::can2, "jam CAN2", {12413, 12420}),
        jam(BusName::can1, "jam CAN1", {12422, 12415, 12412, 12419, 12411}),
        {"gateway reset", {12419}, [](World& world) { world.reset_gateway(); }},
        {"governor reset", {12411}, [](World& world) { world.plant().reset_governor(); }},
        {"commands", {}, command, [](World&) {}, command},
        {"questions", {}, ask, [](World&) {}, ask},
        // Others' heartbeats and RPDOs may come too late as well, and a flood of questions overflows.
        {"babble",
         {12413, 12420, 12424},
         babble,
         [](World&) {},
         [](World& world) {
             for (std::uint32_t i = world.below(40); i > 0; --i) {
                 babble(world);
             }
         }},
        {"errors cleared",
         {},
         [](World& world) { world.plant().governor().clear_errors(); },
         [](World&) {},
         [](World& world) { world.plant().clear_gateway_errors(); }},
    };
    for (const NamedFault& named : named_faults()) {
        all.push_back(fault(named));
    }
    return all;
}

}  // namespace cgw::simulation::soak
