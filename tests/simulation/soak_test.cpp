// Hours and days of simulated time with random disturbances. All the while: only legal states and
// transitions, no PDO outside Operational in either direction, no transmit PDO lost between gateway and bus,
// no word of another governor cycle in a PDO, and no error without one of its causes. After each round
// everything is mended, and then the gateway must be Operational without an error, and every transmit PDO
// must come in time. Seeds are fixed, so that a failure comes again. CGW_SOAK_HOURS sets the simulated time,
// CGW_SOAK_SEED the first seed.
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <set>

#include "simulation/faults.hpp"
#include "simulation/installation.hpp"
#include "support/sample_plant.hpp"
#include "wire/little_endian.hpp"

namespace cgw::simulation {
namespace {

using canopen::NmtCommand;
using device::GatewayState;
using BusName = Plant::BusName;

constexpr Time second = 1'000'000;
constexpr unsigned first_error = facts::first_canopen_error;

// Sends what it is given; the frames of a node that means no good, or has lost its mind.
class Stranger final : public Participant {
  public:
    explicit Stranger(Bus& bus) : port_(&bus.attach(*this)) {}
    Time poll(Time /*now*/) override { return canopen::never; }
    void send(const frame::Frame& frame) { port_->send(frame); }

  private:
    frame::FramePort* port_;
};

bool may_follow(GatewayState before, GatewayState after) {
    switch (after) {
        case GatewayState::undefined:
        case GatewayState::init:
            return true;
        case GatewayState::pre_operational:
            return before != GatewayState::undefined;
        case GatewayState::operational:
        case GatewayState::stopped:
            return before != GatewayState::undefined && before != GatewayState::init;
    }
    return false;
}

// Looks at everything after every event on the buses.
class Inspector final : public Participant {
  public:
    explicit Inspector(Installation& installation) : installation_(&installation) {
        Plant& plant = installation.plant();
        plant.can1().observe([this](const frame::Frame&, Time now) { last_can1_ = now; });
        plant.can2().observe([this](const frame::Frame& frame, Time now) { see(frame, now); });
        plant.can2().attach_clock(*this);
    }

    Time poll(Time now) override {
        look(now);
        return canopen::never;
    }

    void allow(const std::set<unsigned>& errors) { allowed_.insert(errors.begin(), errors.end()); }
    void allow_none() { allowed_.clear(); }
    void gateway_was_reset() {
        sent_before_reset_ += sent_;
        sent_ = received_ = 0;
        state_ = GatewayState::undefined;
        entries_ = 0;
    }
    void can2_was_cut() { ++cuts_; }

    // Every frame that the port took has been on the bus, but for those lost on the wire by a cut.
    bool all_seen() const {
        const std::uint64_t taken = sent_before_reset_ + sent_;
        return seen_ <= taken && taken <= seen_ + cuts_;
    }
    std::uint64_t seen() const { return seen_; }

  private:
    void look(Time now) {
        const device::Gateway& gateway = installation_->plant().gateway();
        const GatewayState state = gateway.state();
        const bool at_once = last_can1_ == now && last_can2_ == now;  // both buses at this microsecond
        if (state != state_ && !at_once) {
            EXPECT_TRUE(may_follow(state_, state))
                << now << ": " << static_cast<int>(state_) << " to " << static_cast<int>(state);
        }
        const bool operational = state == GatewayState::operational || state_ == GatewayState::operational ||
                                 gateway.status().operational_entries != entries_;
        const std::uint32_t sent = gateway.slave().transmitter().counters().sent;
        const std::uint32_t received = gateway.slave().receiver().counters().received;
        if (!operational) {
            EXPECT_EQ(sent, sent_) << now;
            EXPECT_EQ(received, received_) << now;
        }
        state_ = state;
        entries_ = gateway.status().operational_entries;
        sent_ = sent;
        received_ = received;
        look_at_errors(gateway, now);
    }

