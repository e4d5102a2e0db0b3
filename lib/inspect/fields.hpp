// The configuration image as ONE table: every field of every record, with what its values mean. Offsets are
// those of image/layout.hpp. `cgw image annotate`, schemas/config-image.ksy and the tables of
// docs/image-format.md are made from it.
//
// The ranges are the verifier's (image/section_rules.cpp, which firmware carries and which is therefore kept
// apart and small); a test puts a value beyond each range into an image and sees it refused.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/layout.hpp"

namespace cgw::inspect {

// Numbers are little-endian; f64 is IEEE 754. `count` of `bytes` and `text` is their size.
enum class Type : std::uint8_t { u8, u16, u32, f64, bytes, text };

std::size_t size_of(Type type);       // 1, 2, 4, 8, 1, 1
std::string_view name_of(Type type);  // "u8", …

// How a value is written for people; what it means is then told besides.
enum class Shown : std::uint8_t {
    decimal,
    hexadecimal,
    identifier,    // a COB-ID
    object_index,  // 2001h
    mapping,       // index << 16 | sub-index << 8 | bits
    microseconds,
    word,       // two's complement when the signal is signed
    parameter,  // the number of a parameter; its label is its meaning
    reserved,   // 0 in this minor
};

struct NamedValue {
    std::uint32_t value = 0;
    std::string_view name{};  // "transmit"; "" for a number that speaks for itself
    std::string_view id{};    // for schemas and headers: "transmit", an identifier; "" where there is no name
};

struct Range {
    std::uint32_t minimum = 0;
    std::uint32_t maximum = 0;
};

// Numbers stand alone or `count` times in a row (then `elements` may name them).
struct Field {
    std::string_view name;
    std::size_t offset = 0;  // from the record's first byte
    Type type = Type::u8;
    std::string_view meaning{};  // in a few words
    std::string_view note{};     // conditions, which go on behind the meaning and the range
    std::string_view source{};   // the parameters that it comes from: "401 / 427"
    std::size_t count = 1;
    Shown shown = Shown::decimal;
    std::optional<Range> range{};             // that every image of this minor keeps
    std::span<const NamedValue> values{};     // all that it may have
    std::uint32_t values_mask = 0xFFFF'FFFF;  // of the bits that `values` are about
    std::span<const NamedValue> bits{};       // of the other bits, those with a meaning
    std::span<const std::string_view> elements{};

    std::size_t size() const { return count * size_of(type); }
    bool is_flag() const { return range && range->minimum == 0 && range->maximum == 1; }
};

// Header, directory entry and trailer are records as those of the sections are.
struct Record {
    std::string_view name;            // as the page calls it: "header", "pdos"
    image::SectionId section{};       // 0: it is none
    std::size_t size = 0;             // bytes; 1 for sections of plain bytes
    std::span<const Field> fields{};  // without gaps; none for plain bytes
    std::size_t count = 0;            // records in every image; 0: any number
    std::string_view count_text{};    // "20", "1 or more", "any"
    bool required = true;
    std::string_view about{};    // what the section holds, one line
    Type content = Type::bytes;  // of plain bytes: bytes or text

    bool is_section() const { return section != image::SectionId{}; }
};

std::span<const Record> all_records();  // header, directory, sections by id, trailer

const Record& header();
const Record& directory();
const Record& trailer();
const Record* find_record(std::uint16_t section_id);  // nullptr: this minor has no such section

// "1..31", "0 transmit, 1 receive", "1 mappable into a PDO, 2 …"; "" when there is nothing to say.
std::string values_text(const Field& field);

// Meaning, values, note and source parameters in one line, as page and schema print it.
std::string full_text(const Field& field);

// "u16", "6 × u8", "32 bytes"
std::string type_text(const Field& field);

}  // namespace cgw::inspect
