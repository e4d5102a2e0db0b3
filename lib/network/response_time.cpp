#include "network/response_time.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace cgw::network {
namespace {

using Time = std::uint64_t;

constexpr std::uint64_t most_steps = 40'000'000;        // of one call
constexpr std::uint64_t most_steps_of_one = 2'000'000;  // of one message

// Releases in a window that opens with the latest possible one.
Time count_of(Time window, Time jitter, Time period) {
    return (window + jitter + period - 1) / period;
}

// Cut at longest_ns, so that sums stay far from the end of 64 bits.
Time times(Time count, Time cost) {
    return cost != 0 && count > longest_ns / cost ? longest_ns : count * cost;
}

// Messages that are released alike count as one.
struct Releases {
    Time period = 0;
    Time jitter = 0;
    Time cost = 0;
};

// Share of the bus, rounded up.
class Share {
  public:
    void add(Time cost, Time period) {
        const Time part = cost >= period ? whole : (cost * whole + period - 1) / period;
        sum_ = std::min(sum_ + part, whole);
    }
    bool is_whole() const { return sum_ >= whole; }

  private:
    static constexpr Time whole = Time{1} << 34U;
    Time sum_ = 0;
};

class Search {
  public:
    // Streams by priority.
    Search(std::vector<Stream> streams, const Disturbance& disturbance)
        : streams_(std::move(streams)), disturbance_(disturbance) {}

    std::vector<Response> run() {
        const std::vector<Time> blocking = longest_behind();
        std::vector<Response> responses;
        for (std::size_t begin = 0; begin < streams_.size();) {
            const std::size_t end = end_of_priority(begin);
            for (std::size_t i = begin; i < end; ++i) {
                take_in(streams_[i]);
            }
            begin_priority(blocking[end]);
            for (std::size_t i = begin; i < end; ++i) {
                responses.push_back(response_of(streams_[i]));
            }
            begin = end;
        }
        return responses;
    }

  private:
    std::size_t end_of_priority(std::size_t begin) const {
        std::size_t end = begin;
        while (end < streams_.size() && streams_[end].priority == streams_[begin].priority) {
            ++end;
        }
        return end;
    }

    // The longest frame from each stream on.
    std::vector<Time> longest_behind() const {
        std::vector<Time> longest(streams_.size() + 1);
        for (std::size_t i = streams_.size(); i-- > 0;) {
            longest[i] = std::max(longest[i + 1], streams_[i].cost_ns);
        }
        return longest;
    }

    // From now on it delays those of its own priority and all that follow.
    void take_in(const Stream& stream) {
        const auto [place, is_new] =
            places_.try_emplace({stream.period_ns, stream.jitter_ns}, releases_.size());
        if (is_new) {
            releases_.push_back({stream.period_ns, stream.jitter_ns, 0});
        }
        releases_[place->second].cost += stream.cost_ns;
        share_.add(stream.cost_ns, stream.period_ns);
        longest_frame_ = std::max(longest_frame_, stream.cost_ns);
    }

    // With the same blocking nothing is faster than for the priority before, so that its search is gone on
    // with. Errors are left out there: they also depend on the length of the message itself.
    void begin_priority(Time blocking) {
        const bool goes_on = blocking == blocking_ && disturbance_.error_interval_ns == 0;
        blocking_ = blocking;
        busy_ = goes_on ? busy_ : blocking;
        wait_ = goes_on ? longest_wait_ : blocking;
        longest_wait_ = wait_;
    }

    Time error_cost() const { return error_bits * disturbance_.bit_ns + longest_frame_; }

    Time errors(Time window) const {
        const Time interval = disturbance_.error_interval_ns;
        return interval == 0 ? 0 : times((window + interval - 1) / interval, error_cost());
    }

    // Time of all frames of higher and equal priority that are released within the window.
    Time released(Time window) {
        steps_ += releases_.size();
        Time sum = 0;
        for (const Releases& group : releases_) {
            const Time count = count_of(window, group.jitter, group.period);
            sum = std::min(longest_ns, sum + times(count, group.cost));
        }
        return sum;
    }

