// The gateway takes no memory after start: every way to the heap is counted while it works.
#include <cstdlib>
#include <new>

#include "device/gateway_test.hpp"

namespace {

// Plain numbers, so that counting itself allocates nothing.
bool counting = false;
std::size_t allocations = 0;

void* counted(std::size_t size) {
    allocations += counting ? 1 : 0;
    void* const memory = std::malloc(size);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace cgw::device {
namespace {

struct CountingPort final : frame::FramePort {
    bool send(const frame::Frame& frame) override {
        const bool taken = ++offered % 7 != 0;  // a port that is full now and then
        sent += taken ? 1 : 0;
        checksum += frame.id + frame.data[0];
        return taken;
    }
    std::size_t offered = 0;
    std::size_t sent = 0;
    std::size_t checksum = 0;
};

struct CountingLink final : GovernorLink {
    void status_changed(const GatewayStatus&) override { ++states; }
    void process_data(std::uint8_t, const PdoWords&) override { ++received; }
    std::size_t states = 0;
    std::size_t received = 0;
};

// One main cycle of a busy plant: data, process data in, SDO requests good and bad, now and then a reset.
void work(Gateway& gateway, GovernorData& data, std::uint32_t number) {
    const canopen::Time now = canopen::Time{number} * 15'625;
    data.errors[number % 6] = static_cast<std::uint16_t>(number);
    data.analogue[0][number % 4] = static_cast<std::uint16_t>(number * 7);
    gateway.main_cycle(data, now);
    frame::Frame rpdo;
    rpdo.id = 0x205 + 0x100 * (number % 3);
    rpdo.length = 8;
    gateway.receive(rpdo, now);
    const auto index = static_cast<std::uint16_t>(0x2000 + number % 8);
    gateway.receive(canopen::sdo::make_frame(0x605, number % 2 == 0 ? 0x40 : 0x2B, {index, 1}, 5), now);
    gateway.poll(now + 5000);
    if (number % 1000 == 999) {
        gateway.receive(canopen::nmt_frame(canopen::NmtCommand::reset_node, 5), now);
        gateway.command(GovernorCommand::init, now);
        gateway.command(GovernorCommand::pre_operational, now);
        gateway.receive(canopen::nmt_frame(canopen::NmtCommand::start, 5), now);
    }
}

TEST(GatewayHeap, takes_no_memory_from_start_on) {
    const test::SamplePlant plant;
    const base::Bytes bytes = plant.image();
    CountingPort port;
    CountingLink link;
    Gateway gateway(port, link);
    GovernorData data;

    counting = true;
    image::Image image;
    const bool opened =
        image::Image::open(bytes, image) == image::Status::ok && gateway.open(image, 0) == OpenStatus::ok;
    gateway.command(GovernorCommand::init, 0);
    gateway.command(GovernorCommand::pre_operational, 0);
    gateway.receive(canopen::nmt_frame(canopen::NmtCommand::start, 5), 0);
    for (std::uint32_t number = 1; number <= 20'000; ++number) {
        work(gateway, data, number);
    }
    counting = false;

    EXPECT_TRUE(opened);
    EXPECT_EQ(allocations, 0U);
    EXPECT_GT(port.sent, 40'000U);
    EXPECT_GT(link.received, 10'000U);
}

TEST(GatewayHeap, is_watched_by_a_counter_that_counts) {
    counting = true;
    std::vector<int>* const taken = new std::vector<int>(100);
    counting = false;
    EXPECT_GE(allocations, 2U);
    delete taken;
    allocations = 0;
}

}  // namespace
}  // namespace cgw::device
