// The sections of objects and sub-objects.
#include <fmt/format.h>

#include "dictionary/data_types.hpp"
#include "eds/value_text.hpp"
#include "eds/words.hpp"
#include "eds/writing.hpp"

namespace cgw::eds {
namespace {

using dictionary::Object;
using dictionary::Value;
using dictionary::Variable;
using object::ObjectCode;

void code_entry(Printer& out, ObjectCode code) {
    out.entry("ObjectType", fmt::format("0x{:X}", static_cast<unsigned>(code)));
}

void flags_entry(Printer& out, std::uint32_t flags) {
    if (flags != 0) {
        out.entry("ObjFlags", fmt::format("0x{:X}", flags));
    }
}

void stated_entry(Printer& out, std::string_view key, const std::string& text) {
    if (!text.empty()) {
        out.text_entry(key, text);
    }
}

void limit_entry(Printer& out, std::string_view key, const std::optional<Value>& limit,
                 const dictionary::TypeRow& type) {
    if (limit) {
        out.value_entry(key, value_text(*limit, type));
    }
}

void typed_entries(Printer& out, const Variable& variable, ObjectCode code, FileKind kind) {
    out.entry("DataType", fmt::format("0x{:04X}", static_cast<unsigned>(variable.type)));
    if (code != ObjectCode::type_definition) {  // nothing that could be accessed
        out.entry("AccessType", access_types.at(static_cast<std::size_t>(variable.access)));
    }
    variable_entries(out, variable, kind);
}

void object_links(Printer& out, const std::string& name, const std::vector<std::uint16_t>& links) {
    if (!links.empty()) {
        out.section(name + "ObjectLinks");
        index_entries(out, "ObjectLinks", links);
    }
}

}  // namespace

void index_entries(Printer& out, std::string_view count_key, const std::vector<std::uint16_t>& indices) {
    out.number_entry(count_key, indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        out.entry(fmt::format("{}", i + 1), fmt::format("0x{:04X}", indices[i]));
    }
}

void comment_entries(Printer& out, const std::vector<std::string>& lines) {
    out.number_entry("Lines", lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        out.text_entry(fmt::format("Line{}", i + 1), lines[i]);
    }
}

void variable_entries(Printer& out, const Variable& variable, FileKind kind) {
    const dictionary::TypeRow& type = dictionary::row_of(variable.type);
    if (!variable.no_default) {
        out.value_entry("DefaultValue", value_text(variable.default_value, type));
    }
    if (kind == FileKind::configuration && variable.parameter_value) {
        out.value_entry("ParameterValue", value_text(*variable.parameter_value, type));
    }
    out.flag_entry("PDOMapping", variable.pdo_mapping);
    limit_entry(out, "LowLimit", variable.low_limit, type);
    limit_entry(out, "HighLimit", variable.high_limit, type);
    flags_entry(out, variable.flags);
    if (kind == FileKind::configuration) {
        stated_entry(out, "Denotation", variable.denotation);
        stated_entry(out, "UploadFile", variable.upload_file);
        stated_entry(out, "DownloadFile", variable.download_file);
    }
}

void object_sections(Printer& out, const Object& object, FileKind kind, std::string_view prefix) {
    const std::string name = fmt::format("{}{:04X}", prefix, object.index);
    out.section(name);
    out.text_entry("ParameterName", object.name);
    code_entry(out, object.code);
    if (!has_sub_objects(object.code)) {
        for (const Variable& variable : object.variables) {
            typed_entries(out, variable, object.code, kind);
        }
        object_links(out, name, object.object_links);
        return;
    }
    out.number_entry("SubNumber", object.variables.size());
    flags_entry(out, object.flags);
    if (kind == FileKind::configuration) {
        stated_entry(out, "Denotation", object.denotation);
    }
    for (const Variable& variable : object.variables) {
        out.section(fmt::format("{}sub{:X}", name, variable.sub_index));
        out.text_entry("ParameterName", variable.name);
        code_entry(out, ObjectCode::var);
        typed_entries(out, variable, ObjectCode::var, kind);
    }
    object_links(out, name, object.object_links);
}

}  // namespace cgw::eds
