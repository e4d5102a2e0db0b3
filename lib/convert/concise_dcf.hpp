// What a CANopen manager writes into one node when it boots: the concise DCF of CiA 302-3, which stands in
// its object 1F22h, a sub-index for each node.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.hpp"
#include "dictionary/dictionary.hpp"

namespace cgw::convert {

struct Download {
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    base::Bytes data;  // as on the wire, little-endian

    friend bool operator==(const Download&, const Download&) = default;
};

// Every object that can be written, and whose value in the configuration is another than its default, or has
// no default to compare with; ascending, and not those whose ObjFlags forbid a download.
//
// A PDO is set up in the order of CiA 301 (7.5.2.36): switched off (bit 31 of its COB-ID), its mapping
// emptied, mapped objects, their number, its other parameters, and switched on again if it is to be on.
std::vector<Download> downloads(const dictionary::Dictionary& configuration, std::uint8_t node_id);

// Number of entries, then each as index, sub-index, number of bytes and bytes: u32, then u16, u8, u32.
base::Bytes concise_dcf(const std::vector<Download>& downloads);
bool is_without_entries(const base::Bytes& concise_dcf);

}  // namespace cgw::convert
