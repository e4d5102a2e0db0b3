// Records an exchange with a gateway on this machine: a simulated governor on CAN1, and on CAN2 everything a
// gateway may meet, from a well-behaved master to noise.
//   cortex_m_record IMAGE EXCHANGE ANSWERS
#include <cstdio>
#include <deque>
#include <random>
#include <string>

#include "base/files.hpp"
#include "canopen/nmt.hpp"
#include "canopen/sdo.hpp"
#include "exchange.hpp"
#include "simulation/governor.hpp"

namespace cgw::exchange {
namespace {

using canopen::NmtCommand;
using simulation::Bus;

constexpr Time millisecond = 1'000;
constexpr Time second = 1'000'000;
// Time passes the end of 32 bits of microseconds in the middle of the exchange.
constexpr Time epoch = (Time{1} << 32U) - 4 * second;
constexpr std::size_t room = 4;  // frames in the transmit queue of the gateway's CAN2
constexpr unsigned seed = 2004;

class Collected final : public Sink {
  public:
    void put(std::span<const std::uint8_t> part) override {
        bytes.insert(bytes.end(), part.begin(), part.end());
    }
    base::Bytes bytes;
};

void store(const Record& record, Sink& sink) {
    Line<64> line;
    line.u8(static_cast<unsigned>(record.call));
    line.u64(record.time);
    line.frame(record.frame);
    line.u8(record.first);
    line.u8(record.second);
    line.u8(record.answers);
    for (unsigned i = 0; i < record.answers; i += 8) {
        line.u8(record.taken[i / 8]);
    }
    sink.put(line.bytes());
}

// The gateway's place on both buses. Every call is recorded when it is over, with the answers of its ports.
class Node final : public simulation::Participant {
  public:
    Node(const image::Image& image, Bus& can1, Bus& can2)
        : link_side_(*this),
          port1_(*this, can1.attach(link_side_)),
          port2_(*this, can2.attach(*this, room)),
          bench_(image, port1_, port2_, answers) {}

    Time perform(Call call, Time now, const frame::Frame& frame = {}, std::uint8_t first = 0,
                 std::uint8_t further = 0) {
        record_ = {};
        record_.call = call;
        record_.time = epoch + now;
        record_.frame = frame;
        record_.first = first;
        record_.second = further;
        const Time deadline = bench_.perform(record_);
        store(record_, calls);
        ++count;
        return deadline;
    }
    Time poll(Time now) override { return relative(perform(Call::poll_can2, now)); }
    void receive(const frame::Frame& frame, Time now) override { perform(Call::can2, now, frame); }

    // While set, the gateway's CAN2 takes only some of the frames.
    bool reluctant = false;
    Collected calls;
    Collected answers;
    std::size_t count = 0;

  private:
    static Time relative(Time deadline) { return deadline == canopen::never ? deadline : deadline - epoch; }

    struct LinkSide final : simulation::Participant {
        explicit LinkSide(Node& of) : node(of) {}
        Time poll(Time now) override { return relative(node.perform(Call::poll_can1, now)); }
        void receive(const frame::Frame& frame, Time now) override { node.perform(Call::can1, now, frame); }
        Node& node;
    };
    struct Port final : frame::FramePort {
        Port(Node& of, frame::FramePort& to) : node(of), bus(to) {}
        bool send(const frame::Frame& frame) override {
            const bool in_the_mood = !node.reluctant || node.mood_() % 3 == 0;
            const bool taken = in_the_mood && bus.send(frame);
            Record& record = node.record_;
            if (taken) {
                record.taken[record.answers / 8] |= static_cast<std::uint8_t>(1U << (record.answers % 8));
            }
            ++record.answers;
            return taken;
        }
        Node& node;
        frame::FramePort& bus;
    };

    std::mt19937 mood_{seed};
    Record record_;
    LinkSide link_side_;
    Port port1_;
    Port port2_;
    Bench bench_;
};

// Everybody else on CAN2: sends what it was told to at the time it was told.
class Others final : public simulation::Participant {
  public:
    explicit Others(Bus& bus) : bus_(bus), port_(bus.attach(*this, 64)) {}
    Time poll(Time now) override {
        while (!waiting_.empty() && waiting_.front().first <= now && port_.send(waiting_.front().second)) {
            waiting_.pop_front();
        }
        return waiting_.empty() ? canopen::never : std::max(waiting_.front().first, now + 1);
    }
    // In the order of time; `pause` after the frame before.
    void say(const frame::Frame& frame, Time pause) {
        last_ = std::max(last_, bus_.now()) + pause;
        waiting_.emplace_back(last_, frame);
    }
    Time quiet() const { return last_; }

