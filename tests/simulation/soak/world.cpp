#include "simulation/soak/world.hpp"

#include "base/files.hpp"
#include "driver/check_file.hpp"
#include "driver/scenario_file.hpp"
#include "object/object_table.hpp"
#include "wire/little_endian.hpp"

namespace cgw::simulation::soak {
namespace {

struct Genset {
    Genset() {
        const std::string path = CGW_SAMPLES "/genset.toml";
        std::string text = base::read_file(path, std::size_t{1} << 20U).value();
        const std::string_view slow = "[125, 500, 1000]";
        text.replace(text.find(slow), slow.size(), "[16, 32, 200]");
        file = driver::check_text(path, text);
        EXPECT_TRUE(file.valid());
        bytes = driver::image_bytes(file).value();
        EXPECT_EQ(image::Image::open(bytes, image), image::Status::ok);
    }
    driver::CheckedFile file;
    base::Bytes bytes;
    image::Image image;
};

}  // namespace

const image::Image& fast_genset() {
    static const Genset genset;
    return genset.image;
}

Inspector::Inspector(Installation& installation)
    : installation_(&installation), rules_(installation.image()) {
    const object::ObjectTable objects = installation.image().objects();
    for (std::size_t word = 0; word < binary_.size(); ++word) {
        const auto found = objects.find(facts::object::errors, static_cast<std::uint8_t>(word + 1));
        EXPECT_EQ(found.found, object::Found::yes);
        binary_[word] = found.entry;
    }
    Plant& plant = installation.plant();
    plant.can1().observe([this](const frame::Frame&, Time now) { last_can1_ = now; });
    plant.can2().observe([this](const frame::Frame& frame, Time now) {
        last_can2_ = now;
        rules_.carry(frame, now);
    });
    plant.watch_gateway([this, &plant](const frame::Frame& frame, bool taken) {
        const Time now = plant.now();
        rules_.offer(frame, taken, {now, plant.gateway().state(), hides_states(now)});
    });
    plant.governor().amend_data([this](device::GovernorData& data) {
        rules_.mark(data, errors_flicker_);
        engine_state_ = data.engine_state;
    });
    plant.governor().observe_process_data([this, &plant](std::uint8_t rpdo, const device::PdoWords& words) {
        rules_.forward(rpdo, words, plant.now());
    });
    plant.can2().attach_clock(*this);
}

Time Inspector::poll(Time now) {
    const device::Gateway& gateway = installation_->plant().gateway();
    Look look;
    look.now = now;
    look.state = gateway.state();
    look.operational_entries = gateway.status().operational_entries;
    look.pdos_received = gateway.slave().receiver().counters().received;
    look.canopen_errors = gateway.errors().canopen_errors();
    for (std::size_t word = 0; word < look.binary.size(); ++word) {
        look.binary[word] = static_cast<std::uint16_t>(object::load_value(gateway.values(), binary_[word]));
    }
    for (const AlarmRow& row : alarm_rows()) {
        look.alarms[static_cast<std::size_t>(row.alarm)] =
            installation_->plant().governor().alarms().present(row.alarm);
    }
    look.hides_states = hides_states(now);
    rules_.look(look);
    return canopen::never;
}

void Inspector::settle() {
    Plant& plant = installation_->plant();
    Settled settled;
    settled.now = plant.now();
    settled.state = plant.gateway().state();
    settled.errors = installation_->error_numbers();
    settled.alarms = plant.governor().alarms().any();
    settled.engine_runs = plant.governor().engine().state().running();
    settled.engine_state = engine_state_;
    const image::Image& image = installation_->image();
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        if (const auto received = installation_->node().received(image.pdo(position).cob_id)) {
            settled.tpdos[position] = {received->time, wire::load_u16(received->last.data.data())};
        }
    }
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        const image::Sensor sensor = image.sensor(i);
        const Plc::Outputs& outputs = installation_->plc().outputs();
        settled.sent.push_back(outputs[facts::rpdo_of_channel(sensor.channel) - 1U]
                                      [facts::word_of_channel(sensor.channel) - 1U]);
        settled.obeyed.push_back(plant.governor().inputs().sensor(sensor.number).word);
    }
    rules_.settle(settled);
}

World::World(unsigned seed)
    : random_(seed),
      installation_(fast_genset()),
      stranger_(installation_.plant().can2()),
      inspector_(installation_) {}

void World::reset_gateway() {
    plant().reset_gateway();
    rules().gateway_was_reset();
}

void World::connect(Plant::BusName bus, bool connected) {
    if (bus == Plant::BusName::can2 && !connected) {
        rules().can2_was_cut();
    }
    plant().connect(bus, connected);
}

void World::recover() {
    const device::GatewayErrors& errors = plant().gateway().errors();
    for (const device::FaultRow& row : device::fault_rows()) {
        if (row.clearing == device::Clearing::by_reset && errors.shown(row.fault)) {
            rules().allow({12419});
            reset_gateway();
            break;
        }
    }
    run_for(second);
    plant().governor().clear_errors();
    run_for(5 * second);
    // The engine runs down and cools before somebody may start it again.
    for (int wait = 0; wait < 60 && plant().governor().alarms().any(); ++wait) {
        run_for(second);
        plant().governor().clear_errors();
    }
    installation_.node().master().command(canopen::NmtCommand::start, installation_.image().can2().own_node);
    run_for(8 * second);
    inspector_.settle();
    for (int wait = 0; wait < 20 && !rules().all_carried(); ++wait) {
        run_for(500);  // a frame is on its way
    }
    rules().expect_all_carried(plant().now());
}

}  // namespace cgw::simulation::soak
