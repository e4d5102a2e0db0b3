// What the audit found, as findings.
#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "diagnostic/rules/frames.hpp"
#include "traffic/audit.hpp"

namespace cgw::traffic {

namespace rules = diagnostic::rules;

namespace {

std::string times_text(std::uint64_t count) {
    return count == 1 ? "once" : fmt::format("{} times", count);
}

std::string ms(double microseconds) {
    return fmt::format("{:.3f} ms", microseconds / 1000);
}

std::string ms(Microseconds microseconds) {
    return base::milliseconds_text(microseconds);
}

std::string frame_text(const Watched& watched) {
    return fmt::format("{} ({})", watched.name, base::identifier_text(watched.identifier));
}

}  // namespace

class Audit::Report {
  public:
    Report(const Audit& audit, const std::string& path) : audit_(audit), path_(path) {}

    diagnostic::Findings run() {
        tell_reading();
        if (audit_.frames_ == 0) {
            report(rules::log_empty, 0, "there is no frame in this log");
        }
        tell_unexpected();
        for (const Watched& watched : audit_.watched_) {
            tell_missing(watched);
            tell_lengths(watched, watched.wrong, rules::frame_length);
            tell_lengths(watched, watched.longer, rules::frame_long);
            tell_times(watched);
        }
        findings_.sort();
        return std::move(findings_);
    }

  private:
    void report(const diagnostic::Rule& rule, std::uint64_t number, std::string message,
                std::string help = {}) {
        constexpr std::uint64_t highest = ~std::uint32_t{0} - 1;
        diagnostic::Location where{.path = path_, .range = {}};
        if (number != 0 && audit_.has_lines_) {
            const auto line = static_cast<std::uint32_t>(std::min(number, highest));
            where.range = {{line, 1}, {line, 1}};
        } else if (number != 0) {
            message = fmt::format("record {}: {}", number, message);
        }
        findings_.report({&rule, std::move(message), std::move(where), {}, std::move(help)});
    }

    void tell_reading() {
        for (const Fault& fault : audit_.told_faults_) {
            report(rules::log_record, fault.number, fault.text);
        }
        if (const std::uint64_t more = audit_.faults_ - audit_.told_faults_.size(); more != 0) {
            report(rules::log_record, 0, fmt::format("{} more are no frames either", more));
        }
        if (audit_.backwards_ != 0) {
            report(
                rules::log_time, audit_.first_backwards_.number,
                fmt::format(
                    "time runs backwards here{}",
                    audit_.backwards_ == 1 ? "" : fmt::format(", {} in all", times_text(audit_.backwards_))),
                "do not judge gaps and periods by this log");
        }
        if (!audit_.timed_) {
            report(rules::log_time, 0, "the frames have no times, so that none are judged",
                   "record with candump -L or candump -t a");
        }
    }

    void tell_unexpected() {
        std::size_t told = 0;
        std::size_t more = 0;
        for (std::uint32_t identifier = 0; identifier < audit_.unexpected_.size(); ++identifier) {
            const std::uint64_t count = audit_.unexpected_[identifier];
            if (count == 0) {
                continue;
            }
            if (++told > most_told) {
                ++more;
                continue;
            }
            const std::string use = default_use(identifier);
            report(rules::frame_unexpected, audit_.unexpected_at_[identifier],
                   fmt::format("{} is no frame of this plant, and was seen {}; {}",
                               base::identifier_text(identifier), times_text(count),
                               use.empty() ? "CiA 301 gives it to nobody" : "by default it is " + use));
        }
        if (more != 0) {
            report(rules::frame_unexpected, 0,
                   fmt::format("{} more identifiers are none of this plant", more));
        }
        if (audit_.extended_ != 0) {
            report(rules::frame_unexpected, audit_.first_extended_,
                   fmt::format("frames with a 29-bit identifier were seen {}", times_text(audit_.extended_)));
        }
    }