    void look_at_errors(const device::Gateway& gateway, Time now) {
        const unsigned errors = gateway.errors().canopen_errors();
        if (errors == errors_) {
            return;
        }
        errors_ = errors;
        for (unsigned bit = 0; bit < 16; ++bit) {
            if (((errors >> bit) & 1U) != 0) {
                EXPECT_TRUE(allowed_.contains(first_error + bit)) << now << ": " << first_error + bit;
            }
        }
    }

    void see(const frame::Frame& frame, Time now) {
        last_can2_ = now;
        for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
            const image::Pdo pdo = installation_->image().pdo(position);
            if (!pdo.active || frame.extended || frame.remote || frame.id != pdo.cob_id) {
                continue;
            }
            ++seen_;
            for (std::size_t word = 1; position >= facts::binary_tpdos && word < pdo.word_count; ++word) {
                EXPECT_EQ(wire::load_u16(&frame.data[2 * word]), wire::load_u16(frame.data.data())) << now;
            }
        }
    }

    Installation* installation_;
    GatewayState state_ = GatewayState::undefined;
    std::uint8_t entries_ = 0;
    std::uint32_t sent_ = 0;
    std::uint32_t received_ = 0;
    std::uint64_t sent_before_reset_ = 0;
    std::uint64_t seen_ = 0;
    std::uint64_t cuts_ = 0;
    unsigned errors_ = 0;
    std::set<unsigned> allowed_;
    Time last_can1_ = canopen::never;
    Time last_can2_ = canopen::never;
};

class World {
  public:
    explicit World(unsigned seed) : random_(seed) {
        bytes_ = plant_.image();
        EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
        installation_.emplace(image_);
        stranger_.emplace(installation_->plant().can2());
        inspector_.emplace(*installation_);
        installation_->plant().governor().amend_data([this](device::GovernorData& data) {
            ++cycle_;
            data.analogue[0].fill(cycle_);  // TPDO4 and TPDO5 are active
            data.analogue[1].fill(static_cast<std::uint16_t>(~cycle_));
        });
    }

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_()) % limit; }
    Installation& installation() { return *installation_; }
    Plant& plant() { return installation_->plant(); }
    Inspector& inspector() { return *inspector_; }
    Stranger& stranger() { return *stranger_; }
    void run_for(Time time) { plant().run_until(plant().now() + time); }

    void reset_gateway() {
        plant().reset_gateway();
        inspector_->gateway_was_reset();
    }
    void connect(BusName bus, bool connected) {
        if (bus == BusName::can2 && !connected) {
            inspector_->can2_was_cut();
        }
        plant().connect(bus, connected);
    }

  private:
    std::mt19937 random_;
    test::SamplePlant plant_;
    base::Bytes bytes_;
    image::Image image_;
    std::optional<Installation> installation_;
    std::optional<Stranger> stranger_;
    std::optional<Inspector> inspector_;
    std::uint16_t cycle_ = 0;
};

// --- what may happen ---

struct Disturbance {
    std::string name;
    std::set<unsigned> errors;  // that it may bring about
    std::function<void(World&)> begin;
    std::function<void(World&)> end = [](World&) {};
    std::function<void(World&)> again = [](World&) {};  // now and then while it lasts
};

