#include "eds_check/dates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/numbers.hpp"

namespace cgw::eds_check {
namespace {

constexpr std::array<std::string_view, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                  "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

// Of one to `most` digits.
std::optional<unsigned> digits_of(std::string_view text, std::size_t most) {
    if (text.size() > most || !base::consists_of(text, base::digits)) {
        return std::nullopt;
    }
    return static_cast<unsigned>(base::parse_integer(text).value_or(0));
}

unsigned days_of(unsigned month, unsigned year) {
    constexpr std::array<unsigned, 12> days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return month == 2 && leap ? 29 : days[month - 1];
}

struct Parts {
    std::string_view first;
    std::string_view second;
    std::string_view third;
};

std::optional<Parts> split(std::string_view text) {
    const std::size_t one = text.find('-');
    const std::size_t two = one != std::string_view::npos ? text.find('-', one + 1) : one;
    if (two == std::string_view::npos) {
        return std::nullopt;
    }
    return Parts{text.substr(0, one), text.substr(one + 1, two - one - 1), text.substr(two + 1)};
}

bool is_day(unsigned day, unsigned month, unsigned year) {
    return month >= 1 && month <= 12 && day >= 1 && day <= days_of(month, year);
}

}  // namespace

bool is_date(std::string_view text) {
    const auto parts = split(text);
    if (!parts || parts->first.size() != 2 || parts->second.size() != 2 || parts->third.size() != 4) {
        return false;
    }
    const auto month = digits_of(parts->first, 2);
    const auto day = digits_of(parts->second, 2);
    const auto year = digits_of(parts->third, 4);
    return month && day && year && is_day(*day, *month, *year);
}

bool is_time(std::string_view text) {
    const bool shaped = text.size() == 7 && text[2] == ':' && (text.ends_with("AM") || text.ends_with("PM"));
    const auto hours = shaped ? digits_of(text.substr(0, 2), 2) : std::nullopt;
    const auto minutes = shaped ? digits_of(text.substr(3, 2), 2) : std::nullopt;
    return hours && minutes && *hours >= 1 && *hours <= 12 && *minutes <= 59;
}

std::optional<std::string> as_date(std::string_view text) {
    const auto parts = split(text);
    if (!parts) {
        return std::nullopt;
    }
    const auto* const month = std::find_if(months.begin(), months.end(), [&](std::string_view each) {
        return each.size() == parts->second.size() && base::equal_ignoring_case(each, parts->second);
    });
    const auto day = digits_of(parts->first, 2);
    const auto year = parts->third.size() == 4 ? digits_of(parts->third, 4) : std::nullopt;
    const auto number = static_cast<unsigned>(month - months.begin()) + 1;
    if (month == months.end() || !day || !year || !is_day(*day, number, *year)) {
        return std::nullopt;
    }
    return fmt::format("{:02}-{:02}-{:04}", number, *day, *year);
}

std::optional<std::string> as_time(std::string_view text) {
    const std::string half = base::lowered(text.substr(text.size() - std::min<std::size_t>(text.size(), 2)));
    const bool stated = half == "am" || half == "pm";
    const std::string_view clock = base::trimmed(stated ? text.substr(0, text.size() - 2) : text);
    const std::size_t colon = clock.find(':');
    if (colon == std::string_view::npos || clock.size() - colon != 3) {
        return std::nullopt;
    }
    const auto hours = digits_of(clock.substr(0, colon), 2);
    const auto minutes = digits_of(clock.substr(colon + 1), 2);
    if (!hours || !minutes || *hours > 23 || *minutes > 59 || (half == "am" && *hours > 12) ||
        (half == "pm" && *hours == 0)) {
        return std::nullopt;
    }
    const bool afternoon = half == "pm" || (!stated && *hours >= 12);
    const unsigned of_twelve = *hours % 12 == 0 ? 12 : *hours % 12;
    return fmt::format("{:02}:{:02}{}", of_twelve, *minutes, afternoon ? "PM" : "AM");
}

}  // namespace cgw::eds_check
