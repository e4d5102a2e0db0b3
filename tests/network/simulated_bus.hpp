// A CAN bus as a simulation from event to event: frames wait, the lowest identifier goes first, one that has
// begun is not interrupted. An oracle for response times that shares nothing with the analysis.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "network/response_time.hpp"

namespace cgw::network_test {

struct Frame {
    std::uint64_t due = 0;       // when it should be released
    std::uint64_t released = 0;  // when it is
    std::uint64_t length = 0;
};

// `frames_of(stream)` gives the frames of a stream in order of release. The longest time from due to through,
// by stream.
inline std::vector<std::uint64_t> longest_responses(
    std::span<const network::Stream> streams,
    const std::function<std::vector<Frame>(std::size_t)>& frames_of) {
    std::vector<std::vector<Frame>> waiting;
    for (std::size_t i = 0; i < streams.size(); ++i) {
        waiting.push_back(frames_of(i));
    }
    std::vector<std::size_t> next(streams.size());
    std::vector<std::uint64_t> longest(streams.size());
    for (std::uint64_t now = 0;;) {
        std::size_t first = streams.size();
        std::uint64_t earliest = ~std::uint64_t{0};
        for (std::size_t i = 0; i < streams.size(); ++i) {
            if (next[i] == waiting[i].size()) {
                continue;
            }
            const std::uint64_t released = waiting[i][next[i]].released;
            earliest = std::min(earliest, released);
            const bool takes_part = released <= now;
            if (takes_part && (first == streams.size() || streams[i].priority < streams[first].priority)) {
                first = i;
            }
        }
        if (first == streams.size()) {
            if (earliest == ~std::uint64_t{0}) {
                return longest;
            }
            now = earliest;
            continue;
        }
        const Frame& frame = waiting[first][next[first]++];
        now += frame.length;
        longest[first] = std::max(longest[first], now - frame.due);
    }
}

}  // namespace cgw::network_test
