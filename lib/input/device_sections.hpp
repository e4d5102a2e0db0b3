// Inside the input room: [governor] and [gateway] with all below them, but for the parameters themselves.
#pragma once

#include "input/table_reader.hpp"

namespace cgw::input {

extern const Table governor_table;
extern const Table gateway_table;

// Parameters are read when every catalogue is.
void keep_governor_parameters(Context& context, const toml::Entry& entry);
void keep_gateway_parameters(Context& context, const toml::Entry& entry);

// Of an integer whose limits hold.
inline std::uint32_t unsigned_of(const toml::Entry& entry) {
    return static_cast<std::uint32_t>(entry.value.integer);
}

}  // namespace cgw::input
