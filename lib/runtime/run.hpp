// A gateway in real time from start to end, for any image: opens what it is told to, runs until a signal or
// the end of its time, and tells what happens.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "image/image.hpp"
#include "media/channel.hpp"

namespace cgw::runtime {

struct Settings {
    // As media::open_channel() reads it. Empty: a simulated governor inside the program.
    std::string can1;
    // Empty: a bus inside the program with nobody on it.
    std::string can2;
    std::string log;                      // file of all frames; empty: none
    std::string state;                    // file of the permanent error memory; empty: none
    media::Time duration = media::never;  // microseconds
    bool status_at_end = false;
    std::string introduction;  // whole lines, printed first, once everything could be opened
};

struct Output {
    std::function<void(std::string_view text)> print;     // whole lines, what the run is about
    std::function<void(std::string_view line)> complain;  // one line, without a line feed
    std::function<void(std::string_view text)> show;      // whole lines, asked for by SIGUSR1
};

enum class Ending {
    fine,         // by SIGINT, SIGTERM, SIGHUP, or because the time was over
    refused,      // the gateway does not take the image
    environment,  // an interface is missing, a file cannot be read, or at the end not be written
};

// Takes the signals named above while it runs, SIGUSR1 (shows the measurements) and SIGUSR2 (clears errors).
// One run at a time.
Ending run(const image::Image& image, const Settings& settings, const Output& output);

}  // namespace cgw::runtime