  private:
    Bus& bus_;
    frame::FramePort& port_;
    std::deque<std::pair<Time, frame::Frame>> waiting_;
    Time last_ = 0;
};

class Recording {
  public:
    explicit Recording(const image::Image& image)
        : image_(image),
          node_id_(image.can2().own_node),
          can1_(image.can1().bit_rate_kbit),
          can2_(image.can2().bit_rate_kbit),
          governor_(can1_, image),
          node_(image, can1_, can2_),
          others_(can2_) {}

    Node& run() {
        reset();
        pass(3 * second);  // start-up, Init, Pre-Operational
        read_dictionary();
        refused_requests();
        nmt(NmtCommand::start);
        process_data(300 * millisecond);
        pass(2 * second);  // late RPDOs, lost heartbeat
        process_data(300 * millisecond);
        reluctant_port();
        stop_and_resets();
        faults();
        noise();
        reset();  // the governor notices: 12419
        pass(2 * second);
        nmt(NmtCommand::start);
        pass(100 * millisecond);
        governor_.reset();  // 12411
        pass(second);
        node_.perform(Call::end, can2_.now());
        return node_;
    }

  private:
    void pass(Time time) {
        Bus* const buses[] = {&can1_, &can2_};
        Bus::run_until(buses, std::max(can2_.now(), others_.quiet()) + time);
    }
    void say(std::uint32_t id, std::initializer_list<unsigned> data, Time pause = millisecond) {
        frame::Frame frame;
        frame.id = id;
        for (const unsigned byte : data) {
            frame.data[frame.length++] = static_cast<std::uint8_t>(byte);
        }
        others_.say(frame, pause);
    }
    void nmt(NmtCommand command) { others_.say(canopen::nmt_frame(command, node_id_), millisecond); }
    void sdo(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index, std::uint32_t value = 0) {
        others_.say(canopen::sdo::make_frame(0x600U + node_id_, command, {index, sub_index}, value),
                    millisecond);
    }
    void tell(Call call, std::uint8_t first = 0, std::uint8_t further = 0) {
        node_.perform(call, can2_.now(), {}, first, further);
    }
    void reset() {
        tell(Call::open, ++boot_);
        tell(Call::restore, 250);
    }