    // The same without those of one message.
    Time released_without(const Stream& stream, Time window) {
        const Time all = released(window);
        const Time own = times(count_of(window, stream.jitter_ns, stream.period_ns), stream.cost_ns);
        return all < longest_ns ? all - own : longest_ns;
    }

    // The fixed point of a function that never falls, at or above `value`; nothing when it is too far.
    template <typename Function>
    std::optional<Time> settle(Time value, Function function) {
        for (;;) {
            const Time next = std::min(longest_ns, function(value));
            if (next == value && value < longest_ns) {
                return value;
            }
            value = next;
            if (value >= longest_ns || steps_ > most_steps || steps_ > limit_) {
                return std::nullopt;
            }
        }
    }

    Response response_of(const Stream& own) {
        Share share = share_;
        if (disturbance_.error_interval_ns != 0) {
            share.add(error_cost(), disturbance_.error_interval_ns);
        }
        if (share.is_whole()) {
            return {Bound::none};
        }
        limit_ = steps_ + most_steps_of_one;
        const std::optional<Time> busy = settle(std::max(busy_, own.cost_ns), [&](Time window) {
            return blocking_ + errors(window) + released(window);
        });
        if (!busy) {
            return {Bound::not_found};
        }
        busy_ = *busy;
        return latest(own, count_of(*busy, own.jitter_ns, own.period_ns));
    }

    // Of the instances of the busy period the one that takes longest.
    Response latest(const Stream& own, Time instances) {
        if (instances > most_steps_of_one / releases_.size()) {
            return {Bound::not_found};
        }
        Response response{Bound::found};
        Time start = wait_;
        for (Time instance = 0; instance < instances; ++instance) {
            const Time before = times(instance, own.cost_ns);
            const std::optional<Time> wait = settle(start, [&](Time window) {
                return blocking_ + before + errors(window + own.cost_ns) +
                       released_without(own, window + disturbance_.bit_ns);
            });
            if (!wait) {
                return {Bound::not_found};
            }
            longest_wait_ = instance == 0 ? std::max(longest_wait_, *wait) : longest_wait_;
            const Time through = own.jitter_ns + *wait + own.cost_ns;
            const Time due = times(instance, own.period_ns);
            response.time_ns = std::max(response.time_ns, through - std::min(due, through));
            start = *wait + own.cost_ns;
        }
        return response;
    }

    std::vector<Stream> streams_;
    Disturbance disturbance_;
    std::vector<Releases> releases_;                       // of all taken in
    std::map<std::pair<Time, Time>, std::size_t> places_;  // of period and jitter in releases_
    Share share_;
    Time longest_frame_ = 0;
    Time blocking_ = ~Time{0};  // the longest frame of lower priority
    Time busy_ = 0;             // where searches may begin: of the busy period,
    Time wait_ = 0;             // of the wait before the first instance
    Time longest_wait_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t limit_ = 0;
};

}  // namespace

std::vector<Response> response_times(std::span<const Stream> streams, const Disturbance& disturbance) {
    std::vector<std::size_t> order(streams.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return streams[a].priority < streams[b].priority; });
    std::vector<Stream> sorted;
    for (const std::size_t i : order) {
        Stream stream = streams[i];
        stream.cost_ns = std::clamp<Time>(stream.cost_ns, 1, longest_frame_ns);
        stream.period_ns = std::clamp<Time>(stream.period_ns, 1, longest_ns);
        stream.jitter_ns = std::min(stream.jitter_ns, longest_ns);
        sorted.push_back(stream);
    }
    const Disturbance cut{std::min(disturbance.bit_ns, longest_bit_ns),
                          std::min(disturbance.error_interval_ns, longest_ns)};
    const std::vector<Response> found = Search(std::move(sorted), cut).run();
    std::vector<Response> responses(streams.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        responses[order[i]] = found[i];
    }
    return responses;
}

}  // namespace cgw::network
