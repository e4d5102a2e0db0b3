// A serial CAN adapter that speaks slcan, on a serial port such as /dev/ttyACM0. It begins unconnected;
// service() sets the adapter up, and the listener hears link_changed(up) when its channel is open.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.hpp"
#include "media/channel.hpp"
#include "media/descriptor.hpp"
#include "media/retry.hpp"
#include "media/slcan_line.hpp"

namespace cgw::media {

// Fails when the bit rate is none of the nine that slcan has, and when `tty` cannot be opened or is no serial
// port.
base::Result<std::unique_ptr<Channel>> open_slcan(const std::string& tty, unsigned kbit);

// Down are an adapter that is unplugged and one that refuses bit rate or opening; it is tried again until it
// works. Adapters that answer nothing are taken to obey. One that refuses a frame of ours has lost it, which
// is told as link_changed(up) with the reason, once a second at most. The serial speed is 115,200 baud, which
// USB adapters do not care about.
class SlcanChannel final : public Channel {
  public:
    SlcanChannel(std::string tty, unsigned kbit, Descriptor port);
    ~SlcanChannel() override;

    bool send(const frame::Frame& frame) override;
    int descriptor() const override { return port_.get(); }
    short events() const override;
    void service(Time now, ChannelListener& listener) override;
    Time deadline() const override;
    std::optional<std::uint32_t> bit_rate() const override { return kbit_ * 1000; }

  private:
    // What the adapter was told last, or was not yet.
    enum class Step : std::uint8_t { nothing, close, bit_rate, open, working };

    void connect(ChannelListener& listener);
    void go_to(Step step, ChannelListener& listener);
    void write(std::string_view text);
    void write_rest();
    void read(ChannelListener& listener);
    void take(const SlcanEvent& event, ChannelListener& listener);
    void take_answer(SlcanAnswer answer, ChannelListener& listener);
    void lose(ChannelListener& listener);
    void tell(LinkState state, const std::string& reason, ChannelListener& listener);

    std::string tty_;
    unsigned kbit_;
    Descriptor port_;
    Retry retry_;
    SlcanReader reader_;
    Step step_ = Step::nothing;
    Time now_ = 0;           // of the latest service()
    Time step_ends_ = 0;     // when the adapter has had its time to answer
    Time next_refusal_ = 0;  // when a refused frame is worth a line again
    std::string unwritten_;  // what the port had no room for
    std::string fault_;      // why the port is of no more use; empty: it is
    std::string told_;       // what was said last while the link is down
};

}  // namespace cgw::media
