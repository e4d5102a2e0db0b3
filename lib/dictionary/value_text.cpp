#include "dictionary/value_text.hpp"

#include <fmt/format.h>

#include <bit>

#include "base/canopen_text.hpp"
#include "base/utf8.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/words.hpp"

namespace cgw::dictionary {
namespace {

constexpr std::size_t longest_bytes = 24;  // of octets and domains

std::uint64_t masked(std::uint64_t number, unsigned bits) {
    return bits < 64 ? number & ((std::uint64_t{1} << bits) - 1) : number;
}

std::string signed_text(std::uint64_t number, unsigned bits) {
    const std::uint64_t kept = masked(number, bits);
    const bool negative = (kept >> (bits - 1U) & 1U) != 0;
    const std::uint64_t extension = bits < 64 && negative ? ~std::uint64_t{0} << bits : 0;
    return fmt::format("{}", static_cast<std::int64_t>(kept | extension));
}

// Counts and times are small types, identifiers and bit fields large ones.
std::string natural_text(std::uint64_t number, unsigned bits) {
    constexpr unsigned widest_count = 16;
    if (bits > widest_count) {
        return fmt::format("0x{:0{}X}", number, bits / 4);
    }
    return number < 10 ? fmt::format("{}", number) : fmt::format("{} (0x{:X})", number, number);
}

std::string octets_text(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes.substr(0, longest_bytes)) {
        text += fmt::format("{}{:02X}", text.empty() ? "" : " ", static_cast<unsigned char>(byte));
    }
    if (bytes.size() > longest_bytes) {
        text += fmt::format(" … ({} bytes)", bytes.size());
    }
    return text.empty() ? "no bytes" : text;
}

std::string real_text(std::uint64_t number, unsigned bits) {
    return bits == 32 ? fmt::format("{}", std::bit_cast<float>(static_cast<std::uint32_t>(number)))
                      : fmt::format("{}", std::bit_cast<double>(number));
}

}  // namespace

std::string value_text(object::DataType type, const Value& value) {
    const TypeRow& row = row_of(type);
    if (value.node_id_relative) {
        return fmt::format("$NODEID+0x{:X}", value.number);
    }
    switch (row.kind) {
        case TypeKind::boolean:
            return value.number != 0 ? "true" : "false";
        case TypeKind::integer:
            return signed_text(value.number, row.bits);
        case TypeKind::natural:
            return natural_text(masked(value.number, row.bits), row.bits);
        case TypeKind::time:
            return fmt::format("0x{:0{}X}", masked(value.number, row.bits), row.bits / 4);
        case TypeKind::real:
            return real_text(value.number, row.bits);
        case TypeKind::visible_string:
            return fmt::format("\"{}\"", base::printable(value.bytes));
        case TypeKind::octet_string:
        case TypeKind::unicode_string:
        case TypeKind::domain:
        case TypeKind::structure:
            break;
    }
    return octets_text(value.bytes);
}

std::string mapping_text(std::uint32_t entry) {
    if (entry == 0) {
        return "nothing";
    }
    const unsigned bits = entry & 0xFFU;
    return fmt::format("{}, {} bit{}", base::object_text(entry >> 16U, entry >> 8U & 0xFFU), bits,
                       bits == 1 ? "" : "s");
}

bool is_mapping_entry(std::uint16_t index, std::uint8_t sub_index) {
    const bool mapping = (index >= 0x1600 && index <= 0x17FF) || (index >= 0x1A00 && index <= 0x1BFF);
    return mapping && sub_index > 0 && sub_index <= 0x40;
}

std::string_view access_text(object::Access access) {
    return access_types[static_cast<std::size_t>(access)];
}

std::string_view object_code_text(object::ObjectCode code) {
    for (const ObjectCodeName& row : object_codes) {
        if (row.code == code) {
            return row.name;
        }
    }
    return "";
}

}  // namespace cgw::dictionary
