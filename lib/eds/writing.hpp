// Inside the eds room: the parts of the writer, each in the file of its name.
#pragma once

#include <string_view>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "eds/printer.hpp"

namespace cgw::eds {

// What a file is to say beyond a data sheet: values, denotations and files of one node.
enum class FileKind : bool { data_sheet, configuration };

// NrOfEntries or another count, then `1=0x1000` and so on.
void index_entries(Printer& out, std::string_view count_key, const std::vector<std::uint16_t>& indices);

// Lines, then `Line1=...` and so on.
void comment_entries(Printer& out, const std::vector<std::string>& lines);

// [1018], [1018sub0] and so on; of a module their names begin with `prefix`.
void object_sections(Printer& out, const dictionary::Object& object, FileKind kind,
                     std::string_view prefix = "");  // write_objects.cpp
// All keys of a variable but its name and object code.
void variable_entries(Printer& out, const dictionary::Variable& variable, FileKind kind);

void modules(Printer& out, const std::vector<dictionary::Module>& all);  // write_modules.cpp

}  // namespace cgw::eds
