#include "cli/canopen-gateway/demonstration.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/canopen-gateway/display.hpp"
#include "cli/canopen-gateway/effects.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr Time second = 1'000'000;
constexpr std::uint16_t device_type = 0x1000;
constexpr std::uint16_t identity = 0x1018;
constexpr std::uint16_t heartbeat_time = 0x1017;

struct IdentityRow {
    std::uint16_t index;
    std::uint8_t sub_index;
    std::string_view name;
};

constexpr IdentityRow identity_rows[] = {
    {device_type, 0, "device type"}, {identity, 1, "vendor"},        {identity, 2, "product code"},
    {identity, 3, "revision"},       {identity, 4, "serial number"},
};

bool wait_for_boot_up(Session& session) {
    const auto booted = [&session] { return !session.node().boot_ups().empty(); };
    if (!session.run_until(booted, second)) {
        session.say("no boot-up message");
        return session.over();
    }
    session.say(fmt::format("boot-up of node {}", session.node().boot_ups().front().node_id));
    return true;
}

void show_identity(Session& session) {
    if (session.over()) {
        return;
    }
    session.say("identity by SDO");
    for (const IdentityRow& row : identity_rows) {
        const auto transfer = session.upload(row.index, row.sub_index);
        if (!transfer) {
            return;
        }
        const std::string value = transfer->abort_code == 0 ? fmt::format("{:08X}h", transfer->value)
                                                            : abort_text(transfer->abort_code);
        session.detail(fmt::format("{:04X}h:{} {:<14} {}", row.index, row.sub_index, row.name, value));
    }
}

bool start(Session& session) {
    if (session.over()) {
        return true;
    }
    session.master().command(canopen::NmtCommand::start, session.node_id());
    const auto started = [&session] {
        return session.plant().gateway().state() == device::GatewayState::operational;
    };
    if (!session.run_until(started, second)) {
        session.say("NMT start had no effect");
        return session.over();
    }
    session.say("NMT start: the gateway is Operational");
    return true;
}

void show_refused_write(Session& session) {
    if (session.over()) {
        return;
    }
    const auto transfer = session.download(heartbeat_time, 0, 500, 2);
    if (transfer) {
        session.say(fmt::format("SDO write to {:04X}h:0: {}", heartbeat_time,
                                transfer->abort_code == 0 ? "accepted" : abort_text(transfer->abort_code)));
    }
}

void show_heartbeats(Session& session) {
    const auto& heartbeats = session.node().heartbeats();
    const Time period = session.image().heartbeat().producer_us;
    if (period == 0) {
        session.say("heartbeat: off in this configuration");
    } else if (heartbeats.empty()) {
        session.say(fmt::format("heartbeat: none yet, one is due every {} ms", period / 1000));
    } else {
        session.say(fmt::format("heartbeats: {}, one every {} ms, the last one says {}", heartbeats.size(),
                                period / 1000, to_text(heartbeats.back().state)));
    }
}

}  // namespace

bool demonstrate(Session& session) {
    if (!wait_for_boot_up(session)) {
        return false;
    }
    show_identity(session);
    if (!start(session)) {
        return false;
    }
    set_healthy_outputs(session);
    if (session.run_for(3 * second)) {
        show_transmit_pdos(session);
    }
    show_effects(session);
    show_refused_write(session);
    while (session.run_for(second)) {
    }
    show_heartbeats(session);
    return true;
}

}  // namespace cgw::gateway_cli
