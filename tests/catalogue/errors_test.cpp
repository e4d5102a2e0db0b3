// Every error of the manual's sections 9.3 to 9.7 is described, and every description belongs to a parameter.
#include "catalogue/errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "catalogue/catalogue.hpp"
#include "parameter/catalogue.hpp"

namespace {

using cgw::catalogue::ErrorDescription;
using cgw::catalogue::find_error;
using cgw::catalogue::shipped_errors;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::Program;

constexpr Device devices[] = {Device::governor, Device::gateway};

struct Printed {
    Device device;
    Program program;
    std::uint16_t number;
};

constexpr auto application = Program::application;
constexpr auto bootloader = Program::bootloader;

// clang-format off
constexpr Printed printed[] = {
    // 9.3.2, 9.3.3
    {Device::gateway, bootloader, 3075}, {Device::gateway, bootloader, 3076}, {Device::gateway, bootloader, 3078},
    {Device::gateway, bootloader, 3079}, {Device::gateway, bootloader, 3087}, {Device::gateway, bootloader, 3089},
    {Device::gateway, bootloader, 3094}, {Device::gateway, bootloader, 3800},
    // 9.4
    {Device::gateway, application, 3070}, {Device::gateway, application, 3071}, {Device::gateway, application, 3072},
    {Device::gateway, application, 3073}, {Device::gateway, application, 3074}, {Device::gateway, application, 3076},
    {Device::gateway, application, 3077}, {Device::gateway, application, 3078}, {Device::gateway, application, 3085},
    {Device::gateway, application, 3090}, {Device::gateway, application, 3093}, {Device::gateway, application, 3094},
    {Device::gateway, application, 3099},
    {Device::gateway, application, 3170}, {Device::gateway, application, 3171}, {Device::gateway, application, 3172},
    {Device::gateway, application, 3173}, {Device::gateway, application, 3174}, {Device::gateway, application, 3176},
    {Device::gateway, application, 3177}, {Device::gateway, application, 3178}, {Device::gateway, application, 3185},
    {Device::gateway, application, 3190}, {Device::gateway, application, 3193}, {Device::gateway, application, 3194},
    // 9.5, shown by both
    {Device::gateway, application, 12411}, {Device::gateway, application, 12412}, {Device::gateway, application, 12413},
    {Device::gateway, application, 12414}, {Device::gateway, application, 12415}, {Device::gateway, application, 12419},
    {Device::gateway, application, 12420}, {Device::gateway, application, 12421}, {Device::gateway, application, 12422},
    {Device::gateway, application, 12423}, {Device::gateway, application, 12424},
    {Device::governor, application, 12411}, {Device::governor, application, 12412}, {Device::governor, application, 12413},
    {Device::governor, application, 12414}, {Device::governor, application, 12415}, {Device::governor, application, 12419},
    {Device::governor, application, 12420}, {Device::governor, application, 12421}, {Device::governor, application, 12422},
    {Device::governor, application, 12423}, {Device::governor, application, 12424},
    {Device::governor, application, 3070}, {Device::governor, application, 3071}, {Device::governor, application, 3074},
    // 9.6
    {Device::governor, application, 3005},
};
// clang-format on

TEST(CatalogueErrors, every_error_of_the_manual_is_described_in_full) {
    for (const Printed& expected : printed) {
        SCOPED_TRACE(expected.number);
        const ErrorDescription* error = find_error(expected.device, expected.program, expected.number);
        ASSERT_NE(error, nullptr);
        EXPECT_FALSE(error->cause.empty());
        EXPECT_FALSE(error->response.empty());
        EXPECT_FALSE(error->action.empty());
        EXPECT_FALSE(error->clears.empty());
    }
}

TEST(CatalogueErrors, every_description_belongs_to_a_bit_or_code_of_the_catalogue) {
    const Catalogue catalogue{cgw::catalogue::shipped_rows()};
    const auto known = [&](const ErrorDescription& error, std::uint16_t number) {
        return std::any_of(std::begin(devices), std::end(devices), [&](Device device) {
            return catalogue.find(device, error.program, number) != nullptr;
        });
    };
    for (const ErrorDescription& error : shipped_errors()) {
        SCOPED_TRACE(std::to_string(error.number) + std::string(error.key));
        for (const Device device : devices) {
            if (error.number != 0 && error.shown_by(device)) {
                EXPECT_NE(catalogue.find(device, error.program, error.number), nullptr) << to_text(device);
            }
        }
        EXPECT_TRUE(error.counter == 0 || known(error, error.counter));
        for (const std::uint16_t number : error.with) {
            EXPECT_TRUE(known(error, number)) << number;
        }
        for (const std::uint16_t number : error.see) {
            EXPECT_TRUE(known(error, number)) << number;
            EXPECT_NE(find_error(Device::gateway, error.program, number), nullptr) << number;
        }
    }
}

TEST(CatalogueErrors, a_counter_stands_100_above_its_error) {  // GWM 9.2
    for (const ErrorDescription& error : shipped_errors()) {
        if (error.counter != 0) {
            EXPECT_EQ(error.counter, error.number + 100);
        }
    }
    const ErrorDescription* error = find_error(Device::gateway, application, 3172);
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->number, 3072);
}

TEST(CatalogueErrors, no_error_of_a_device_and_program_is_described_twice) {
    std::set<std::tuple<Device, Program, std::uint16_t, std::string_view>> seen;
    for (const ErrorDescription& error : shipped_errors()) {
        for (const Device device : devices) {
            if (error.shown_by(device)) {
                EXPECT_TRUE(seen.emplace(device, error.program, error.number,
                                         error.number != 0 ? std::string_view{} : error.key)
                                .second)
                    << error.number << error.key;
            }
        }
    }
}

TEST(CatalogueErrors, the_same_number_is_another_error_in_the_bootloader) {
    EXPECT_NE(find_error(Device::gateway, bootloader, 3076), find_error(Device::gateway, application, 3076));
    EXPECT_EQ(find_error(Device::governor, bootloader, 3076), nullptr);
    EXPECT_EQ(find_error(Device::gateway, application, 3005), nullptr);
    EXPECT_EQ(find_error(Device::gateway, application, 0), nullptr);
}

TEST(CatalogueErrors, errors_without_a_number_have_a_key) {  // GWM 9.6, 9.7, 9.3.1
    for (const char* key : {"sensor-error", "switch-error", "bootloader-silent", "Switch-Error"}) {
        EXPECT_NE(find_error(key), nullptr) << key;
    }
    EXPECT_EQ(find_error(""), nullptr);
    EXPECT_EQ(find_error("sensor"), nullptr);
    EXPECT_EQ(find_error("sensor-error")->cause.size(), 6U);
    EXPECT_EQ(find_error("switch-error")->cause.size(), 4U);
}

TEST(CatalogueErrors, texts_are_clauses_without_a_final_period) {
    for (const ErrorDescription& error : shipped_errors()) {
        for (const auto& list : {error.cause, error.response, error.action}) {
            for (const std::string_view text : list) {
                EXPECT_FALSE(text.ends_with('.')) << text;
            }
        }
        EXPECT_FALSE(error.clears.ends_with('.')) << error.clears;
        EXPECT_TRUE(error.section.starts_with("GWM 9") || error.section.starts_with("GWM ")) << error.section;
    }
}

}  // namespace
