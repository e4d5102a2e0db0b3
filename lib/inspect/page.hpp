// The tables of docs/image-format.md, made from the table of fields.
#pragma once

#include <string>
#include <string_view>

namespace cgw::inspect {

// `page` with the first table below each heading "### `record`" and below "## Sections" made again; what
// stands around the tables is left alone.
std::string with_tables(std::string_view page);

}  // namespace cgw::inspect
