// Artefacts to files, whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "emit/emitter.hpp"

namespace cgw::driver {

struct Artefact {
    std::string file_name;
    base::Bytes content;
};

// Everything `build` writes, in the order of the emitter table. Every emitter gets the options, with the
// format in question.
std::vector<Artefact> build_artefacts(const emit::Plant& plant, const emit::Options& options = {});

// File names of the above without a plant.
std::vector<std::string> build_file_names(const emit::Options& options = {});

// Creates the directory when it is missing (and removes it again when nothing could be written).
// Nothing is visible before all is staged; identical files stay untouched. An artefact whose name is an
// absolute path goes there.
base::Result<void> write_artefacts(const std::filesystem::path& directory,
                                   const std::vector<Artefact>& artefacts);

// Why `outputs` may not be written: one of them is a file that was read, or two of them are the same.
// Empty when they may. "-" is no file.
std::string clash(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// Names of those artefacts whose file in `directory` is missing or differs.
std::vector<std::string> stale_artefacts(const std::filesystem::path& directory,
                                         const std::vector<Artefact>& artefacts);

// True when the file holds exactly these bytes.
bool up_to_date(const std::filesystem::path& path, const base::Bytes& content);

// A Makefile fragment "target: dependencies", as Ninja and Make read it. Each dependency but the first has an
// empty rule as well: a catalogue that is gone makes the target stale, and is not itself to be made.
std::string dependency_file(const std::string& target, const std::vector<std::string>& dependencies);

}  // namespace cgw::driver
