#include "cli/canopen-gateway/demonstration.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/canopen_text.hpp"
#include "cli/canopen-gateway/display.hpp"
#include "cli/canopen-gateway/effects.hpp"
#include "facts/communication.hpp"

namespace cgw::gateway_cli {
namespace {

using facts::object::device_type;
using facts::object::identity;
constexpr std::uint16_t heartbeat_time = facts::object::producer_heartbeat;
constexpr Time second = 1'000'000;

struct IdentityRow {
    std::uint16_t index;
    std::uint8_t sub_index;
    std::string_view name;
};

constexpr IdentityRow identity_rows[] = {
    {device_type, 0, "device type"}, {identity, 1, "vendor"},        {identity, 2, "product code"},
    {identity, 3, "revision"},       {identity, 4, "serial number"},
};

// A run that ends before there was anything to show is no success: whoever asked for it would not notice a
// gateway that never starts.
void say_missing(PlantRun& plant_run, std::string_view what) {
    plant_run.say(plant_run.over() ? fmt::format("{}: the run is over, --duration is too short", what)
                                   : std::string(what));
}

bool wait_for_boot_up(PlantRun& plant_run) {
    const auto booted = [&plant_run] { return !plant_run.node().boot_ups().empty(); };
    if (!plant_run.run_until(booted, second)) {
        say_missing(plant_run, "no boot-up message");
        return false;
    }
    plant_run.say(fmt::format("boot-up of node {}", plant_run.node().boot_ups().front().node_id));
    return true;
}

void show_identity(PlantRun& plant_run) {
    if (plant_run.over()) {
        return;
    }
    plant_run.say("identity by SDO");
    for (const IdentityRow& row : identity_rows) {
        const auto transfer = plant_run.upload(row.index, row.sub_index);
        if (!transfer) {
            return;
        }
        const std::string value = transfer->abort_code == 0 ? fmt::format("0x{:08X}", transfer->value)
                                                            : abort_text(transfer->abort_code);
        plant_run.detail(
            fmt::format("{} {:<14} {}", base::object_text(row.index, row.sub_index), row.name, value));
    }
}

bool start(PlantRun& plant_run) {
    plant_run.master().command(canopen::NmtCommand::start, plant_run.node_id());
    const auto started = [&plant_run] {
        return plant_run.plant().gateway().state() == device::GatewayState::operational;
    };
    if (!plant_run.run_until(started, second)) {
        say_missing(plant_run, "NMT start had no effect");
        return false;
    }
    plant_run.say("NMT start: the gateway is Operational");
    return true;
}

void show_refused_write(PlantRun& plant_run) {
    if (plant_run.over()) {
        return;
    }
    const auto transfer = plant_run.download(heartbeat_time, 0, 500, 2);
    if (transfer) {
        plant_run.say(fmt::format("SDO write to {}: {}", base::object_text(heartbeat_time, 0),
                                  transfer->abort_code == 0 ? "accepted" : abort_text(transfer->abort_code)));
    }
}

void show_heartbeats(PlantRun& plant_run) {
    const auto& heartbeats = plant_run.node().heartbeats();
    const Time period = plant_run.image().heartbeat().producer_us;
    if (period == 0) {
        plant_run.say("heartbeat: off in this configuration");
    } else if (heartbeats.empty()) {
        plant_run.say(fmt::format("heartbeat: none yet, one is due every {} ms", period / 1000));
    } else {
        plant_run.say(fmt::format("heartbeats: {}, one every {} ms, the last one says {}", heartbeats.size(),
                                  period / 1000, to_text(heartbeats.back().state)));
    }
}

}  // namespace

bool demonstrate(PlantRun& plant_run) {
    if (!wait_for_boot_up(plant_run)) {
        return false;
    }
    show_identity(plant_run);
    if (!start(plant_run)) {
        return false;
    }
    plant_run.plc().set_healthy_outputs();
    plant_run.plc().send_outputs();
    if (plant_run.run_for(3 * second)) {
        show_transmit_pdos(plant_run);
    }
    show_effects(plant_run);
    show_refused_write(plant_run);
    while (plant_run.run_for(second)) {
    }
    show_heartbeats(plant_run);
    return true;
}

}  // namespace cgw::gateway_cli
