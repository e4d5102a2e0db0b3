// A slave, node 5, with one transmit and one receive PDO (monitored, 50 ms), heartbeat 100 ms, watching node
// 9's heartbeat (200 ms).
#pragma once

#include <gtest/gtest.h>

#include "canopen/nmt.hpp"
#include "canopen/slave.hpp"
#include "canopen/table.hpp"
#include "support/recording_port.hpp"

namespace cgw::test {

class SlaveTest : public testing::Test {
  protected:
    SlaveTest() {
        canopen::Slave::Tables tables;
        tables.node_id = 5;
        tables.heartbeat_period = 100'000;
        tables.objects = table_.objects();
        tables.values = table_.values;
        tables.transmit = std::span(rows_).first(1);
        tables.transmit_states = states_;
        tables.receive = std::span(rows_).last(1);
        tables.receive_monitors = monitors_;
        tables.partner_node = 9;
        tables.partner_period = 200'000;
        slave_.configure(tables);
    }

    void boot_up(canopen::Time now = 0) {
        slave_.boot_up();
        slave_.poll(now);
        port_.take();
    }
    canopen::Slave::Event::Kind command(canopen::NmtCommand nmt, std::uint8_t node = 5) {
        return slave_.receive(canopen::nmt_frame(nmt, node), now_).kind;
    }
    std::vector<frame::Frame> upload() {
        slave_.receive(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}), now_);
        return port_.take();
    }

    Table table_ = sample_table();
    std::array<canopen::MappedValue, 1> mapping_{{{0, 4, false}}};
    std::array<canopen::PdoRow, 2> rows_{{{0x185, 4, mapping_}, {0x205, 4, mapping_}}};
    std::array<canopen::TransmitState, 1> states_{};
    std::array<canopen::ArrivalMonitor, 1> monitors_{canopen::ArrivalMonitor{50'000}};
    RecordingPort port_;
    canopen::Time now_ = 0;
    canopen::Slave slave_{port_};
};

}  // namespace cgw::test
