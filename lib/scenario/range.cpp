#include "scenario/range.hpp"

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "scenario/act.hpp"

namespace cgw::scenario {

std::string range_text(const Step& step, std::string_view unit) {
    const Value& least = step.values[1];
    const Value& greatest = step.values[2];
    std::string text = least.given && greatest.given ? fmt::format("{}..{}", base::to_text(least.number),
                                                                   base::to_text(greatest.number))
                       : least.given                 ? fmt::format("at least {}", base::to_text(least.number))
                                     : fmt::format("at most {}", base::to_text(greatest.number));
    return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

bool in_range(const Step& step, double value) {
    return (!step.values[1].given || value >= step.values[1].number) &&
           (!step.values[2].given || value <= step.values[2].number);
}

std::string range_is_empty(const image::Image&, const Step& step) {
    const Value& least = step.values[1];
    const Value& greatest = step.values[2];
    if (!least.given && !greatest.given) {
        return "give `min`, `max` or both";
    }
    return least.given && greatest.given && least.number > greatest.number
               ? fmt::format("`min` {} is greater than `max` {}", base::to_text(least.number),
                             base::to_text(greatest.number))
               : "";
}

}  // namespace cgw::scenario
