// The date that the artefacts carry. Never the clock: the same file gives the same bytes tomorrow.
#pragma once

#include <optional>
#include <string_view>

#include "base/result.hpp"
#include "parameter/settings.hpp"

namespace cgw::driver {

// The file's [document] created, else SOURCE_DATE_EPOCH (seconds since 1970 UTC, years 1970..9999), else
// 2004-05-19, the manual's date. A SOURCE_DATE_EPOCH that is no such number is a failure.
base::Result<parameter::Date> artefact_date(const std::optional<parameter::Date>& created,
                                            const char* source_date_epoch);

}  // namespace cgw::driver
