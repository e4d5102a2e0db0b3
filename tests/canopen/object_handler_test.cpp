// Objects with a handler number: the device has a say in what is read and written.
#include "canopen/sdo_server.hpp"
#include "canopen/table.hpp"
#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using object::AbortCode;
using object::Access;
using object::DataType;
using test::make_frame;

// Knows a heartbeat time (1) of at most 5000, and a temperature (2) measured when it is asked for.
class Device final : public ObjectHandler {
  public:
    AbortCode read(const object::ObjectEntry& entry, std::uint32_t& value) override {
        if (entry.handler == 2) {
            if (!sensor) {
                return AbortCode::wrong_device_state;
            }
            value = 0xFFFF'0000U | *sensor;
        }
        return AbortCode::none;
    }
    AbortCode write(const object::ObjectEntry& entry, std::uint32_t value) override {
        asked.emplace_back(entry.index, value);
        return refusal != AbortCode::none ? refusal
               : value > 5000             ? AbortCode::value_too_high
                                          : AbortCode::none;
    }

    std::optional<std::uint16_t> sensor = 215;
    AbortCode refusal = AbortCode::none;
    std::vector<std::pair<int, std::uint32_t>> asked;
};

class ObjectHandlers : public testing::Test {
  protected:
    ObjectHandlers() {
        table_.add(0x1017, 0, DataType::unsigned16, Access::rw, 1000, 0, 1)
            .add(0x1018, 1, DataType::unsigned32, Access::ro, 7, 0, 1)
            .add(0x2000, 0, DataType::unsigned16, Access::ro, 0, 0, 2)
            .add(0x2001, 0, DataType::unsigned16, Access::rw, 5)
            .add(0x2002, 0, DataType::unsigned16, Access::wo, 5, 0, 1);
    }
    frame::Frame answer(const std::vector<std::uint8_t>& request) {
        SdoServer server;
        server.open(5, {table_.objects(), table_.values, &device_});
        server.receive(make_frame(0x605, request), &port_);
        const std::vector<frame::Frame> sent = port_.take();
        EXPECT_EQ(sent.size(), 1U);
        return sent.empty() ? frame::Frame{} : sent.front();
    }

    test::Table table_;
    Device device_;
    test::RecordingPort port_;
};

TEST_F(ObjectHandlers, take_a_value_before_it_is_stored) {
    EXPECT_EQ(answer({0x2B, 0x17, 0x10, 0, 0xF4, 0x01, 0xEE, 0xEE}),
              make_frame(0x585, {0x60, 0x17, 0x10, 0, 0, 0, 0, 0}));
    EXPECT_EQ(device_.asked, (std::vector<std::pair<int, std::uint32_t>>{{0x1017, 500}}));
    EXPECT_EQ(table_.value(0x1017, 0), 500U);
}

TEST_F(ObjectHandlers, refuse_a_value_that_is_then_not_stored) {
    EXPECT_EQ(answer({0x2B, 0x17, 0x10, 0, 0x89, 0x13, 0, 0}),
              make_frame(0x585, {0x80, 0x17, 0x10, 0, 0x31, 0x00, 0x09, 0x06}));
    EXPECT_EQ(table_.value(0x1017, 0), 1000U);
}

TEST_F(ObjectHandlers, refuse_with_the_code_of_their_reason) {
    for (const AbortCode code : {AbortCode::value_invalid, AbortCode::value_too_low, AbortCode::not_stored,
                                 AbortCode::local_control, AbortCode::wrong_device_state}) {
        device_.refusal = code;
        const frame::Frame reply = answer({0x2B, 0x17, 0x10, 0, 1, 0, 0, 0});
        EXPECT_EQ(reply.data[0], 0x80);
        EXPECT_EQ(sdo::payload(reply), static_cast<std::uint32_t>(code));
    }
    EXPECT_EQ(table_.value(0x1017, 0), 1000U);
}

TEST_F(ObjectHandlers, are_not_asked_about_what_access_or_length_refuse) {
    EXPECT_EQ(sdo::payload(answer({0x2F, 0x17, 0x10, 0, 1, 0, 0, 0})), 0x06070013U);
    EXPECT_EQ(sdo::payload(answer({0x23, 0x18, 0x10, 1, 1, 0, 0, 0})), 0x06010002U);
    EXPECT_EQ(sdo::payload(answer({0x40, 0x02, 0x20, 0, 0, 0, 0, 0})), 0x06010001U);
    EXPECT_TRUE(device_.asked.empty());
}

TEST_F(ObjectHandlers, give_values_computed_on_demand) {
    EXPECT_EQ(answer({0x40, 0x00, 0x20, 0, 0, 0, 0, 0}),
              make_frame(0x585, {0x4B, 0x00, 0x20, 0, 215, 0, 0, 0}));
}

TEST_F(ObjectHandlers, leave_a_stored_value_as_it_is) {
    EXPECT_EQ(answer({0x40, 0x17, 0x10, 0, 0, 0, 0, 0}),
              make_frame(0x585, {0x4B, 0x17, 0x10, 0, 0xE8, 0x03, 0, 0}));
}

TEST_F(ObjectHandlers, refuse_to_be_read) {
    device_.sensor.reset();
    EXPECT_EQ(answer({0x40, 0x00, 0x20, 0, 0, 0, 0, 0}),
              make_frame(0x585, {0x80, 0x00, 0x20, 0, 0x22, 0x00, 0x00, 0x08}));
}

TEST_F(ObjectHandlers, are_not_asked_about_plain_memory) {
    device_.refusal = AbortCode::local_control;
    EXPECT_EQ(answer({0x2B, 0x01, 0x20, 0, 9, 0, 0, 0}).data[0], 0x60);
    EXPECT_EQ(table_.value(0x2001, 0), 9U);
    EXPECT_TRUE(device_.asked.empty());
}

TEST(ObjectHandler, that_is_missing_leaves_its_objects_plain_memory) {
    test::Table table;
    table.add(0x1017, 0, DataType::unsigned16, Access::rw, 1000, 0, 1);
    SdoServer server;
    server.open(5, {table.objects(), table.values});
    test::RecordingPort port;
    server.receive(make_frame(0x605, {0x2B, 0x17, 0x10, 0, 7, 0, 0, 0}), &port);
    EXPECT_EQ(port.take(), (std::vector{make_frame(0x585, {0x60, 0x17, 0x10, 0, 0, 0, 0, 0})}));
    EXPECT_EQ(table.value(0x1017, 0), 7U);
}

}  // namespace
}  // namespace cgw::canopen
