// A parameter file from its path to settings, configuration and findings. The only room that opens files.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/configuration.hpp"
#include "diagnostic/diagnostic.hpp"
#include "diagnostic/renderers.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::driver {

struct CheckedFile {
    std::string path;
    std::unique_ptr<parameter::Catalogue> catalogue;  // owns the rows that the settings point to
    parameter::Settings settings;
    config::Configuration configuration;
    diagnostic::Findings findings;
    std::vector<std::string> not_verified;       // what no check can know; empty when not valid()
    std::map<std::string, std::string> sources;  // by path: the file's text and its catalogues'
    std::vector<std::string> dependencies;       // paths read, the parameter file first
    bool is_catalogue = false;                   // a catalogue file: there are no settings
    bool complete = false;                       // settings hold all that the file says
    bool unreadable = false;                     // the parameter file itself or a catalogue: exit code 3

    bool valid() const { return !unreadable && !is_catalogue && !findings.has_errors(); }
};

// Reads, resolves and checks; all findings, sorted by place. Path "-" is standard input, whose catalogues
// are looked up in the working directory. Settings and configuration are to be used only when valid().
CheckedFile check_file(const std::string& path);

// The same, but a catalogue file is checked as one, beside the shipped rows: `is_catalogue`.
CheckedFile check_file_or_catalogue(const std::string& path);

// As check_file, for a text that is or will be the file `path`; only its catalogues are read.
CheckedFile check_text(const std::string& path, std::string text);

}  // namespace cgw::driver
