#include <fmt/format.h>

#include <filesystem>

#include "base/utf8.hpp"
#include "cli/cgw/artefact_options.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"

namespace cgw::cli {
namespace {

// Manual chapter 7, note: neither device takes a configuration over before it was saved and reset.
constexpr std::string_view reminder =
    "Enter the parameters in both devices, save them in both, then reset BOTH devices:\n"
    "neither takes over a new configuration before its reset.\n";

struct BuildOptions {
    std::string file;
    std::string directory;
    bool check = false;         // compare instead of write
    bool list_outputs = false;  // print the paths instead of write
    std::string depfile;
    bool color = false;
    emit::Options artefacts;
};

std::string in_directory(const BuildOptions& options, const std::string& name) {
    return (std::filesystem::path(options.directory) / name).string();
}

int list_outputs(const BuildOptions& options) {
    std::string text;
    for (const std::string& name : driver::build_file_names(options.artefacts)) {
        text += in_directory(options, name) + "\n";
    }
    return print(text) ? exit_fine : exit_environment;
}

int compare(const BuildOptions& options, const std::vector<driver::Artefact>& artefacts) {
    const std::vector<std::string> stale = driver::stale_artefacts(options.directory, artefacts);
    for (const std::string& name : stale) {
        print_error(fmt::format("{} is missing or stale; run cgw build", in_directory(options, name)));
    }
    return stale.empty() ? exit_fine : exit_findings;
}

base::Result<void> write(const BuildOptions& options, const driver::CheckedFile& file,
                         std::vector<driver::Artefact> artefacts) {
    if (!options.depfile.empty()) {
        const std::string target = in_directory(options, artefacts.front().file_name);
        artefacts.push_back({std::filesystem::absolute(options.depfile).string(),
                             base::to_bytes(driver::dependency_file(target, file.dependencies))});
    }
    return driver::write_artefacts(options.directory, artefacts);
}

std::vector<std::string> outputs(const BuildOptions& options) {
    std::vector<std::string> paths;
    for (const std::string& name : driver::build_file_names(options.artefacts)) {
        paths.push_back(in_directory(options, name));
    }
    if (!options.depfile.empty()) {
        paths.push_back(options.depfile);
    }
    return paths;
}

std::string summary(const BuildOptions& options, const driver::CheckedFile& file, const emit::Plant& plant,
                    const std::vector<driver::Artefact>& artefacts) {
    const std::string& title = file.settings.title;
    std::string text =
        fmt::format("{}: {}configuration id {}\n", base::printable(file.path),
                    title.empty() ? "" : base::printable(title) + ", ", plant.configuration_id_text);
    for (const driver::Artefact& artefact : artefacts) {
        text += fmt::format("  {} ({} bytes)\n", base::printable(in_directory(options, artefact.file_name)),
                            artefact.content.size());
    }
    return text + std::string(reminder);
}

int build(const BuildOptions& options) {
    if (options.list_outputs) {
        return list_outputs(options);
    }
    const driver::CheckedFile file = driver::check_file(options.file);
    report_findings(file, options.color);
    if (!file.valid()) {
        return exit_code_of(file);
    }
    const base::Result<driver::Plant> made = driver::Plant::make(file);
    if (!made) {
        print_error(made.error().message);
        return exit_usage;
    }
    const emit::Plant plant = made->view();
    const std::vector<driver::Artefact> artefacts = driver::build_artefacts(plant, options.artefacts);
    if (options.check) {
        return compare(options, artefacts);
    }
    if (const std::string why = driver::clash(outputs(options), file.dependencies); !why.empty()) {
        print_error(why);
        return exit_usage;
    }
    if (const base::Result<void> written = write(options, file, artefacts); !written) {
        print_error(written.error().message);
        return exit_environment;
    }
    return print(summary(options, file, plant, artefacts)) ? exit_fine : exit_environment;
}

constexpr Option build_options[] = {
    parameter_file_option,
    {.names = "-o,--output",
     .value = "DIR",
     .summary = "directory for the artefacts; created if missing",
     .required = true,
     .completes = Completes::directories},
    eds_name_option,
    check_option,
    list_outputs_option,
    depfile_option,
    color_option,
};

int run_build(const Arguments& arguments) {
    refuse_dash(arguments, "--output");
    refuse_dash(arguments, "--depfile");
    BuildOptions options;
    options.file = arguments.value("FILE");
    options.directory = arguments.value("--output");
    options.check = arguments.given("--check");
    options.list_outputs = arguments.given("--list-outputs");
    options.depfile = arguments.value("--depfile");
    options.color = use_color(arguments, stderr);
    options.artefacts.eds_name = eds_name_of(arguments);
    return build(options);
}

}  // namespace

const Verb build_verb = {"build", "check a parameter file and write all artefacts", build_options, run_build};

}  // namespace cgw::cli