    // How long Operational must have lasted for a frame to be missed.
    static Microseconds patience(const Watched& watched) {
        const Microseconds time = std::max(watched.rhythm.period_us(), watched.rhythm.monitoring_us());
        return time + time / 2 + start_grace_us;
    }

    void tell_missing(const Watched& watched) {
        if (watched.rhythm.frames() != 0 || audit_.frames_ == 0 || !audit_.timed_) {
            return;
        }
        const bool own_heartbeat = watched.frame == nullptr && watched.rhythm.period_us() != 0;
        const Microseconds lasted = own_heartbeat
                                        ? audit_.last_us_ - std::min(audit_.first_us_, audit_.last_us_)
                                        : audit_.longest_window_us_;
        if (lasted <= patience(watched)) {
            return;
        }
        const bool on_change =
            watched.frame != nullptr && watched.frame->transmit() && watched.rhythm.period_us() == 0;
        const bool unwatched_rpdo =
            watched.frame != nullptr && !watched.frame->transmit() && watched.rhythm.monitoring_us() == 0;
        if (unwatched_rpdo || (on_change && !audit_.entry_recorded_)) {
            report(
                rules::frame_not_seen, 0,
                fmt::format("{} does not occur in the log{}", frame_text(watched),
                            on_change ? ", which begins in Operational: it is sent on each entry and when a "
                                        "bit changes"
                                      : ""));
            return;
        }
        report(rules::frame_missing, 0,
               fmt::format("{} was never sent, though {}", frame_text(watched),
                           own_heartbeat ? fmt::format("the log lasts {}", ms(lasted))
                                         : fmt::format("the gateway was Operational for {}", ms(lasted))));
    }

    void tell_lengths(const Watched& watched, const WrongLengths& lengths, const diagnostic::Rule& rule) {
        if (lengths.count != 0) {
            report(rule, lengths.first.number,
                   fmt::format("{} has {} byte{} here and {} in the plant, {} in all", frame_text(watched),
                               lengths.bytes, lengths.bytes == 1 ? "" : "s", watched.frame->length,
                               times_text(lengths.count)));
        }
    }

    void tell_times(const Watched& watched) {
        if (watched.when_stopped != 0) {
            report(rules::frame_when_stopped, watched.first_when_stopped.number,
                   fmt::format("{} was sent {} while the gateway was not Operational", frame_text(watched),
                               times_text(watched.when_stopped)));
        }
        if (!audit_.timed_ || watched.rhythm.frames() == 0) {
            return;
        }
        const Rhythm& rhythm = watched.rhythm;
        if (const double deviation = rhythm.deviation(); deviation != 0) {
            report(
                rules::frame_period, 0,
                fmt::format("{} came every {} on average, {:.1f} % {} than {}", frame_text(watched),
                            ms(rhythm.judged_mean_us()), deviation < 0 ? -100 * deviation : 100 * deviation,
                            deviation < 0 ? "sooner" : "later", ms(rhythm.period_us())));
        }
        if (const Gaps late = rhythm.late(); late.count != 0) {
            report(rules::frame_gap, late.behind.number,
                   fmt::format("{} stayed out for {}, its period is {}; {}", frame_text(watched),
                               ms(late.longest_us), ms(rhythm.period_us()), in_all(late)));
        }
        if (const Gaps& gaps = rhythm.exceeded(); gaps.count != 0) {
            report(rules::monitoring_exceeded, gaps.behind.number,
                   fmt::format("{} stayed out for {}, and is missed after {}; {}", frame_text(watched),
                               ms(gaps.longest_us), ms(rhythm.monitoring_us()), in_all(gaps)));
        }
    }

    static std::string in_all(const Gaps& gaps) {
        const std::string times =
            gaps.count == 1 ? "once" : fmt::format("{}, this was the longest", times_text(gaps.count));
        return gaps.behind.number == 0 ? times + ", until the end of the log" : times;
    }

    const Audit& audit_;
    const std::string& path_;
    diagnostic::Findings findings_;
};

diagnostic::Findings Audit::findings(const std::string& path) const {
    return Report(*this, path).run();
}

}  // namespace cgw::traffic
