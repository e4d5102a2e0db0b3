#include "driver/dates.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/numbers.hpp"

namespace cgw::driver {

base::Result<parameter::Date> artefact_date(const std::optional<parameter::Date>& created,
                                            const char* source_date_epoch) {
    constexpr std::int64_t last_second = 253402300799;  // 9999-12-31 23:59:59
    if (created) {
        return *created;
    }
    if (source_date_epoch == nullptr || *source_date_epoch == '\0') {
        return parameter::Date{};
    }
    const std::optional<std::int64_t> seconds = base::parse_integer(source_date_epoch);
    if (!seconds || *seconds < 0 || *seconds > last_second) {
        return base::failure(fmt::format("SOURCE_DATE_EPOCH is '{}', not a number of seconds from 0 to {}",
                                         source_date_epoch, last_second));
    }
    const std::chrono::sys_seconds time{std::chrono::seconds(*seconds)};
    const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(time)};
    return parameter::Date{static_cast<int>(day.year()), static_cast<int>(static_cast<unsigned>(day.month())),
                           static_cast<int>(static_cast<unsigned>(day.day()))};
}

}  // namespace cgw::driver
