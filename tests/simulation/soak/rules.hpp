// What must hold on a gateway whatever happens around it. The rules only hear what is told, from a running
// plant (inspector.hpp) or from a test that breaks each of them once (rules_test.cpp).
#pragma once

#include <array>
#include <bitset>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "canopen/protocol.hpp"
#include "device/gateway_errors.hpp"
#include "device/governor_link.hpp"
#include "frame/frame.hpp"
#include "image/image.hpp"
#include "simulation/alarms.hpp"

namespace cgw::simulation::soak {

using canopen::Time;
using device::GatewayState;

// What can be seen of a gateway after an event on its buses.
struct Look {
    Time now = 0;
    GatewayState state = GatewayState::undefined;
    std::uint8_t operational_entries = 0;
    std::uint32_t pdos_received = 0;
    std::uint16_t canopen_errors = 0;       // 2005h
    std::array<std::uint16_t, 7> binary{};  // 2000h:1..7, of TPDO1..3
    std::bitset<alarm_count> alarms;        // of the engine, by Alarm
    bool hides_states = false;  // events of both buses at this microsecond: a state may have passed unseen
};

// What is found after everything was mended and the plant has had its time.
struct Settled {
    Time now = 0;
    GatewayState state = GatewayState::operational;
    std::vector<std::uint16_t> errors;
    bool alarms = false;
    bool engine_runs = true;
    // By position: when the PLC received each TPDO last, and with what.
    struct Received {
        Time time = 0;
        std::uint16_t first_word = 0;
    };
    std::array<std::optional<Received>, facts::tpdo_count> tpdos;
    std::uint16_t engine_state = 0;
    // Words of the sensors: as the PLC sends them, and as the governor has them.
    std::vector<std::uint16_t> sent;
    std::vector<std::uint16_t> obeyed;
};

class Rules {
  public:
    // The image outlives the rules.
    explicit Rules(const image::Image& image);

    // The governor delivers: words that tell which main cycle they are of, in every analogue TPDO, and while
    // `errors_flicker` in 2000h:3 and 4 as well.
    void mark(device::GovernorData& data, bool errors_flicker);

    void look(const Look& look);
    // The gateway offers a frame to its port of CAN2, which takes it or not.
    struct Offered {
        Time now = 0;
        GatewayState state = GatewayState::undefined;
        bool hides_states = false;  // as in Look
    };
    void offer(const frame::Frame& frame, bool taken, const Offered& at);
    // A frame has been on CAN2.
    void carry(const frame::Frame& frame, Time now);
    // The governor is handed the words of a receive PDO.
    void forward(std::uint8_t rpdo, const device::PdoWords& words, Time now);
    void gateway_was_reset();
    void can2_was_cut();

    // Errors and alarms that have a cause now.
    // Those of 2005h bring the gateway's own of 2000h with them.
    void allow(const std::set<unsigned>& errors);
    void allow_alarms(const std::set<Alarm>& alarms);
    void allow_none();

    void settle(const Settled& settled);
    // Every TPDO that the port took has been on the bus, but for those lost on the wire by a cut: at most one
    // by each.
    bool all_carried() const;
    // What was lost until now is settled: the cuts so far excuse nothing that is lost later.
    void expect_all_carried(Time now);

    // "word-torn at 1234567 us: TPDO4 word 3"; empty while every rule holds. Not more than the first few.
    const std::vector<std::string>& broken() const { return broken_; }
    std::uint64_t pdos() const { return pdos_; }
    std::uint64_t forwarded() const { return forwarded_; }
    std::uint64_t refused() const { return refused_; }
    std::uint64_t boot_ups() const { return boot_ups_; }
    std::uint64_t alarms() const { return alarms_; }

    // How long what waits may go on waiting once the port takes frames again, and a boot-up after Init.
    static constexpr Time patience = 50'000;  // us
    // How long 2000h may differ from what TPDO1..3 said last. Without main cycles of its governor a gateway
    // sends nothing, and notices it after half a second.
    static constexpr Time binary_patience = 1'000'000;  // us
    static constexpr std::size_t error_pair = 2;  // 2000h:3 and 4, where no error of the gateway's own is

  private:
    using Words = device::PdoWords;

    void blame(std::string_view rule, Time now, const std::string& what);
    void follow(GatewayState state, Time now, bool hides_states);
    bool may_follow(GatewayState before, GatewayState after, Time now) const;
    void judge_answer(const frame::Frame& frame, GatewayState state, Time now);
    void judge_boot_up(const frame::Frame& frame, bool taken, Time now);
    void judge_heartbeat(const frame::Frame& frame, GatewayState state, Time now);
    void judge_words(std::size_t position, const frame::Frame& frame, Time now);
    void judge_error_words(const frame::Frame& frame, Time now);
    void judge_errors(const Look& look);
    bool may_show(unsigned error, const Look& look) const;
    void judge_waiting(Time now);
    void judge_binary(Time now);
    void judge_alarms(const Look& look);
    std::uint32_t sdo_answer() const;
    std::uint32_t life_sign() const;
    std::optional<std::size_t> tpdo_of(const frame::Frame& frame) const;

    const image::Image* image_;
    std::vector<std::string> broken_;
    std::set<unsigned> allowed_;
    std::bitset<alarm_count> alarms_allowed_;

    std::optional<GatewayState> state_;
    Look last_;
    std::uint16_t cycle_ = 0;
    std::optional<std::uint16_t> last_cycle_;  // that the gateway sent words of

    std::array<std::optional<frame::Frame>, facts::binary_tpdos> binary_;  // as the port took them last
    Time quiet_since_ = 0;  // nothing of 2000h has changed, and nothing was refused
    bool quiet_judged_ = false;

    std::map<std::uint32_t, Time> waiting_;  // refused by the port, by identifier
    Time last_refusal_ = 0;
    std::optional<canopen::NmtCommand> command_;  // to the gateway, the last one
    Time commanded_ = 0;
    std::optional<Time> boot_up_due_;  // since

    // TPDOs and cuts since expect_all_carried().
    std::uint64_t taken_ = 0;
    std::uint64_t carried_ = 0;
    std::uint64_t cuts_ = 0;
    std::uint64_t lost_ = 0;  // those that never came since the last cut, however idle the bus was
    std::optional<Time> last_life_sign_;
    std::uint64_t pdos_ = 0;
    std::uint64_t forwarded_ = 0;
    std::uint64_t refused_ = 0;
    std::uint64_t boot_ups_ = 0;
    std::uint64_t alarms_ = 0;

    // Receive PDOs on CAN2, by RPDO; the governor gets some of them, in their order.
    static constexpr std::size_t remembered = 4096;
    std::array<std::deque<Words>, facts::rpdo_count> carried_rpdos_;
};

}  // namespace cgw::simulation::soak
