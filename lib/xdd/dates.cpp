#include "xdd/dates.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/ascii.hpp"
#include "xdd/words.hpp"

namespace cgw::xdd {
namespace {

// The number that the first `digits` characters are; they are taken away.
std::optional<unsigned> take_number(std::string_view& text, std::size_t digits) {
    const std::string_view number = text.substr(0, digits);
    if (number.size() != digits || !base::consists_of(number, base::digits)) {
        return std::nullopt;
    }
    unsigned result = 0;
    for (const char c : number) {
        result = result * 10 + static_cast<unsigned>(c - '0');
    }
    text.remove_prefix(digits);
    return result;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) {
        return false;
    }
    text.remove_prefix(1);
    return true;
}

struct Pair {
    unsigned first = 0;
    unsigned second = 0;
};

// Two numbers of two digits each; both are taken away.
std::optional<Pair> take_pair(std::string_view& text, char between) {
    const auto first = take_number(text, 2);
    const bool divided = first && take(text, between);
    const auto second = divided ? take_number(text, 2) : std::nullopt;
    return second ? std::optional(Pair{*first, *second}) : std::nullopt;
}

bool is_date(const Pair& month_and_day) {
    return month_and_day.first >= 1 && month_and_day.first <= 12 && month_and_day.second >= 1 &&
           month_and_day.second <= 31;
}

}  // namespace

std::string xml_date(std::string_view eds_date) {
    const auto month_and_day = take_pair(eds_date, '-');
    if (!month_and_day || !is_date(*month_and_day) || !take(eds_date, '-')) {
        return "";
    }
    const auto year = take_number(eds_date, 4);
    return year && eds_date.empty()
               ? fmt::format("{:04}-{:02}-{:02}", *year, month_and_day->first, month_and_day->second)
               : "";
}

std::string xml_time(std::string_view eds_time) {
    const auto time = take_pair(eds_time, ':');
    const bool is_afternoon = base::equal_ignoring_case(eds_time, "PM");
    if (!time || (!is_afternoon && !base::equal_ignoring_case(eds_time, "AM")) || time->first < 1 ||
        time->first > 12 || time->second > 59) {
        return "";
    }
    return fmt::format("{:02}:{:02}:00", time->first % 12 + (is_afternoon ? 12 : 0), time->second);
}

std::string eds_date(std::string_view xml_date) {
    if (xml_date.starts_with(no_date)) {
        return "";
    }
    const auto year = take_number(xml_date, 4);
    const bool divided = year && take(xml_date, '-');
    const auto month_and_day = divided ? take_pair(xml_date, '-') : std::nullopt;
    return month_and_day && is_date(*month_and_day)
               ? fmt::format("{:02}-{:02}-{:04}", month_and_day->first, month_and_day->second, *year)
               : "";
}

std::string eds_time(std::string_view xml_time) {
    const auto time = take_pair(xml_time, ':');
    if (!time || time->first > 23 || time->second > 59) {
        return "";
    }
    const unsigned hour = time->first % 12 == 0 ? 12 : time->first % 12;
    return fmt::format("{:02}:{:02}{}", hour, time->second, time->first >= 12 ? "PM" : "AM");
}

}  // namespace cgw::xdd
