#include "inspect/kaitai.hpp"

#include <fmt/format.h>

#include "inspect/fields.hpp"

namespace cgw::inspect {
namespace {

// In quotes as YAML has them: only backslash and quote need care in our texts.
std::string quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char character : text) {
        quoted += character == '"' || character == '\\' ? "\\" : "";
        quoted += character;
    }
    return quoted + '"';
}

std::string_view type_name(Type type) {
    switch (type) {
        case Type::u8:
            return "u1";
        case Type::u16:
            return "u2";
        case Type::u32:
            return "u4";
        case Type::f64:
            return "f8";
        default:
            return "";
    }
}

bool has_enum(const Field& field) {
    return field.bits.empty() && !field.values.empty() && !field.values.front().id.empty();
}

std::string enum_name(const Record& record, const Field& field) {
    return fmt::format("{}_{}", record.name, field.name);
}

std::string field_text(const Record& record, const Field& field) {
    std::string text = fmt::format("      - id: {}\n", field.name);
    if (record.name == "header" && field.name == "magic") {
        text += "        contents: CGWI\n";
    } else if (field.type == Type::bytes || field.type == Type::text) {
        text += fmt::format("        size: {}\n", field.count);
    } else {
        text += fmt::format("        type: {}\n", type_name(field.type));
        if (has_enum(field)) {
            text += fmt::format("        enum: {}\n", enum_name(record, field));
        }
        if (field.count != 1) {
            text += fmt::format("        repeat: expr\n        repeat-expr: {}\n", field.count);
        }
    }
    const std::string doc = full_text(field);
    return text + (doc.empty() ? "" : fmt::format("        doc: {}\n", quoted(doc)));
}

// "record_pdos": what one record of the section is.
std::string record_type(const Record& record) {
    std::string text = fmt::format("  record_{}:\n", record.name);
    text += record.about.empty() ? "" : fmt::format("    doc: {}\n", quoted(record.about));
    text += "    seq:\n";
    for (const Field& field : record.fields) {
        text += field_text(record, field);
    }
    return text;
}

// "section_pdos": all of them; a later minor may lengthen each at its end.
std::string section_type(const Record& record) {
    return fmt::format(
        "  section_{0}:\n"
        "    params:\n"
        "      - id: record_size\n"
        "        type: u2\n"
        "    seq:\n"
        "      - id: records\n"
        "        size: record_size\n"
        "        type: record_{0}\n"
        "        repeat: eos\n",
        record.name);
}

std::string enums() {
    std::string text = "enums:\n  section_id:\n";
    for (const Record& record : all_records()) {
        if (record.is_section()) {
            text += fmt::format("    {}: {}\n", static_cast<unsigned>(record.section), record.name);
        }
    }
    for (const Record& record : all_records()) {
        for (const Field& field : record.fields) {
            if (!has_enum(field)) {
                continue;
            }
            text += fmt::format("  {}:\n", enum_name(record, field));
            for (const NamedValue& value : field.values) {
                text += fmt::format("    {}: {}\n", value.value, value.id);
            }
        }
    }
    return text;
}

// The directory's entry with the section it points to.
std::string entry_type() {
    std::string text = record_type(directory());
    text +=
        "    instances:\n"
        "      content:\n"
        "        io: _root._io\n"
        "        pos: offset\n"
        "        size: size\n"
        "        type:\n"
        "          switch-on: id\n"
        "          cases:\n";
    for (const Record& record : all_records()) {
        if (!record.is_section()) {
            continue;
        }
        const std::string type = record.fields.empty()
                                     ? std::string(record.content == Type::text ? "text" : "")
                                     : fmt::format("section_{}(record_size)", record.name);
        if (!type.empty()) {
            text += fmt::format("            {}: {}\n", static_cast<unsigned>(record.section), type);
        }
    }
    return text;
}

}  // namespace

std::string kaitai_specification() {
    std::string text =
        "# The configuration image of cgw as a Kaitai Struct specification. Made from "
        "lib/inspect/fields.cpp; changes\n"
        "# here are lost (CGW_UPDATE_GOLDEN=1 ./test -R inspect makes it again). docs/image-format.md tells "
        "the same in\n"
        "# prose. It takes sound images apart and verifies none: CRC-32, order and ranges are for a reader "
        "to check.\n"
        "meta:\n"
        "  id: config_image\n"
        "  title: Configuration image of a CANopen gateway\n"
        "  file-extension: bin\n"
        "  endian: le\n";
    text += fmt::format("doc: \"Format {}.{}.\"\n", image::format_major, image::format_minor);
    text +=
        "seq:\n"
        "  - id: header\n"
        "    type: record_header\n"
        "  - id: more_header\n"
        "    size: header.header_size - 64\n"
        "    doc: \"of a later minor\"\n"
        "  - id: directory\n"
        "    type: record_directory\n"
        "    repeat: expr\n"
        "    repeat-expr: header.section_count\n"
        "instances:\n"
        "  trailer:\n"
        "    pos: header.total_size - 4\n"
        "    type: record_trailer\n"
        "types:\n";
    for (const Record& record : all_records()) {
        if (&record == &directory()) {
            text += entry_type();
        } else if (!record.fields.empty()) {
            text += record_type(record) + (record.is_section() ? section_type(record) : "");
        }
    }
    text +=
        "  text:\n"
        "    seq:\n"
        "      - id: text\n"
        "        type: str\n"
        "        encoding: UTF-8\n"
        "        size-eos: true\n";
    return text + enums();
}

}  // namespace cgw::inspect
