#include "runtime/measurements.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "catalogue/catalogue.hpp"
#include "runtime/status_page.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::runtime {
namespace {

struct NoLink final : device::GovernorLink {
    void status_changed(const device::GatewayStatus&) override {}
    void process_data(std::uint8_t, const device::PdoWords&) override {}
};

class GatewayMeasurements : public testing::Test {
  protected:
    void SetUp() override {
        open();
        diagnosis_.image = &image_;
        diagnosis_.gateway = &gateway_;
        diagnosis_.can1 = {"a simulated governor", true, 10, 20, 0};
        diagnosis_.can2 = {"hub:127.0.0.1:29536/can0", true, 30, 40, 5};
    }
    void open() {
        bytes_ = plant_.image();
        ASSERT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
        ASSERT_EQ(gateway_.open(image_, 0), device::OpenStatus::ok);
    }
    std::uint32_t value(std::uint16_t number) const {
        const auto found = measurement(diagnosis_, number);
        EXPECT_TRUE(found.has_value()) << number;
        return found.value_or(~0U);
    }
    void pre_operational() {
        gateway_.command(device::GovernorCommand::init, 0);
        gateway_.command(device::GovernorCommand::pre_operational, 0);
    }

    test::SamplePlant plant_;
    base::Bytes bytes_;
    image::Image image_;
    test::RecordingPort port_;
    NoLink link_;
    device::Gateway gateway_{port_, link_};
    Diagnosis diagnosis_;
};

TEST_F(GatewayMeasurements, are_all_of_the_catalogue_each_once) {
    std::set<std::uint16_t> wanted;
    for (const parameter::Row& row : catalogue::shipped_rows()) {
        if (row.device == parameter::Device::gateway && row.program == parameter::Program::application &&
            row.list == parameter::List::measurement) {
            wanted.insert(row.number);
        }
    }
    const Measurements all = measure(diagnosis_);
    std::multiset<std::uint16_t> seen;
    for (const Measurement& measurement : all.known) {
        seen.insert(measurement.row->number);
    }
    for (const auto* list : {&all.unknown, &all.without_meaning}) {
        for (const parameter::Row* row : *list) {
            seen.insert(row->number);
        }
    }
    EXPECT_EQ(seen, std::multiset<std::uint16_t>(wanted.begin(), wanted.end()));
}

TEST_F(GatewayMeasurements, tell_everything_from_2401_to_2425_and_12401_to_12424) {
    for (const parameter::Row* row : measure(diagnosis_).unknown) {
        EXPECT_TRUE(row->number > 2425 && row->number < 12400) << row->number;
    }
    std::vector<std::uint16_t> numbers;
    for (const parameter::Row* row : measure(diagnosis_).without_meaning) {
        numbers.push_back(row->number);
    }
    EXPECT_EQ(numbers, (std::vector<std::uint16_t>{2406, 12400, 12410}));  // D59
}

TEST_F(GatewayMeasurements, have_values_that_fit_their_range) {
    for (const Measurement& measurement : measure(diagnosis_).known) {
        EXPECT_TRUE(measurement.row->allows(measurement.value)) << measurement.row->number;
    }
}

TEST_F(GatewayMeasurements, show_exactly_the_state) {
    const auto states = [this] {
        std::string text;
        for (std::uint16_t number = 12401; number <= 12404; ++number) {
            text += std::to_string(value(number));
        }
        return text;
    };
    EXPECT_EQ(states(), "0000");  // Undefined
    gateway_.command(device::GovernorCommand::init, 0);
    EXPECT_EQ(states(), "0100");
    gateway_.command(device::GovernorCommand::pre_operational, 0);
    EXPECT_EQ(states(), "0010");
    gateway_.receive(test::make_frame(0, {1, 5}), 0);
    EXPECT_EQ(states(), "0001");
    gateway_.receive(test::make_frame(0, {2, 5}), 0);
    EXPECT_EQ(states(), "1000");
}

TEST_F(GatewayMeasurements, show_whether_the_connections_are_up) {
    EXPECT_EQ(value(2405), 1U);
    EXPECT_EQ(value(12405), 1U);
    diagnosis_.can1.up = false;
    EXPECT_EQ(value(2405), 0U);
    EXPECT_EQ(value(12405), 1U);
    diagnosis_.can2.up = false;
    EXPECT_EQ(value(12405), 0U);
}

TEST_F(GatewayMeasurements, show_which_governors_are_heard) {  // D11
    diagnosis_.governors_heard = 1U << 3 | 1U << 16 | 1U << 31;
    EXPECT_EQ(value(2411), 0x0008U);
    EXPECT_EQ(value(2410), 0x8001U);
    EXPECT_EQ(value(2424), 0U);
    EXPECT_EQ(value(2425), 0U);
}

TEST_F(GatewayMeasurements, show_an_error_its_sentinel_and_its_canopen_error) {
    pre_operational();
    gateway_.report(device::Fault::can2_bus, true, 0);
    EXPECT_EQ(value(3072), 1U);
    EXPECT_EQ(value(3074), 1U);
    EXPECT_EQ(value(3172), 1U);
    EXPECT_EQ(value(3173), 0U);
    EXPECT_EQ(value(12423), 1U);
    EXPECT_EQ(value(12424), 0U);
    gateway_.report(device::Fault::can2_bus, false, 0);
    gateway_.clear_errors(0);
    EXPECT_EQ(value(3072), 0U);
    EXPECT_EQ(value(12423), 0U);
    EXPECT_EQ(value(3172), 1U);  // counted for good
}

TEST_F(GatewayMeasurements, show_what_is_wrong_with_the_governor_by_its_node_number) {
    EXPECT_EQ(value(2402), 0U);
    EXPECT_EQ(value(2403), 0U);
    EXPECT_EQ(value(2404), 0U);
    gateway_.report(device::Fault::can1_overflow, true, 0);
    gateway_.report(device::Fault::governor_silent, true, 0);
    gateway_.report(device::Fault::node_number_twice, true, 0);
    EXPECT_EQ(value(2401), 0U);
    EXPECT_EQ(value(2402), 1U << 3);
    EXPECT_EQ(value(2403), 1U << 3);
    EXPECT_EQ(value(2404), 1U);
}

TEST_F(GatewayMeasurements, do_not_invent_a_bit_for_a_governor_beyond_15) {
    plant_.configuration.governor_node = plant_.configuration.governor_node_in_gateway = 20;
    open();
    EXPECT_EQ(measurement(diagnosis_, 2403), 0U);
    gateway_.report(device::Fault::governor_silent, true, 0);
    EXPECT_EQ(measurement(diagnosis_, 2403), std::nullopt);
}

TEST_F(GatewayMeasurements, show_the_identity_of_the_image) {
    EXPECT_EQ(value(3842), 12U);
    EXPECT_EQ(value(3844), 0x0197U);
    EXPECT_EQ(value(3845), 0x0102U);
}

TEST_F(GatewayMeasurements, stand_on_a_page_of_eighty_columns_by_number_and_name) {
    pre_operational();
    gateway_.report(device::Fault::can2_bus, true, 0);
    diagnosis_.can2.name = "hub:" + std::string(100, 'x') + "/can0";
    diagnosis_.governors_heard = 1U << 3;
    const std::string page = status_page(diagnosis_);
    const std::string id = base::short_id(diagnosis_.image->configuration_id());
    EXPECT_NE(page.find(fmt::format("\nconfiguration {}, node 5\n", id)), std::string::npos) << page;
    for (const char* part :
         {"state Pre-Operational",
          "CAN1  a simulated governor, up\n      frames received 10, sent 20, lost 0\n",
          "/can0, up\n      frames received 30, sent 40, lost 5\n",
          "  2411 CanDCNodeState15to01       0x0008\n", "  3172 SErrCanBus2                     1\n",
          " 12423 CanOpGWErrCanBus2               1\n", "not known to this program: 3099 EEPROMErrorCode, ",
          "meaning not printed in the manual: 2406 CanState, 12400 CanOpState,\n12410 CanOpErr\n"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
    }
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(base::width_of(line), 80U) << line;
    }
}

}  // namespace
}  // namespace cgw::runtime
