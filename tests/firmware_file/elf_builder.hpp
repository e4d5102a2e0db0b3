// A small ELF program made for tests, of either class and byte order: one segment of 4096 bytes from
// 0x08000000 with the sections .text (256 bytes), .cgw_config (3840 bytes, 0xFF) and .twin (inside .text),
// then .bss, .comment and .zipped, and .shstrtab at the end.
#pragma once

#include <algorithm>
#include <string>

#include "base/bytes.hpp"

namespace cgw::test {

struct ElfBuilder {
    bool wide = false;  // 64 bits
    bool big = false;   // big-endian

    static constexpr std::uint64_t address = 0x08000000, config = 0x08000100;
    static constexpr std::size_t segment_offset = 0x200, segment_size = 0x1000, text_size = 0x100;

    std::size_t word() const { return wide ? 8 : 4; }
    std::size_t header_size() const { return wide ? 64 : 52; }
    std::size_t section_size() const { return wide ? 64 : 40; }
    std::size_t names_offset() const { return segment_offset + segment_size; }
    std::size_t sections_offset() const { return names_offset() + 0x80; }

    void put(base::Bytes& bytes, std::uint64_t value, std::size_t width) const {
        for (std::size_t i = 0; i < width; ++i) {
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * (big ? width - 1 - i : i))));
        }
    }
    // Over bytes that are there.
    void set(base::Bytes& bytes, std::size_t at, std::uint64_t value, std::size_t width) const {
        base::Bytes number;
        put(number, value, width);
        std::copy(number.begin(), number.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
    }

    base::Bytes header() const {
        base::Bytes bytes{0x7F,
                          'E',
                          'L',
                          'F',
                          static_cast<std::uint8_t>(wide ? 2 : 1),
                          static_cast<std::uint8_t>(big ? 2 : 1),
                          1};
        bytes.resize(16);
        put(bytes, 2, 2);   // executable
        put(bytes, 40, 2);  // ARM
        put(bytes, 1, 4);
        put(bytes, address, word());
        put(bytes, header_size(), word());
        put(bytes, sections_offset(), word());
        put(bytes, 0, 4);
        put(bytes, header_size(), 2);
        put(bytes, wide ? 56 : 32, 2);
        put(bytes, 1, 2);
        put(bytes, section_size(), 2);
        put(bytes, 8, 2);
        put(bytes, 7, 2);
        return bytes;
    }

    void segment(base::Bytes& bytes) const {
        put(bytes, 1, 4);
        if (wide) {
            put(bytes, 5, 4);
        }
        put(bytes, segment_offset, word());
        put(bytes, address, word());
        put(bytes, address, word());
        put(bytes, segment_size, word());
        put(bytes, segment_size + 64, word());
        if (!wide) {
            put(bytes, 5, 4);
        }
        put(bytes, 8, word());
    }

    void section(base::Bytes& bytes, std::size_t name, std::uint32_t type, std::uint64_t flags,
                 std::uint64_t at, std::uint64_t offset, std::uint64_t size) const {
        put(bytes, name, 4);
        put(bytes, type, 4);
        put(bytes, flags, word());
        put(bytes, at, word());
        put(bytes, offset, word());
        put(bytes, size, word());
        put(bytes, 0, 8);
        put(bytes, 8, word());
        put(bytes, 0, word());
    }

    base::Bytes build() const {
        base::Bytes bytes = header();
        segment(bytes);
        bytes.resize(segment_offset);
        bytes.resize(segment_offset + text_size, 0x4B);
        bytes.resize(segment_offset + segment_size, 0xFF);
        const std::string names("\0.text\0.cgw_config\0.twin\0.bss\0.comment\0.zipped\0.shstrtab\0", 57);
        bytes.insert(bytes.end(), names.begin(), names.end());
        bytes.resize(sections_offset());
        const auto name = [&names](const char* text) { return names.find(text); };
        section(bytes, 0, 0, 0, 0, 0, 0);
        section(bytes, name(".text"), 1, 6, address, segment_offset, text_size);
        section(bytes, name(".cgw_config"), 1, 2, config, segment_offset + text_size,
                segment_size - text_size);
        section(bytes, name(".twin"), 1, 2, address + 8, segment_offset + 8, 16);
        section(bytes, name(".bss"), 8, 3, address + segment_size, segment_offset + segment_size, 64);
        section(bytes, name(".comment"), 1, 0, 0, segment_offset, 16);
        section(bytes, name(".zipped"), 1, 0x802, address, segment_offset, 16);
        section(bytes, name(".shstrtab"), 3, 0, 0, names_offset(), names.size());
        return bytes;
    }
};

}  // namespace cgw::test
