// The parameter file (TOML, format 1; docs/parameter-file.md) to settings.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "diagnostic/diagnostic.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"
#include "toml/document.hpp"

namespace cgw::input {

inline constexpr int parameter_file_format = 1;

// Supplies the text of a catalogue named in the file. `name` is as in the file's `catalogue` list; the caller
// resolves it relative to the file. This room opens no file itself.
using CatalogueLoader = std::function<base::Result<std::string>(const std::string& name)>;

struct ParameterFile {
    parameter::Settings settings;
    std::vector<std::string> catalogues;         // as named in the file
    std::map<std::string, std::string> sources;  // their texts, by the path that findings name
};

// Reads everything it can and reports every mistake; after an error `settings` is incomplete but safe to
// check, so that one run shows all findings. `usable` is false when nothing could be read: the text is not
// TOML, or says that it is written in another format.
struct ReadResult {
    ParameterFile file;
    bool usable = false;
};

// `catalogue` holds the shipped rows; the rows of the file's catalogues and declarations are added to it.
ReadResult read_parameter_file(std::string_view text, const std::string& path,
                               parameter::Catalogue& catalogue, const CatalogueLoader& load,
                               diagnostic::Findings& findings);

// The same for a text that is parsed already.
ReadResult read_parameter_file(const toml::Node& document, const std::string& path,
                               parameter::Catalogue& catalogue, const CatalogueLoader& load,
                               diagnostic::Findings& findings);

}  // namespace cgw::input
