#include "base/edit_distance.hpp"

#include <algorithm>
#include <vector>

#include "base/ascii.hpp"

namespace cgw::base {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the optimal-string-alignment matrix.
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t cost = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
            current[j] = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + cost});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) {
                current[j] = std::min(current[j], before[j - 2] + 1);
            }
        }
        before.swap(last);
        last.swap(current);
    }
    return last[b.size()];
}

std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
    constexpr std::size_t longest = 64;  // no name in any table is longer; keeps hostile keys cheap
    if (name.empty() || name.size() > longest) {
        return {};
    }
    std::string_view best;
    std::size_t best_distance = name.size();
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate);
        const std::size_t allowed = std::max<std::size_t>(1, std::max(name.size(), candidate.size()) / 3);
        if (distance <= allowed && distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return std::string(best);
}

}  // namespace cgw::base
