// Searches that stay small in firmware: the standard library's find, any_of and all_of are unrolled four
// times over, whatever the compiler optimises for.
#pragma once

namespace cgw::wire {

template <typename Range, typename Value>
constexpr bool contains(const Range& range, const Value& wanted) {
    for (const auto& value : range) {
        if (value == wanted) {
            return true;
        }
    }
    return false;
}

template <typename Range, typename Value>
constexpr bool all_are(const Range& range, const Value& wanted) {
    for (const auto& value : range) {
        if (value != wanted) {
            return false;
        }
    }
    return true;
}

template <typename Range>
constexpr bool all_zero(const Range& range) {
    return all_are(range, 0);
}

}  // namespace cgw::wire
