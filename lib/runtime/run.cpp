#include "runtime/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <ctime>

#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "base/wrap.hpp"
#include "media/log.hpp"
#include "media/open_channel.hpp"
#include "runtime/empty_bus.hpp"
#include "runtime/event_lines.hpp"
#include "runtime/gateway_node.hpp"
#include "runtime/keeper.hpp"
#include "runtime/status_page.hpp"
#include "simulation/text.hpp"

namespace cgw::runtime {
namespace {

constexpr Time second = 1'000'000;
constexpr std::size_t line_width = 80;

std::tm local_time(std::uint64_t wall_time) {
    const auto seconds = static_cast<std::time_t>(wall_time / second);
    std::tm parts{};
    ::localtime_r(&seconds, &parts);
    return parts;
}

std::string date_text(std::uint64_t wall_time) {
    const std::tm parts = local_time(wall_time);
    return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

std::string time_text(std::uint64_t wall_time) {
    const std::tm parts = local_time(wall_time);
    return fmt::format("{:02}:{:02}:{:02}.{:03}", parts.tm_hour, parts.tm_min, parts.tm_sec,
                       wall_time % second / 1000);
}

std::string_view side_text(Side side) {
    return side == Side::can1 ? "CAN1" : "CAN2";
}

std::string signal_text(int number) {
    const char* const name = ::sigabbrev_np(number);
    return name == nullptr ? fmt::format("signal {}", number) : fmt::format("SIG{}", name);
}

class Run final : public Events {
  public:
    Run(const image::Image& image, const Settings& settings, const Output& output)
        : image_(image), settings_(settings), output_(output) {}

    Ending execute();

    void status_changed(const device::GatewayStatus& before, const device::GatewayStatus& now) override;
    void link_changed(Side side, media::LinkState state, std::string_view reason) override;
    void frames_lost(Side side, std::uint64_t count) override;
    void governor_refused(const link::Refusal& refusal) override { say(line_of_refusal(refusal)); }
    void left_out(Time time) override;
    void frame(Side side, const frame::Frame& frame) override {
        keeper_->record(side, frame, media::wall_clock_now());
    }

  private:
    bool open_files();
    bool open_bus(Side side, const std::string& text, Connection& connection);
    void introduce();
    void loop(media::Signals& signals);
    void take_signal(int number);
    void finish();
    void check_bit_rate(Side side);
    void say(std::string_view text);

    const image::Image& image_;
    const Settings& settings_;
    const Output& output_;
    media::Loop loop_;
    std::optional<Keeper> keeper_;
    std::unique_ptr<GatewayNode> node_;
    std::string date_;  // of the last line
    std::string why_ended_ = "its time is over";
    std::array<std::uint32_t, 2> wrong_rate_{};  // told already, by side
};

bool Run::open_files() {
    std::optional<media::LogStream> log;
    std::optional<ErrorMemory> memory;
    if (!settings_.state.empty()) {
        auto opened = ErrorMemory::open(settings_.state, base::short_id(image_.configuration_id()));
        if (!opened) {
            output_.complain(opened.error().message);
            return false;
        }
        memory = std::move(*opened);
    }
    if (!settings_.log.empty()) {
        const auto format = media::log_format_of(settings_.log).value_or(media::LogFormat::candump);
        auto opened = media::LogStream::open(settings_.log, format);
        if (!opened) {
            output_.complain(opened.error().message);
            return false;
        }
        log = std::move(*opened);
    }
    keeper_.emplace(std::move(log), std::move(memory), output_.complain);
    return true;
}

bool Run::open_bus(Side side, const std::string& text, Connection& connection) {
    connection.name = text;
    if (text.empty()) {
        const bool governor = side == Side::can1;
        connection.name = governor ? "a simulated governor" : "a bus inside the program, with nobody on it";
        connection.channel = governor ? nullptr : std::make_unique<EmptyBus>();
        return true;
    }
    auto opened = media::open_channel(text);
    if (!opened) {
        output_.complain(opened.error().message);
        return false;
    }
    connection.channel = std::move(*opened);
    return true;
}

Ending Run::execute() {
    Connection can1;
    Connection can2;
    if (!open_bus(Side::can1, settings_.can1, can1) || !open_bus(Side::can2, settings_.can2, can2) ||
        !open_files()) {
        return Ending::environment;
    }
    const auto boot = static_cast<std::uint8_t>(media::wall_clock_now() / second);
    node_ = std::make_unique<GatewayNode>(image_, std::move(can1), std::move(can2), boot, *this);
    if (node_->status() != device::OpenStatus::ok) {
        output_.complain(fmt::format("the configuration is refused: {}", device::to_text(node_->status())));
        return Ending::refused;
    }
    if (keeper_->memory()) {
        node_->gateway().restore(keeper_->memory()->sentinels());
    }
    // From here on a signal is a wish, also while the last files are written.
    media::Signals signals({SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2},
                           [this](int number) { take_signal(number); });
    introduce();
    loop(signals);
    finish();
    return keeper_->complete() ? Ending::fine : Ending::environment;
}

void Run::introduce() {
    const Diagnosis diagnosis = node_->diagnosis();
    date_ = date_text(media::wall_clock_now());
    std::string text = settings_.introduction;
    text += fmt::format("CAN1 {}\nCAN2 {}\n", base::printable(diagnosis.can1.name),
                        base::printable(diagnosis.can2.name));
    text += fmt::format("{}, {}\n", date_,
                        settings_.duration == media::never
                            ? "until SIGINT or SIGTERM; SIGUSR1 shows the measurements"
                            : fmt::format("for {:g} s", static_cast<double>(settings_.duration) / second));
    output_.print(text);
}

void Run::loop(media::Signals& signals) {
    media::Timer keep(loop_.now(), [this](Time now) {
        keeper_->write(node_->gateway().errors().sentinels());
        return now + second;
    });
    media::Timer end(settings_.duration == media::never ? media::never : loop_.now() + settings_.duration,
                     [this](Time) {
                         loop_.stop();
                         return media::never;
                     });
    if (keeper_->has_work()) {
        loop_.add(keep);
    }
    loop_.add(end);
    loop_.add(signals);
    loop_.add(*node_);
    loop_.run();
}

void Run::take_signal(int number) {
    if (number == SIGUSR1) {
        output_.show(status_page(node_->diagnosis()));
        return;
    }
    if (number == SIGUSR2) {
        say("clear errors (SIGUSR2)");
        node_->clear_errors(loop_.now());
        return;
    }
    why_ended_ = signal_text(number);
    loop_.stop();
}

void Run::finish() {
    const Diagnosis diagnosis = node_->diagnosis();
    keeper_->write(diagnosis.gateway->errors().sentinels());
    say(fmt::format("ends: {}", why_ended_));
    std::string text;
    if (settings_.status_at_end) {
        text = status_page(diagnosis);
    } else {
        text = fmt::format("ran {:.1f} s, gateway {}\n", static_cast<double>(diagnosis.now) / second,
                           simulation::to_text(diagnosis.gateway->state()));
        for (const auto& [name, bus] :
             {std::pair{"CAN1", &diagnosis.can1}, std::pair{"CAN2", &diagnosis.can2}}) {
            text += fmt::format("{} frames received {}, sent {}, lost {}\n", name, bus->received, bus->sent,
                                bus->lost);
        }
    }
    if (const auto& log = keeper_->log(); log) {
        text += keeper_->log_complete()
                    ? fmt::format("log {}: {} frames\n", base::printable(log->path()), log->frames())
                    : fmt::format("log {}: not complete\n", base::printable(log->path()));
    }
    output_.print(text);
}

void Run::status_changed(const device::GatewayStatus& before, const device::GatewayStatus& now) {
    if (node_ != nullptr) {  // else it is being built
        for (const std::string& line : lines_of_change(before, now)) {
            say(line);
        }
    }
}

void Run::link_changed(Side side, media::LinkState state, std::string_view reason) {
    say(fmt::format("{} {}: {}", side_text(side), state == media::LinkState::up ? "up" : "down", reason));
    if (state == media::LinkState::up) {
        check_bit_rate(side);
    }
}

void Run::check_bit_rate(Side side) {
    const image::Bus bus = side == Side::can1 ? image_.can1() : image_.can2();
    const std::uint32_t rate = node_->bit_rate(side).value_or(0);
    std::uint32_t& told = wrong_rate_[static_cast<std::size_t>(side)];
    if (rate == 0 || bus.manual_timing || rate == bus.bit_rate_kbit * 1000U || rate == told) {
        return;
    }
    told = rate;
    say(fmt::format("warning: {} runs at {:g} kbit/s, but the configuration says {} kbit/s ({})",
                    side_text(side), rate / 1000.0, bus.bit_rate_kbit, side == Side::can1 ? 416 : 426));
}

void Run::frames_lost(Side side, std::uint64_t count) {
    say(fmt::format("{} lost {} frame{} before the gateway could take {}", side_text(side), count,
                    count == 1 ? "" : "s", count == 1 ? "it" : "them"));
}

void Run::left_out(Time time) {
    say(fmt::format("the program did not run for {:.1f} s; the gateway goes on where it was",
                    static_cast<double>(time) / second));
}

void Run::say(std::string_view text) {
    const std::uint64_t now = media::wall_clock_now();
    std::string lines;
    if (const std::string date = date_text(now); date != date_) {
        date_ = date;
        lines = date + "\n";
    }
    std::string begin = time_text(now) + "  ";
    for (const std::string& line : base::wrap(base::printable(text), line_width - begin.size())) {
        lines += fmt::format("{}{}\n", begin, line);
        std::ranges::fill(begin, ' ');
    }
    output_.print(lines);
}

}  // namespace

Ending run(const image::Image& image, const Settings& settings, const Output& output) {
    return Run(image, settings, output).execute();
}

}  // namespace cgw::runtime
