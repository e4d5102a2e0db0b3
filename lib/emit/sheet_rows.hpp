// Inside the emit room: the entry sheet before it takes a form.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "emit/concerned.hpp"
#include "emit/emitter.hpp"
#include "parameter/row.hpp"

namespace cgw::emit {

struct SheetRow {
    const parameter::Row* row = nullptr;
    std::string value;  // as DcDesk shows it: "1.5", "282" with the unit Hex
    std::string unit;
    std::string default_value;  // "0"; "-" where 0 is out of range and somebody must choose
    bool differs = false;       // from 0
};

struct DeviceSheet {
    parameter::Device device = parameter::Device::governor;
    std::vector<SheetRow> rows;  // ascending by number
};

struct EntrySheet {
    std::string title;
    std::string configuration_id;
    std::uint8_t node_id = 0;
    std::string main_cycle;  // what to say of the governor's, "" for the usual one
    std::uint32_t main_cycle_us = 0;
    std::array<DeviceSheet, 2> devices;  // governor, gateway
};

// Every number that is assigned, and those not mentioned that decide what the Gateway does: they must be 0 in
// the device, whatever it held before. Bit-timing registers belong to them only with manual timing, and bit
// rates only without. Refers to the plant, which must outlive it.
EntrySheet entry_sheet(const Plant& plant);

// What is to be done after typing, in order (GWM 7).
extern const std::array<std::string_view, 4> closing_steps;

extern const std::string_view switches_remark;

extern const std::string_view tables_remark;  // which of the two tables to type
extern const std::string_view defaults_remark;

std::string heading_of(const EntrySheet& sheet);            // "Entry sheet: Genset 2"
std::string_view device_heading(parameter::Device device);  // "Governor"

std::string render_sheet_html(const EntrySheet& sheet);

}  // namespace cgw::emit
