// What `cgw simulate` shows: events as lines, and on a terminal a block below them that is painted again and
// again.
#pragma once

#include <string>
#include <vector>

#include "scenario/events.hpp"
#include "simulation/installation.hpp"

namespace cgw::cli {

// An event as a line with its line feed, for people or as JSON.
std::string event_line(const scenario::Event& event, bool color);
std::string event_json(const scenario::Event& event);

// Bus loads, between two looks at them.
class BusLoads {
  public:
    // Percent since the last look at least half a simulated second ago.
    void look(simulation::Plant& plant);
    double can1() const { return percent_[0]; }
    double can2() const { return percent_[1]; }

  private:
    simulation::Time before_ = 0;
    simulation::Time busy_[2]{};
    double percent_[2]{};
};

// States and values as they are: at most `rows` lines of at most `columns` columns, without colour or line
// feeds. `speed` as the user reads it.
std::vector<std::string> live_block(simulation::Installation& installation, const BusLoads& loads,
                                    std::string_view speed, std::size_t columns, std::size_t rows);

// Lines that scroll, above a block that stays at the bottom of the terminal.
class LiveScreen {
  public:
    explicit LiveScreen(bool color) : color_(color) {}

    // Both false when standard output cannot be written.
    bool add(const std::string& line);
    bool paint(const std::vector<std::string>& block);
    // The block stays, what comes after it stands below.
    void leave() { painted_ = 0; }

    // Of the terminal, now; 80 x 24 where it does not say.
    static std::size_t columns();
    static std::size_t rows();

  private:
    std::string erased() const;

    bool color_;
    std::size_t painted_ = 0;  // lines
    std::vector<std::string> block_;
};

}  // namespace cgw::cli