    void read_dictionary() {
        const object::ObjectTable objects = image_.objects();
        for (std::size_t i = 0; i < objects.size(); ++i) {
            sdo(0x40, objects.entry(i).index, objects.entry(i).sub_index);
        }
        pass(50 * millisecond);
    }
    void refused_requests() {
        const object::ObjectTable objects = image_.objects();
        constexpr std::uint8_t commands[] = {0x2F, 0x2B, 0x27, 0x23, 0x22, 0x21, 0x60, 0xA0, 0x41, 0x80};
        for (std::size_t i = 0; i < objects.size(); ++i) {
            const object::ObjectEntry entry = objects.entry(i);
            sdo(commands[i % std::size(commands)], entry.index, entry.sub_index, 0x01020304);
        }
        for (unsigned index = 0x1000; index < 0x2010; index += 3) {
            sdo(0x40, static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(index % 9));
        }
        say(0x600U + node_id_, {0x40, 0, 0x10}, millisecond);
        for (unsigned i = 0; i < 12; ++i) {  // more at once than answers can wait
            others_.say(canopen::sdo::make_frame(0x600U + node_id_, 0x40, {0x2000, 1}, 0), 0);
        }
        pass(50 * millisecond);
    }
    // RPDO1 to 4 and the partner's heartbeat, in their rhythm.
    void process_data(Time duration) {
        const Time end = std::max(can2_.now(), others_.quiet()) + duration;
        const std::uint8_t partner = image_.heartbeat().consumer_node;
        while (others_.quiet() < end) {
            for (std::size_t row = facts::tpdo_count; row < facts::tpdo_count + facts::rpdo_count; ++row) {
                others_.say(random_frame(image_.pdo(row).cob_id, 8), 2 * millisecond);
            }
            say(0x700U + partner, {0x05}, 2 * millisecond);
        }
        pass(20 * millisecond);
    }
    void reluctant_port() {
        nmt(NmtCommand::start);
        pass(50 * millisecond);
        node_.reluctant = true;
        read_dictionary();
        process_data(300 * millisecond);
        node_.reluctant = false;
        for (unsigned i = 0; i < 400; ++i) {  // a bus without room for the gateway
            say(0x001, {0, 0, 0, 0, 0, 0, 0, 0}, 0);
        }
        pass(100 * millisecond);
    }
    void stop_and_resets() {
        nmt(NmtCommand::stop);
        sdo(0x40, 0x1000, 0);
        say(image_.pdo(facts::tpdo_count).cob_id, {1, 2, 3, 4, 5, 6, 7, 8});
        pass(second);
        nmt(NmtCommand::enter_pre_operational);
        pass(100 * millisecond);
        nmt(NmtCommand::reset_node);
        pass(second);
        nmt(NmtCommand::start);
        pass(100 * millisecond);
        nmt(NmtCommand::reset_communication);
        pass(second);
        for (const unsigned command : {1U, 2U, 1U, 0x80U, 1U, 0x77U, 0x81U, 1U}) {  // one after the other
            say(0x000, {command, 0}, 0);
        }
        pass(second);
    }
    void faults() {
        for (const device::FaultRow& row : device::fault_rows()) {
            if (row.clearing == device::Clearing::by_reset) {
                continue;
            }
            nmt(NmtCommand::start);
            pass(50 * millisecond);
            tell(Call::report, static_cast<std::uint8_t>(row.fault), 1);
            pass(600 * millisecond);  // 3072: announcements every 500 ms
            tell(Call::report, static_cast<std::uint8_t>(row.fault), 0);
            pass(100 * millisecond);
            tell(Call::clear);
            governor_.clear_errors();
            pass(500 * millisecond);
        }
    }
    void noise() {
        nmt(NmtCommand::start);
        for (unsigned i = 0; i < 4000; ++i) {
            const unsigned kind = random() % 8;
            const std::uint32_t ids[] = {0x000,
                                         0x600U + node_id_,
                                         0x600U + node_id_,
                                         image_.pdo(facts::tpdo_count + kind % 4).cob_id,
                                         0x700U + image_.heartbeat().consumer_node,
                                         static_cast<std::uint32_t>(random() % 0x800)};
            frame::Frame frame = random_frame(ids[random() % std::size(ids)], random() % 9);
            frame.extended = random() % 16 == 0;
            frame.remote = random() % 16 == 0;
            if (frame.id == 0 && random() % 4 != 0) {  // a command, mostly for us
                constexpr std::uint8_t commands[] = {1, 1, 1, 1, 2, 0x80, 0x81, 0x82};
                frame.data[0] = commands[random() % std::size(commands)];
                frame.data[1] = random() % 3 == 0 ? std::uint8_t{0} : node_id_;
            }
            others_.say(frame, random() % 3 * 200);
        }
        pass(second);
    }
    frame::Frame random_frame(std::uint32_t id, unsigned length) {
        frame::Frame frame;
        frame.id = id;
        frame.length = static_cast<std::uint8_t>(length);
        for (unsigned i = 0; i < length; ++i) {
            frame.data[i] = static_cast<std::uint8_t>(random());
        }
        return frame;
    }

    unsigned random() { return static_cast<unsigned>(generator_()); }

    const image::Image& image_;
    std::uint8_t node_id_;
    Bus can1_;
    Bus can2_;
    simulation::SimulatedGovernor governor_;
    Node node_;
    Others others_;
    std::mt19937 generator_{seed};
    std::uint8_t boot_ = 0;
};

int record(const char* image_path, const char* exchange_path, const char* answers_path) {
    const base::Result<std::string> file = base::read_file(image_path, 1U << 20U);
    const base::Bytes bytes = base::to_bytes(file.value_or(""));
    image::Image image;
    if (image::Image::open(bytes, image) != image::Status::ok) {
        std::fprintf(stderr, "%s is no image\n", image_path);
        return 1;
    }
    Recording recording(image);
    const Node& node = recording.run();
    if (!base::write_file(exchange_path, node.calls.bytes) ||
        !base::write_file(answers_path, node.answers.bytes)) {
        std::fprintf(stderr, "cannot write\n");
        return 1;
    }
    std::printf("%zu calls\n", node.count);
    return 0;
}

}  // namespace
}  // namespace cgw::exchange

int main(int argc, char** argv) {
    return argc == 4 ? cgw::exchange::record(argv[1], argv[2], argv[3]) : 2;
}
