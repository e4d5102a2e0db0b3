// docs/image-format.md against image/layout.hpp: every field of every record, both ways.
//
// The page's tables have a heading "### name …" and rows "| offset | field | type | meaning |".
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>

#include "image/image.hpp"

namespace cgw::image {
namespace {

struct Field {
    std::size_t offset = 0;
    std::string name;
    std::size_t size = 0;

    friend bool operator==(const Field&, const Field&) = default;
};

void PrintTo(const Field& field, std::ostream* out) {
    *out << field.offset << " " << field.name << " (" << field.size << " bytes)";
}

using Tables = std::map<std::string, std::vector<Field>>;

// "u8", "4 × u16", "f64", "32 bytes"
std::size_t size_of_type(const std::string& type) {
    static const std::regex form(R"((?:(\d+) × )?[uif](8|16|32|64)|(\d+) bytes?)");
    std::smatch match;
    if (!std::regex_match(type, match, form)) {
        ADD_FAILURE() << "type not understood: " << type;
        return 0;
    }
    if (match[3].matched) {
        return std::stoul(match[3]);
    }
    return (match[1].matched ? std::stoul(match[1]) : 1) * std::stoul(match[2]) / 8;
}

Tables documented() {
    std::ifstream page(CGW_IMAGE_DOCUMENT);
    EXPECT_TRUE(page.is_open()) << CGW_IMAGE_DOCUMENT;
    static const std::regex heading(R"(^### `(\w+)`.*)");
    static const std::regex row(R"(^\| (\d+) \| (\w+) \| ([^|]+) \|.*)");
    Tables tables;
    std::string section;
    std::string line;
    std::smatch match;
    while (std::getline(page, line)) {
        if (std::regex_match(line, match, heading)) {
            section = match[1];
        } else if (line.starts_with("#")) {
            section.clear();
        } else if (!section.empty() && std::regex_match(line, match, row)) {
            tables[section].push_back({std::stoul(match[1]), match[2], size_of_type(match[3])});
        }
    }
    return tables;
}

const Tables& laid_out() {
    static const Tables tables = {
        {"header",
         {{header::magic, "magic", sizeof magic},
          {header::format_major, "format_major", 2},
          {header::format_minor, "format_minor", 2},
          {header::header_size, "header_size", 2},
          {header::section_count, "section_count", 2},
          {header::total_size, "total_size", 4},
          {header::configuration_id, "configuration_id", header::configuration_id_size},
          {header::tool_version, "tool_version", 6},
          {header::reserved, "reserved", header::size - header::reserved}}},
        {"directory",
         {{directory::id, "id", 2},
          {directory::record_size, "record_size", 2},
          {directory::offset, "offset", 4},
          {directory::size, "size", 4}}},
        {"identity",
         {{identity::vendor, "vendor", 4},
          {identity::product, "product", 4},
          {identity::revision, "revision", 4},
          {identity::serial, "serial", 4}}},
        {"buses",
         {{bus::own_node, "own_node", 1},
          {bus::peer_node, "peer_node", 1},
          {bus::manual_timing, "manual_timing", 1},
          {bus::reserved, "reserved", 1},
          {bus::bit_rate_kbit, "bit_rate_kbit", 2},
          {bus::registers, "registers", 6},
          {bus::start_up_delay_ms, "start_up_delay_ms", 4}}},
        {"governor",
         {{governor::own_node, "own_node", 1},
          {governor::gateway_node, "gateway_node", 1},
          {governor::manual_timing, "manual_timing", 1},
          {governor::send_errors, "send_errors", 1},
          {governor::bit_rate_kbit, "bit_rate_kbit", 2},
          {governor::registers, "registers", 5},
          {governor::reserved, "reserved", 1},
          {governor::start_up_delay_ms, "start_up_delay_ms", 4},
          {governor::main_cycle_us, "main_cycle_us", 4},
          {governor::send_status, "send_status", 1},
          {governor::reserved_2, "reserved", 3}}},
        {"heartbeat",
         {{heartbeat::producer_us, "producer_us", 4},
          {heartbeat::consumer_us, "consumer_us", 4},
          {heartbeat::consumer_node, "consumer_node", 1},
          {heartbeat::reserved, "reserved", 3}}},
        {"pdos",
         {{pdo::direction, "direction", 1},
          {pdo::number, "number", 1},
          {pdo::active, "active", 1},
          {pdo::cob_id_source, "cob_id_source", 1},
          {pdo::cob_id, "cob_id", 2},
          {pdo::word_count, "word_count", 1},
          {pdo::transmission_type, "transmission_type", 1},
          {pdo::effective_us, "effective_us", 4},
          {pdo::asked_ms, "asked_ms", 2},
          {pdo::cycles, "cycles", 2},
          {pdo::mapping, "mapping", 16},
          {pdo::parameters, "parameters", 8}}},
        {"objects",  // object/object_table.hpp; ObjectRecord.stands_byte_by_byte_as_documented holds the code
                     // to it
         {{0, "index", 2},
          {2, "sub_index", 1},
          {3, "type", 1},
          {4, "rights", 1},
          {5, "handler", 1},
          {6, "offset", 2}}},
        {"switches",
         {{switch_function::number, "number", 2},
          {switch_function::bit, "bit", 1},
          {switch_function::low_active, "low_active", 1}}},
        {"sensors",
         {{sensor::number, "number", 2}, {sensor::channel, "channel", 1}, {sensor::reserved, "reserved", 1}}},
        {"signals",
         {{signal::number, "number", 2},
          {signal::width, "width", 1},
          {signal::is_signed, "is_signed", 1},
          {signal::internal_minimum, "internal_minimum", 2},
          {signal::internal_maximum, "internal_maximum", 2}}},
        {"labels",
         {{label::number, "number", 2},
          {label::name_length, "name_length", 1},
          {label::unit_length, "unit_length", 1},
          {label::name_offset, "name_offset", 4},
          {label::unit_offset, "unit_offset", 4},
          {label::has_scaling, "has_scaling", 1},
          {label::reserved, "reserved", 3},
          {label::external_minimum, "external_minimum", 8},
          {label::external_maximum, "external_maximum", 8}}},
    };
    return tables;
}

// name, size, id as the page's section table must have them; id 0: not a section.
struct RecordSize {
    const char* table;
    std::size_t size;
    unsigned id;
};

constexpr RecordSize record_sizes[] = {
    {"header", header::size, 0},     {"directory", directory::entry_size, 0},
    {"identity", identity::size, 1}, {"buses", bus::size, 2},
    {"governor", governor::size, 3}, {"heartbeat", heartbeat::size, 4},
    {"pdos", pdo::size, 5},          {"objects", object::object_record_size, 6},
    {"object_values", 1, 7},         {"switches", switch_function::size, 8},
    {"sensors", sensor::size, 9},    {"signals", signal::size, 10},
    {"labels", label::size, 11},     {"strings", 1, 12},
};

std::string page_text() {
    std::ifstream page(CGW_IMAGE_DOCUMENT);
    return {std::istreambuf_iterator<char>(page), {}};
}

TEST(ImageDocument, has_the_fields_of_the_layout_and_no_others) {
    const Tables found = documented();
    EXPECT_EQ(found.size(), laid_out().size());
    for (const auto& [name, fields] : laid_out()) {
        const auto table = found.find(name);
        ASSERT_NE(table, found.end()) << "no table for " << name;
        EXPECT_EQ(table->second, fields) << name;
    }
}

TEST(ImageDocument, leaves_no_byte_of_a_record_untold) {
    for (const RecordSize& record : record_sizes) {
        const auto table = laid_out().find(record.table);
        if (table == laid_out().end()) {
            continue;
        }
        std::size_t next = 0;
        for (const Field& field : table->second) {
            EXPECT_EQ(field.offset, next) << record.table << " " << field.name;
            next = field.offset + field.size;
        }
        EXPECT_EQ(next, record.size) << record.table;
    }
}

TEST(ImageDocument, lists_every_section_with_its_record_size) {
    const std::string text = page_text();
    for (const RecordSize& record : record_sizes) {
        if (record.id != 0) {
            const std::string row = "| " + std::to_string(record.id) + " | `" + record.table + "` | " +
                                    std::to_string(record.size) + " |";
            EXPECT_NE(text.find(row), std::string::npos) << row;
        }
    }
}

TEST(ImageDocument, lists_every_refusal_code_with_its_text) {
    const std::string text = page_text();
    for (unsigned code = 0; code <= 13; ++code) {
        const std::string row =
            "| " + std::to_string(code) + " | " + std::string(to_text(static_cast<Status>(code))) + " |";
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
}

TEST(ImageDocument, states_the_sizes_and_versions_of_the_layout) {
    const std::string text = page_text();
    EXPECT_NE(text.find("format " + std::to_string(format_major) + "." + std::to_string(format_minor)),
              std::string::npos);
    EXPECT_NE(text.find(std::to_string(minimum_size) + " to " + std::to_string(maximum_size) + " bytes"),
              std::string::npos);
}

}  // namespace
}  // namespace cgw::image
