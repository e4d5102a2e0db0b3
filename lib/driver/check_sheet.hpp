// An EDS or DCF from its path to all findings about it, or to a repaired text.
#pragma once

#include <string>

#include "base/result.hpp"
#include "driver/data_sheet.hpp"
#include "eds_check/checks.hpp"
#include "eds_check/fix.hpp"

namespace cgw::driver {

// As read_data_sheet(), and every check of lib/eds_check. Without a file name in the options the one of the
// path counts; of standard input ("-") none is known.
DataSheet check_data_sheet(const std::string& path, eds_check::Options options);

// The same for a text that is or will be the file `path`.
DataSheet check_data_sheet_text(const std::string& path, std::string text, eds_check::Options options);

// How many repairs `cgw eds fix` would make in a file that was checked.
std::size_t count_repairs(const DataSheet& file);

}  // namespace cgw::driver
