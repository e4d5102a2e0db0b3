// Files by pattern, for programs that are given `'plants/**/*.toml'` in quotes, or run where no shell expands
// it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace cgw::base {

// Holds `*`, `?` or `[`, and no file is called so.
bool is_path_pattern(const std::string& path);

// The files that match, each once, sorted by their bytes. In a name `*` stands for any text, `?` for one
// character, `[a-c]` for one of those; `**` as a whole name for any number of directories, also none. Names
// that begin with a point match only what begins with one. `**` enters no symbolic links. Empty: none
// matches. Fails when a directory cannot be read.
Result<std::vector<std::string>> files_of_pattern(const std::string& pattern);

}  // namespace cgw::base
