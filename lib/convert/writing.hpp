// Inside the convert room: the formats that are not meant to be read back.
#pragma once

#include "base/bytes.hpp"
#include "convert/description.hpp"

namespace cgw::convert {

base::Bytes write_json(const Description& description);      // write_json.cpp
base::Bytes write_markdown(const Description& description);  // write_tables.cpp
base::Bytes write_csv(const Description& description);

}  // namespace cgw::convert