void command(World& world) {
    constexpr NmtCommand commands[] = {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
                                       NmtCommand::reset_node, NmtCommand::reset_communication};
    constexpr std::uint8_t nodes[] = {0, 5, 6};
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
    constexpr std::uint32_t known[] = {0x000, 0x605, 0x205, 0x305, 0x405, 0x77F, 0x705, 0x080};
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

Disturbance fault(const NamedFault& named) {
    std::set<unsigned> errors{12411};
    if (const unsigned error = device::row_of(std::get<device::Fault>(named.cause)).canopen_error;
        error != 0) {
        errors.insert(error);
    }
    return {std::string(named.name), std::move(errors),
            [&named](World& world) { world.plant().report(std::get<device::Fault>(named.cause), true); },
            [&named](World& world) { world.plant().report(std::get<device::Fault>(named.cause), false); }};
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
        plc.set_sensor(900, static_cast<std::uint16_t>(world.below(0x10000)));
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

std::vector<Disturbance> disturbances() {
    std::vector<Disturbance> all{
        silent_rpdos(),
        silent_heartbeat(),
        other_outputs(),
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
        if (std::holds_alternative<device::Fault>(named.cause))
            all.push_back(fault(named));
    }
    return all;
}

// --- rounds ---

void disturb(World& world, const std::vector<Disturbance>& all, std::string& what) {
    std::vector<const Disturbance*> chosen;
    for (std::uint32_t i = 1 + world.below(3); i > 0; --i) {
        const Disturbance& next = all[world.below(static_cast<std::uint32_t>(all.size()))];
        chosen.push_back(&next);
        what += next.name + ", ";
        world.inspector().allow(next.errors);
        next.begin(world);
        world.run_for(world.below(2'000'000));
    }
    for (std::uint32_t i = world.below(20); i > 0; --i) {
        chosen[world.below(static_cast<std::uint32_t>(chosen.size()))]->again(world);
        world.run_for(world.below(200'000));
    }
    for (const Disturbance* disturbance : chosen) {
        disturbance->end(world);
    }
}

// What an operator does after trouble, until the plant runs again.
void recover(World& world) {
    const device::GatewayErrors& errors = world.plant().gateway().errors();
    for (const device::FaultRow& row : device::fault_rows()) {
        if (row.clearing == device::Clearing::by_reset && errors.shown(row.fault)) {
            world.inspector().allow({12419});
            world.reset_gateway();
            break;
        }
    }
    world.run_for(second);
    world.plant().governor().clear_errors();
    world.run_for(5 * second);
    world.installation().node().master().command(NmtCommand::start, 5);
    world.run_for(2 * second);
}

void expect_health(World& world) {
    EXPECT_EQ(world.plant().gateway().state(), GatewayState::operational);
    EXPECT_EQ(world.plant().gateway().errors().canopen_errors(), 0);
    for (const std::uint16_t word : world.installation().error_words()) {
        EXPECT_EQ(word, 0);
    }
    const Time now = world.plant().now();
    for (std::size_t position = facts::binary_tpdos; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = world.installation().image().pdo(position);
        if (pdo.active && pdo.effective_us != 0) {
            const auto received = world.installation().node().received(pdo.cob_id);
            EXPECT_TRUE(received && now - received->time <= pdo.effective_us + 5'000)
                << "TPDO" << position + 1;
        }
    }
    for (int wait = 0; wait < 20 && !world.inspector().all_seen(); ++wait) {
        world.run_for(500);  // a frame is on its way
    }
    EXPECT_TRUE(world.inspector().all_seen());
}

Time soak_time() {
    constexpr Time usual = 200 * second;
    const char* hours = std::getenv("CGW_SOAK_HOURS");
    return hours == nullptr ? usual : static_cast<Time>(std::atof(hours) * 3600) * second;
}

TEST(Soak, of_random_disturbances_breaks_no_rule) {
    const std::vector<Disturbance> all = disturbances();
    Time simulated = 0;
    std::uint64_t frames = 0;
    std::uint64_t pdos = 0;
    unsigned rounds = 0;
    const char* first = std::getenv("CGW_SOAK_SEED");
    for (unsigned seed = first == nullptr ? 1U : static_cast<unsigned>(std::atoi(first));
         simulated < soak_time(); ++seed) {
        World world(seed);
        world.run_for(3 * second);
        expect_health(world);
        for (int round = 0; round < 20 && simulated + world.plant().now() < soak_time(); ++round, ++rounds) {
            std::string what;
            disturb(world, all, what);
            recover(world);
            expect_health(world);
            world.inspector().allow_none();
            ASSERT_FALSE(HasFailure())
                << "seed " << seed << ", round " << round << ": " << what << "at " << world.plant().now();
        }
        simulated += world.plant().now();
        frames += world.plant().can1().frames() + world.plant().can2().frames();
        pdos += world.inspector().seen();
    }
    std::cout << simulated / second << " s simulated, " << rounds << " rounds, " << frames << " frames, "
              << pdos << " transmit PDOs\n";
}

}  // namespace
}  // namespace cgw::simulation
