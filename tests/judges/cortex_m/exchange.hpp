// A recorded exchange with a gateway, and the gateway that takes part in it, in the same lines of code on
// this machine and on the microcontroller. An exchange is a row of calls; every call holds what comes in, and
// the port's answers ("taken" or "not now") to what the gateway sends meanwhile. What the gateway does about
// a call is put into a Sink, byte for byte the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "device/gateway.hpp"
#include "link/gateway_end.hpp"
#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"

namespace cgw::exchange {

using canopen::Time;

enum class Call : std::uint8_t {
    open,  // boot number: a reset of gateway and link
    can1,  // a frame for the governor link
    can2,  // a frame for the gateway
    poll_can1,
    poll_can2,
    report,   // fault, present
    clear,    // "clear errors"
    restore,  // first sentinel
    end,
};

// One call as it is stored: kind, time in microseconds (u64), a frame (14 bytes) or two bytes, the number of
// port answers and as many bits.
struct Record {
    Call call = Call::end;
    Time time = 0;
    frame::Frame frame;
    std::uint8_t first = 0;   // boot number, fault, sentinel
    std::uint8_t second = 0;  // present
    std::uint8_t answers = 0;
    std::array<std::uint8_t, 32> taken{};  // a bit per answer
};

class Sink {
  public:
    virtual void put(std::span<const std::uint8_t> bytes) = 0;

  protected:
    ~Sink() = default;
};

template <std::size_t size>
class Line {
  public:
    void u8(unsigned value) { bytes_[used_++] = static_cast<std::uint8_t>(value); }
    void u16(unsigned value) {
        u8(value & 0xFFU);
        u8((value >> 8U) & 0xFFU);
    }
    void u32(std::uint32_t value) {
        u16(value & 0xFFFFU);
        u16(value >> 16U);
    }
    void u64(std::uint64_t value) {
        u32(static_cast<std::uint32_t>(value));
        u32(static_cast<std::uint32_t>(value >> 32U));
    }
    void frame(const frame::Frame& frame) {
        u32(frame.id);
        u8(frame.length);
        u8((frame.extended ? 1U : 0U) | (frame.remote ? 2U : 0U));
        for (const std::uint8_t byte : frame.data) {
            u8(byte);
        }
    }
    std::span<const std::uint8_t> bytes() const { return {bytes_.data(), used_}; }

  private:
    std::array<std::uint8_t, size> bytes_{};
    std::size_t used_ = 0;
};

// The gateway with everything around it heard.
class Bench {
  public:
    Bench(const image::Image& image, frame::FramePort& can1, frame::FramePort& can2, Sink& sink)
        : image_(&image),
          sink_(&sink),
          can1_(*this, can1, 1),
          can2_(*this, can2, 2),
          ear_(*this),
          link_(can1_),
          gateway_(can2_, ear_) {
        link_.connect(gateway_);
    }

    // Returns what a poll returns, never for the other calls.
    Time perform(const Record& record) {
        const Time deadline = call(record);
        Line<16> line;
        line.u8(unsigned{'='});
        line.u8(static_cast<unsigned>(record.call));
        line.u64(deadline);
        line.u8(static_cast<unsigned>(gateway_.state()));
        line.u8((gateway_.pending() ? 1U : 0U) | (link_.pending() ? 2U : 0U));
        line.u16(gateway_.errors().canopen_errors());
        sink_->put(line.bytes());
        if (++calls_ % calls_per_look == 0) {
            look_inside();
        }
        return deadline;
    }

  private:
    static constexpr unsigned calls_per_look = 64;

    // Hands on what is sent, and tells of it.
    struct Tap final : frame::FramePort {
        Tap(Bench& bench, frame::FramePort& port, unsigned number)
            : bench_(bench), port_(port), number_(number) {}
        bool send(const frame::Frame& frame) override {
            const bool taken = port_.send(frame);
            Line<20> line;
            line.u8(unsigned{'>'});
            line.u8(number_);
            line.u8(taken ? 1 : 0);
            line.frame(frame);
            bench_.sink_->put(line.bytes());
            return taken;
        }
        Bench& bench_;
        frame::FramePort& port_;
        unsigned number_;
    };

    // What the governor is told.
    struct Ear final : device::GovernorLink {
        explicit Ear(Bench& bench) : bench_(bench) {}
        void status_changed(const device::GatewayStatus& status) override {
            Line<24> line;
            line.u8(unsigned{'S'});
            line.u8(static_cast<unsigned>(status.state));
            line.u16(status.canopen_errors);
            for (const std::uint16_t word : status.errors) {
                line.u16(word);
            }
            line.u8(status.late_rpdos);
            line.u8(status.heartbeat_lost ? 1 : 0);
            bench_.sink_->put(line.bytes());
            bench_.link_.status_changed(status);
        }
        void process_data(std::uint8_t rpdo, const device::PdoWords& words) override {
            Line<16> line;
            line.u8(unsigned{'P'});
            line.u8(rpdo);
            for (const std::uint16_t word : words) {
                line.u16(word);
            }
            bench_.sink_->put(line.bytes());
            bench_.link_.process_data(rpdo, words);
        }
        Bench& bench_;
    };

    Time call(const Record& record) {
        switch (record.call) {
            case Call::open:
                link_.open(*image_, record.first);
                return static_cast<Time>(gateway_.open(*image_, record.time));
            case Call::can1:
                link_.receive(record.frame, record.time);
                break;
            case Call::can2:
                gateway_.receive(record.frame, record.time);
                break;
            case Call::poll_can1:
                return link_.poll(record.time);
            case Call::poll_can2:
                return gateway_.poll(record.time);
            case Call::report:
                gateway_.report(static_cast<device::Fault>(record.first), record.second != 0, record.time);
                break;
            case Call::clear:
                gateway_.clear_errors(record.time);
                break;
            case Call::restore: {
                std::array<std::uint8_t, device::GatewayErrors::error_count> sentinels{};
                sentinels.fill(record.first);
                gateway_.restore(sentinels);
                break;
            }
            case Call::end:
                break;
        }
        return canopen::never;
    }

    // Values, sentinels and counters.
    void look_inside() {
        Line<64> line;
        line.u8(unsigned{'?'});
        line.u32(wire::crc32(gateway_.values()));
        line.u32(wire::crc32(gateway_.errors().sentinels()));
        const canopen::Slave& slave = gateway_.slave();
        for (const std::uint32_t counter :
             {slave.sdo().counters().answers, slave.sdo().counters().aborts, slave.sdo().counters().overflows,
              slave.transmitter().counters().sent, slave.transmitter().counters().deferred,
              slave.transmitter().counters().superseded, slave.receiver().counters().received,
              slave.receiver().counters().too_short}) {
            line.u32(counter);
        }
        sink_->put(line.bytes());
    }

    const image::Image* image_;
    Sink* sink_;
    Tap can1_;
    Tap can2_;
    Ear ear_;
    link::GatewayEnd link_;
    device::Gateway gateway_;
    unsigned calls_ = 0;
};

}  // namespace cgw::exchange
