// What cgw assumes where the documents do not settle it; docs/assumptions.md and `cgw list assumptions` are
// made from these rows. Every ruling that says **Inference** has at least one.
#include "explain/lists.hpp"

namespace cgw::explain {

namespace {

struct Assumption {
    std::string_view ruling;
    std::string_view assumed;
    std::string_view measure;   // what to do on a device
    std::string_view lives_in;  // the room of lib/ or the directory in which one change corrects it
};

constexpr Assumption assumptions[] = {
    {"D13", "2330 and 2917 are unsigned 16-bit, 0..65535", "1A03h: is it 2001h or 2002h? raw end value",
     "schemas/parameters"},
    {"D17", "ranges of the governor's parameters", "what DcDesk 2000 accepts",
     "schemas/parameters, catalogue"},
    {"D19", "8nn and 9nn take any 16-bit value unless the type is 3", "what DcDesk 2000 accepts",
     "catalogue"},
    {"D21", "error bit b is error 3000 + b", "provoke a known error, read 2000h:1..6", "facts"},
    {"D22", "engine state is the low byte of 2000h:7", "read 2000h:7, engine stopped and running",
     "device, catalogue"},
    {"D24", "2001h and 2002h filled densely in TPDO order", "1A03h..1A0Fh of a mixed configuration",
     "config"},
    {"D24", "8-bit parameters widened by their sign", "transmit a negative 8-bit value", "simulation"},
    {"D26", "2004h:0 is the highest channel; gaps exist", "one sensor on channel 7: 2004h:0, 2004h:1",
     "config, profile"},
    {"D27", "type 3 with bit or channel 0 activates nothing", "1400h:1 and 1401h:1, bit 31", "config"},
    {"D32", "1018h:3 is 3842; 1018h:4 is 3844 and 3845", "read 1018h:3, 1018h:4", "profile"},
    {"D37", "five behaviours around initialisation", "see the table in D37", "canopen, device"},
    {"D38", "a sensor 9nn has the scaling of measurement 29nn",
     "send half of the range, read the measurement in DcDesk", "facts"},
    {"D44", "monitoring recovers with two telegrams in time",
     "let RPDO2 fail, send one, then two; 2005h bit 2", "canopen"},
    {"D45", "seven reactions to errors", "see the table in D45", "device"},
    {"D46", "a governor is silent after 500 ms", "cut its supply, record the heartbeats", "device"},
    {"D47", "what four measurements of both buses show", "see the table in D47", "runtime"},
    {"D53", "what is sent on entering Operational", "record the bus around NMT 01h", "device"},
    {"D54", "heartbeat monitoring starts with Operational", "silent partner: when 2005h bit 9 appears",
     "device"},
    {"D55", "RPDO monitoring starts with Operational; leaving it clears 12413 and 12420",
     "no RPDO: when 2005h bit 2 comes and goes", "device"},
    {"D58", "eight small behaviours", "see the table in D58", "canopen, device"},
    {"D61", "NAT: sensor error bits in bytes 4 and 5 of RPDO1", "send one bit, read 2001h", "later version"},
    {"D65", "NAT: hysteresis in percent of full scale", "move one value slowly, record", "later version"},
    {"D68", "NAT: 2100h..210Fh are objects of words per TPDO", "read 2100h:0, 2100h:1", "later version"},
};

}  // namespace

Table assumption_list() {
    Table table{"assumptions", false, {}, {}};
    table.columns = {
        {"ruling", "ruling"},
        {"assumed", "we assume"},
        {"measure", "measure"},
        {"lives_in", "lives in", in_page | in_data},
    };
    for (const Assumption& row : assumptions) {
        table.rows.push_back({std::string(row.ruling), std::string(row.assumed), std::string(row.measure),
                              std::string(row.lives_in)});
    }
    return table;
}

}  // namespace cgw::explain
