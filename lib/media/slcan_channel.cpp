#include "media/slcan_channel.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace cgw::media {
namespace {

constexpr Time time_to_fall_silent = 100'000;
constexpr Time time_to_answer = 300'000;
constexpr Time refusal_interval = 1'000'000;
constexpr std::size_t bytes_per_service = 16'384;  // a flooded bus leaves time for the others

// Ends whatever line the adapter believes to be in, then closes its channel, in which alone it can be set up.
constexpr std::string_view close_command = "\r\r\rC\r";
constexpr std::string_view open_command = "O\r";

std::string open_fault(int error) {
    switch (error) {
        case ENOENT:
        case ENXIO:
        case ENODEV:
            return "there is no such serial port";
        case EACCES:
            return "no permission to open it; members of the group dialout may";
        case EBUSY:
            return "another program uses it";
        case ENOTTY:
            return "it is no serial port";
        default:
            return std::strerror(error);
    }
}

// Characters as they are, no echo, no flow control, no modem lines; read() gives 0 only when the port is
// gone.
bool make_raw(int port) {
    termios settings{};
    if (::tcgetattr(port, &settings) != 0) {
        return false;
    }
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    ::cfsetspeed(&settings, B115200);
    return ::tcsetattr(port, TCSANOW, &settings) == 0 && ::tcflush(port, TCIOFLUSH) == 0;
}

// None, with the reason in errno, when that cannot be.
Descriptor open_port(const std::string& tty) {
    Descriptor port(::open(tty.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (port && (!make_raw(port.get()) || ::ioctl(port.get(), TIOCEXCL) != 0)) {
        const int error = errno;
        port.close();
        errno = error;
    }
    return port;
}

}  // namespace

base::Result<std::unique_ptr<Channel>> open_slcan(const std::string& tty, unsigned kbit) {
    if (!slcan_bit_rate_command(kbit)) {
        return base::failure(fmt::format(
            "{}: slcan has no {} kbit/s; it has 10, 20, 50, 100, 125, 250, 500, 800, 1000", tty, kbit));
    }
    Descriptor port = open_port(tty);
    if (!port) {
        return base::failure(fmt::format("{}: {}", tty, open_fault(errno)));
    }
    return std::make_unique<SlcanChannel>(tty, kbit, std::move(port));
}

SlcanChannel::SlcanChannel(std::string tty, unsigned kbit, Descriptor port)
    : tty_(std::move(tty)), kbit_(kbit), port_(std::move(port)) {}

SlcanChannel::~SlcanChannel() {
    if (port_) {
        write("C\r");
        ::ioctl(port_.get(), TIOCNXCL);
    }
}

bool SlcanChannel::send(const frame::Frame& frame) {
    if (step_ != Step::working || !fault_.empty() || !unwritten_.empty()) {
        return false;
    }
    write(slcan_line(frame));
    return fault_.empty();
}

short SlcanChannel::events() const {
    return unwritten_.empty() ? POLLIN : POLLIN | POLLOUT;
}

Time SlcanChannel::deadline() const {
    if (!port_ || step_ == Step::nothing) {
        return retry_.due();
    }
    if (!fault_.empty()) {
        return now_;
    }
    return step_ == Step::working ? never : step_ends_;
}

void SlcanChannel::service(Time now, ChannelListener& listener) {
    now_ = now;
    if (step_ == Step::nothing) {
        if (now < retry_.due()) {
            return;
        }
        connect(listener);
    }
    if (!port_) {
        return;
    }
    write_rest();
    read(listener);
    if (fault_.empty() && step_ != Step::working && now >= step_ends_) {
        go_to(static_cast<Step>(static_cast<int>(step_) + 1), listener);
    }
    if (!fault_.empty()) {
        lose(listener);
    }
}

void SlcanChannel::connect(ChannelListener& listener) {
    if (!port_) {
        port_ = open_port(tty_);
    }
    if (!port_) {
        const std::string reason = open_fault(errno);
        retry_.failed(now_);
        if (reason != told_) {
            told_ = reason;
            tell(LinkState::down, reason, listener);
        }
        return;
    }
    fault_.clear();
    unwritten_.clear();
    reader_.clear();
    go_to(Step::close, listener);
}

void SlcanChannel::go_to(Step step, ChannelListener& listener) {
    step_ = step;
    step_ends_ = now_ + (step == Step::close ? time_to_fall_silent : time_to_answer);
    switch (step) {
        case Step::nothing:
            break;
        case Step::close:
            write(close_command);
            break;
        case Step::bit_rate:
            write(fmt::format("{}\r", *slcan_bit_rate_command(kbit_)));
            break;
        case Step::open:
            write(open_command);
            break;
        case Step::working:
            retry_.connected();
            told_.clear();
            tell(LinkState::up, fmt::format("the adapter is open at {} kbit/s", kbit_), listener);
            break;
    }
}

void SlcanChannel::write(std::string_view text) {
    unwritten_ += text;
    write_rest();
}

void SlcanChannel::write_rest() {
    while (!unwritten_.empty()) {
        const ssize_t count = ::write(port_.get(), unwritten_.data(), unwritten_.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            if (errno != EAGAIN) {
                fault_ = "the adapter is gone";
            }
            return;
        }
        unwritten_.erase(0, static_cast<std::size_t>(count));
    }
}

void SlcanChannel::read(ChannelListener& listener) {
    std::array<char, 1024> buffer{};
    for (std::size_t taken = 0; taken < bytes_per_service;) {
        const ssize_t count = ::read(port_.get(), buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0 && errno == EAGAIN) {
            return;
        }
        if (count <= 0) {
            fault_ = "the adapter is gone";
            return;
        }
        for (const char character : std::string_view(buffer.data(), static_cast<std::size_t>(count))) {
            if (const std::optional<SlcanEvent> event = reader_.take(character); event) {
                take(*event, listener);
            }
        }
        taken += static_cast<std::size_t>(count);
    }
}

void SlcanChannel::take(const SlcanEvent& event, ChannelListener& listener) {
    switch (event.answer) {
        case SlcanAnswer::frame:
            if (step_ == Step::working) {
                listener.frame(event.frame, now_);
            }
            break;
        case SlcanAnswer::damaged:
            if (step_ == Step::working) {
                listener.frames_lost(1, now_);
            }
            break;
        case SlcanAnswer::accepted:
        case SlcanAnswer::refused:
            take_answer(event.answer, listener);
            break;
    }
}

void SlcanChannel::take_answer(SlcanAnswer answer, ChannelListener& listener) {
    const bool refused = answer == SlcanAnswer::refused;
    if (step_ == Step::working) {
        if (refused && now_ >= next_refusal_) {
            next_refusal_ = now_ + refusal_interval;
            tell(LinkState::up, "the adapter refused a frame, which is lost", listener);
        }
    } else if (step_ == Step::bit_rate && fault_.empty()) {
        if (refused) {
            fault_ = fmt::format("the adapter refuses {} kbit/s", kbit_);
        } else {
            go_to(Step::open, listener);
        }
    } else if (step_ == Step::open && fault_.empty()) {
        if (refused) {
            fault_ = "the adapter refuses to open its channel";
        } else {
            go_to(Step::working, listener);
        }
    }
}

void SlcanChannel::lose(ChannelListener& listener) {
    if (step_ == Step::working) {
        retry_.lost(now_);
    } else {
        retry_.failed(now_);
    }
    port_.close();
    step_ = Step::nothing;
    if (fault_ != told_) {
        told_ = fault_;
        tell(LinkState::down, fault_, listener);
    }
}

void SlcanChannel::tell(LinkState state, const std::string& reason, ChannelListener& listener) {
    listener.link_changed(state, fmt::format("{}: {}", tty_, reason), now_);
}

}  // namespace cgw::media
