#include "driver/outputs.hpp"

#include <fmt/format.h>

#include "base/files.hpp"

namespace cgw::driver {
namespace {

// Calls `visit(emitter, format)` for every file that build writes.
template <typename Visit>
void for_each_built(Visit visit) {
    for (const emit::Emitter& emitter : emit::all_emitters()) {
        for (const emit::Format& format : emitter.formats) {
            if (!format.file_name.empty()) {
                visit(emitter, format);
            }
        }
    }
}

std::string escape_for_make(const std::string& path) {
    std::string escaped;
    for (const char c : path) {
        if (c == ' ' || c == '#') {
            escaped += '\\';
        }
        escaped += c;
        if (c == '$') {
            escaped += '$';
        }
    }
    return escaped;
}

}  // namespace

std::vector<Artefact> build_artefacts(const emit::Plant& plant, const emit::Options& options) {
    std::vector<Artefact> artefacts;
    for_each_built([&](const emit::Emitter& emitter, const emit::Format& format) {
        emit::Options own = options;
        own.format = format.name;
        artefacts.push_back({emit::file_name(format, options), emitter.emit(plant, own)});
    });
    return artefacts;
}

std::vector<std::string> build_file_names(const emit::Options& options) {
    std::vector<std::string> names;
    for_each_built([&](const emit::Emitter&, const emit::Format& format) {
        names.push_back(emit::file_name(format, options));
    });
    return names;
}

base::Result<void> write_artefacts(const std::filesystem::path& directory,
                                   const std::vector<Artefact>& artefacts) {
    std::error_code error;
    const bool created = std::filesystem::create_directories(directory, error);
    if (error) {
        return base::failure(fmt::format("cannot create {}: {}", directory.string(), error.message()));
    }
    base::Result<void> result;
    {
        base::FileSet files;
        for (const Artefact& artefact : artefacts) {
            if (result = files.stage(directory / artefact.file_name, artefact.content); !result) {
                break;
            }
        }
        if (result) {
            result = files.commit();
        }
    }
    if (!result && created) {
        std::filesystem::remove(directory, error);  // only when empty
    }
    return result;
}

std::vector<std::string> stale_artefacts(const std::filesystem::path& directory,
                                         const std::vector<Artefact>& artefacts) {
    std::vector<std::string> stale;
    for (const Artefact& artefact : artefacts) {
        if (!up_to_date(directory / artefact.file_name, artefact.content)) {
            stale.push_back(artefact.file_name);
        }
    }
    return stale;
}

bool up_to_date(const std::filesystem::path& path, const base::Bytes& content) {
    const base::Result<std::string> present = base::read_file(path.string(), content.size());
    return present && base::to_bytes(*present) == content;
}

std::string clash(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    const auto normal = [](const std::string& path) {
        return std::filesystem::absolute(path).lexically_normal();
    };
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        for (const std::string& input : inputs) {
            if (base::same_file(*output, input)) {
                return fmt::format("{} is an input file and is not overwritten", *output);
            }
        }
        for (auto other = outputs.begin(); other != output; ++other) {
            if (normal(*other) == normal(*output) || base::same_file(*other, *output)) {
                return fmt::format("{} and {} are the same file", *other, *output);
            }
        }
    }
    return {};
}

std::string dependency_file(const std::string& target, const std::vector<std::string>& dependencies) {
    std::string rule = escape_for_make(target) + ":";
    std::string empty_rules;
    bool first = true;
    for (const std::string& dependency : dependencies) {
        if (dependency != "-") {  // standard input is nothing to wait for
            const std::string name = escape_for_make(dependency);
            rule += " \\\n  " + name;
            empty_rules += first ? "" : name + ":\n";
        }
        first = false;
    }
    return rule + "\n" + empty_rules;
}

}  // namespace cgw::driver
