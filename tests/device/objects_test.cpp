// The object dictionary of the running gateway, and the images it refuses.
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::make_frame;

class GatewayObjects : public test::GatewayTest {
  protected:
    dictionary::Variable& variable(std::uint16_t index, std::size_t position) {
        for (dictionary::Object& object : plant_.dictionary.objects) {
            if (object.index == index) {
                return object.variables.at(position);
            }
        }
        throw std::out_of_range("no such object");
    }
    void remove(std::uint16_t index) {
        std::erase_if(plant_.dictionary.objects, [&](const auto& object) { return object.index == index; });
    }
};

TEST_F(GatewayObjects, answers_the_identity_of_the_image) {
    boot_up();
    EXPECT_EQ(upload(0x1000, 0), 0x00020191U);
    EXPECT_EQ(upload(0x1018, 0), 4U);
    EXPECT_EQ(upload(0x1018, 1), 0x161U);
    EXPECT_EQ(upload(0x1018, 2), 0x1B59U);
    EXPECT_EQ(upload(0x1018, 4), 0x01970102U);
    EXPECT_EQ(upload(0x1800, 1), 0x185U);
}

TEST_F(GatewayObjects, refuses_every_write_rww_objects_included) {
    boot_up();
    for (const std::uint16_t index : {std::uint16_t{0x2000}, std::uint16_t{0x2003}, std::uint16_t{0x2004}}) {
        gateway_.receive(canopen::sdo::make_frame(0x605, 0x2B, {index, 1}, 7), now_);
        EXPECT_EQ(port_.take(), (std::vector{canopen::sdo::make_frame(0x585, 0x80, {index, 1}, 0x06010002)}));
    }
}

TEST_F(GatewayObjects, keeps_error_words_live_in_every_communicating_state) {
    boot_up();
    data_.errors = {1, 2, 3, 4, 5, 6};
    cycle();
    for (std::uint8_t word = 1; word <= 6; ++word) {
        EXPECT_EQ(upload(0x2000, word), word);
    }
    nmt(NmtCommand::stop);
    data_.errors[0] = 0x55AA;
    cycle();
    nmt(NmtCommand::enter_pre_operational);
    EXPECT_EQ(upload(0x2000, 1), 0x55AAU);
}

TEST_F(GatewayObjects, keeps_analogue_words_live_before_operational) {
    boot_up();
    data_.analogue[0] = {100, 0xFFFE, 300, 400};
    cycle();
    EXPECT_EQ(upload(0x2001, 1), 100U);
    EXPECT_EQ(upload(0x2002, 1), 0xFFFEU);
    EXPECT_EQ(upload(0x2001, 2), 300U);
}

TEST_F(GatewayObjects, shows_any_error_in_bit_0_of_the_error_register) {
    boot_up();
    cycle();
    EXPECT_EQ(upload(0x1001, 0), 0x00U);
    data_.errors[4] = 0x0400;
    cycle();
    EXPECT_EQ(upload(0x1001, 0), 0x01U);
    data_.errors[4] = 0;
    cycle();
    EXPECT_EQ(upload(0x1001, 0), 0x00U);
}

TEST_F(GatewayObjects, shows_a_canopen_error_in_bit_4_of_the_error_register) {
    boot_up();
    gateway_.report(Fault::gateway_reset, true, now_);
    EXPECT_EQ(upload(0x2005, 0), 0x0100U);
    EXPECT_EQ(upload(0x1001, 0), 0x11U);
}

TEST_F(GatewayObjects, makes_the_dictionary_anew_with_each_initialisation) {
    start();
    gateway_.receive(make_frame(0x305, {0x34, 0x12}), now_);
    EXPECT_EQ(upload(0x2004, 1), 0x1234U);
    nmt(NmtCommand::reset_node);
    command(GovernorCommand::init);
    command(GovernorCommand::pre_operational);
    port_.take();
    EXPECT_EQ(upload(0x2004, 1), 0U);
}

TEST_F(GatewayObjects, keeps_the_governors_errors_through_an_initialisation) {
    start();
    data_.errors[0] = 9;
    nmt(NmtCommand::reset_node);
    cycle();
    command(GovernorCommand::init);
    command(GovernorCommand::pre_operational);
    port_.take();
    EXPECT_EQ(upload(0x2000, 1), 9U);
    nmt(NmtCommand::start);
    EXPECT_EQ(port_.take()[0], make_frame(0x185, {9, 0, 0, 0, 0, 0, 0, 0}));
}

TEST_F(GatewayObjects, refuses_an_image_without_an_object_it_writes) {
    remove(0x2005);
    EXPECT_EQ(open(), OpenStatus::object_missing);
    command(GovernorCommand::init);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(to_text(OpenStatus::object_missing), "an object that the gateway writes is missing");
}

TEST_F(GatewayObjects, refuses_an_image_without_the_error_register) {
    remove(0x1001);
    EXPECT_EQ(open(), OpenStatus::object_missing);
}

TEST_F(GatewayObjects, refuses_a_value_block_beyond_its_capacity_and_takes_one_that_just_fits) {
    const auto fill = [this](std::size_t bytes) {
        dictionary::Object object;
        object.index = 0x2100;
        for (std::size_t i = 0; i < bytes; ++i) {
            object.index = static_cast<std::uint16_t>(0x2100 + i / 200);
            object.variables.emplace_back().sub_index = static_cast<std::uint8_t>(i % 200);
            if (i % 200 == 199 || i + 1 == bytes) {
                plant_.dictionary.objects.push_back(object);
                object.variables.clear();
            }
        }
    };
    ASSERT_EQ(open(), OpenStatus::ok);
    const std::size_t used = gateway_.values().size();
    fill(Gateway::value_capacity - used);
    EXPECT_EQ(open(), OpenStatus::ok);
    EXPECT_EQ(gateway_.values().size(), Gateway::value_capacity);
    plant_.dictionary.objects.back().variables.emplace_back().sub_index = 201;
    EXPECT_EQ(open(), OpenStatus::values_too_large);
    EXPECT_EQ(to_text(OpenStatus::values_too_large), "the value block is larger than this gateway can hold");
}

TEST_F(GatewayObjects, falls_back_to_undefined_when_a_new_image_is_refused) {
    start();
    remove(0x2005);
    EXPECT_EQ(open(), OpenStatus::object_missing);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    data_.errors[0] = 1;
    EXPECT_TRUE(cycle().empty());
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
}

TEST_F(GatewayObjects, stays_small_enough_for_the_chip) {
    EXPECT_LE(sizeof(Gateway), 4096U);
}

}  // namespace
}  // namespace cgw::device
