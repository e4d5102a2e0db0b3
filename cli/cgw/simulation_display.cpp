#include "cli/cgw/simulation_display.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "base/json.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/terminal.hpp"
#include "scenario/names.hpp"
#include "simulation/engine_state_word.hpp"
#include "simulation/text.hpp"

namespace cgw::cli {
namespace {

constexpr std::string_view red = "\x1b[31m";
constexpr std::string_view green = "\x1b[32m";
constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view plain = "\x1b[0m";

constexpr std::size_t name_width = 20;
constexpr std::size_t value_width = 16;

std::string padded(const std::string& text, std::size_t width, char fill = ' ') {
    const std::size_t columns = base::width_of(text);
    return columns < width ? text + std::string(width - columns, fill) : text;
}

std::string right_aligned(const std::string& text, std::size_t width) {
    const std::size_t columns = base::width_of(text);
    return columns < width ? std::string(width - columns, ' ') + text : text;
}

std::string head_line(simulation::Installation& installation, std::string_view speed, std::size_t columns) {
    simulation::Plant& plant = installation.plant();
    const auto time = static_cast<double>(installation.now()) / 1e6;
    return padded(fmt::format("-- {:.1f} s, speed {} -- gateway {} -- engine {} ", time, speed,
                              simulation::to_text(plant.gateway().state()),
                              simulation::engine_text(plant.governor().engine().state())),
                  columns, '-');
}

std::string engine_line(simulation::Installation& installation) {
    const simulation::EngineState& engine = installation.plant().governor().engine().state();
    return fmt::format("engine  {:.0f} 1/min, load {:.1f} %, oil pressure {:.2f} bar, coolant {:.1f} °C",
                       engine.speed, engine.load, engine.oil_pressure, engine.coolant_temperature);
}

std::string bus_line(simulation::Installation& installation, const BusLoads& loads) {
    simulation::Plant& plant = installation.plant();
    const auto bus = [](std::string_view name, bool connected, double load) {
        return connected ? fmt::format("{} load {:.1f} %", name, load) : fmt::format("{} is cut", name);
    };
    return fmt::format("buses   {}, {}", bus("CAN1", plant.can1().connected(), loads.can1()),
                       bus("CAN2", plant.can2().connected(), loads.can2()));
}

std::string list_text(const std::vector<std::string>& texts) {
    return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

std::string alarm_line(simulation::Installation& installation) {
    const simulation::EngineAlarms& alarms = installation.plant().governor().alarms();
    std::vector<std::string> texts;
    if (alarms.emergency_stop()) {
        texts.emplace_back("emergency stop");
    }
    for (const simulation::AlarmRow& row : simulation::alarm_rows()) {
        if (alarms.present(row.alarm)) {
            texts.emplace_back(row.text);
        }
    }
    return fmt::format("alarms  {}", list_text(texts));
}

std::string error_line(simulation::Installation& installation) {
    std::vector<std::string> texts;
    for (const std::uint16_t number : installation.error_numbers()) {
        texts.push_back(scenario::error_text(number));
    }
    return fmt::format("errors  {}", list_text(texts));
}

// The words of the transmit PDOs as the PLC received them, two in a line.
std::vector<std::string> word_lines(simulation::Installation& installation) {
    std::vector<std::string> lines;
    bool open = false;
    for (const auto& [number, word] : simulation::received_words(installation.node(), installation.image())) {
        const std::string name =
            simulation::clipped(simulation::parameter_text(installation.image(), number), name_width);
        const std::string cell =
            padded(name, name_width) + ' ' +
            right_aligned(simulation::value_text(installation.image(), number, word), value_width);
        if (open) {
            lines.back() += "     " + cell;
        } else {
            lines.push_back(cell);
        }
        open = !open;
    }
    return lines;
}

winsize terminal_size() {
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) {
        size = {};
    }
    return size;
}

}  // namespace

std::string event_line(const scenario::Event& event, bool color) {
    const std::string line = scenario::line_of(event);
    const bool met = event.kind == scenario::EventKind::expected && !event.bad;
    if (!color || (!event.bad && !met)) {
        return line + '\n';
    }
    return fmt::format("{}{}{}\n", event.bad ? red : green, line, plain);
}

std::string event_json(const scenario::Event& event) {
    base::JsonWriter json;
    json.begin_object();
    json.key("time_us").integer(static_cast<std::int64_t>(event.time));
    json.key("event").string(scenario::to_text(event.kind));
    json.key("text").string(event.text);
    json.key("bad").boolean(event.bad);
    json.end_object();
    return json.take();
}

void BusLoads::look(simulation::Plant& plant) {
    constexpr simulation::Time shortest = 500'000;
    const simulation::Time passed = plant.now() - before_;
    if (passed < shortest) {
        return;
    }
    before_ = plant.now();
    const simulation::Time busy[] = {plant.can1().busy_time(), plant.can2().busy_time()};
    for (std::size_t i = 0; i < std::size(busy); ++i) {
        percent_[i] =
            std::min(100.0, 100.0 * static_cast<double>(busy[i] - busy_[i]) / static_cast<double>(passed));
        busy_[i] = busy[i];
    }
}

std::vector<std::string> live_block(simulation::Installation& installation, const BusLoads& loads,
                                    std::string_view speed, std::size_t columns, std::size_t rows) {
    std::vector<std::string> block{head_line(installation, speed, columns), engine_line(installation),
                                   bus_line(installation, loads), alarm_line(installation),
                                   error_line(installation)};
    for (std::string& line : word_lines(installation)) {
        block.push_back(std::move(line));
    }
    block.resize(std::min(block.size(), rows));
    for (std::string& line : block) {
        line = simulation::clipped(line, columns);
    }
    return block;
}

std::string LiveScreen::erased() const {
    return painted_ == 0 ? "" : fmt::format("\x1b[{}A\r\x1b[J", painted_);
}

bool LiveScreen::add(const std::string& line) {
    std::string text = erased() + line;
    for (std::size_t i = 0; i < painted_; ++i) {
        text += block_[i] + '\n';
    }
    return print(text);
}

bool LiveScreen::paint(const std::vector<std::string>& block) {
    std::string text = erased();
    block_ = block;
    painted_ = block_.size();
    if (color_ && !block_.empty()) {
        block_.front() = fmt::format("{}{}{}", bold, block_.front(), plain);
    }
    for (const std::string& line : block_) {
        text += line + '\n';
    }
    return print(text);
}

std::size_t LiveScreen::columns() {
    const winsize size = terminal_size();
    return size.ws_col == 0 ? simulation::line_width
                            : std::min<std::size_t>(size.ws_col, simulation::line_width);
}

std::size_t LiveScreen::rows() {
    constexpr std::size_t usual = 24;
    const winsize size = terminal_size();
    return size.ws_row == 0 ? usual : size.ws_row;
}

}  // namespace cgw::cli
