#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/cgw/artefact_options.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "compare/compare.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"

namespace cgw::cli {
namespace {

struct EmitOptions {
    const emit::Emitter* emitter = nullptr;
    emit::Options artefact;
    bool generic = false;  // no configuration: no parameter file either
    std::string file;
    std::string against;  // an earlier parameter file, for the report
    std::string output;
    bool check = false;
    bool list_outputs = false;
    std::string depfile;
    bool color = false;
};

int write_to_stdout(const base::Bytes& content) {
    const bool binary = std::find(content.begin(), content.end(), 0) != content.end();
    if (binary && is_terminal(stdout)) {
        print_error("this artefact is binary and is not written to a terminal; use -o FILE");
        return exit_usage;
    }
    const std::string text(content.begin(), content.end());
    return print(text) ? exit_fine : exit_environment;
}

int write_to_file(const EmitOptions& options, const std::vector<std::string>& dependencies,
                  const base::Bytes& content) {
    std::vector<std::string> outputs = {options.output};
    std::vector<driver::Artefact> files = {{std::filesystem::absolute(options.output).string(), content}};
    if (!options.depfile.empty()) {
        outputs.push_back(options.depfile);
        files.push_back({std::filesystem::absolute(options.depfile).string(),
                         base::to_bytes(driver::dependency_file(options.output, dependencies))});
    }
    if (const std::string why = driver::clash(outputs, dependencies); !why.empty()) {
        print_error(why);
        return exit_usage;
    }
    if (const base::Result<void> written = driver::write_artefacts(".", files); !written) {
        print_error(written.error().message);
        return exit_environment;
    }
    return exit_fine;
}

int compare(const EmitOptions& options, const base::Bytes& content) {
    if (driver::up_to_date(options.output, content)) {
        return exit_fine;
    }
    print_error(
        fmt::format("{} is missing or stale; run cgw emit {}", options.output, options.emitter->name));
    return exit_findings;
}

int deliver(const EmitOptions& options, const std::vector<std::string>& dependencies,
            const base::Bytes& content) {
    if (options.check) {
        return compare(options, content);
    }
    return options.output == "-" ? write_to_stdout(content) : write_to_file(options, dependencies, content);
}

int emit_generic(const EmitOptions& options) {
    const base::Result<emit::Origin> origin = driver::origin();
    if (!origin) {
        print_error(origin.error().message);
        return exit_usage;
    }
    return deliver(options, {}, options.emitter->emit_generic(*origin, options.artefact));
}

// The earlier plant: one whose plant would fail can be compared, one that cannot be read whole cannot.
int read_earlier(const driver::CheckedFile& earlier, bool color) {
    if (earlier.complete) {
        return exit_fine;
    }
    report_findings(earlier, color);
    print_error(fmt::format("{} cannot be compared before its errors are mended", earlier.path));
    return exit_code_of(earlier);
}

int emit_configured(const EmitOptions& options) {
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
    emit::Plant plant = made->view();
    if (options.against.empty()) {
        return deliver(options, file.dependencies, options.emitter->emit(plant, options.artefact));
    }
    const driver::CheckedFile earlier = driver::check_file(options.against);
    if (const int exit_code = read_earlier(earlier, options.color); exit_code != exit_fine) {
        return exit_code;
    }
    const compare::Comparison changes =
        compare::compare({earlier.settings, earlier.configuration, *earlier.catalogue},
                         {file.settings, file.configuration, *file.catalogue});
    plant.against = &changes;
    plant.against_name = std::filesystem::path(earlier.path).filename().string();
    std::vector<std::string> dependencies = file.dependencies;
    dependencies.insert(dependencies.end(), earlier.dependencies.begin(), earlier.dependencies.end());
    return deliver(options, dependencies, options.emitter->emit(plant, options.artefact));
}

int emit(const EmitOptions& options) {
    if (options.list_outputs) {
        return print(options.output + "\n") ? exit_fine : exit_environment;
    }
    return options.generic ? emit_generic(options) : emit_configured(options);
}

constexpr Option emit_options[] = {
    emitter_option,
    {.names = "FILE",
     .summary = "parameter file; - is standard input; none with --generic",
     .completes = Completes::files},
    text_output_option,
    artefact_format_option,
    generic_option,
    eds_name_option,
    section_option,
    alignment_option,
    symbol_option,
    incbin_option,
    base_option,
    no_labels_option,
    against_option,
    check_option,
    list_outputs_option,
    depfile_option,
    color_option,
};

void check_file_argument(const Arguments& arguments, bool generic) {
    if (generic && arguments.given("FILE")) {
        throw UsageError("--generic takes no FILE: the generic data sheet depends on no configuration");
    }
    if (!generic && !arguments.given("FILE")) {
        throw UsageError("FILE is missing");
    }
}

int run_emit(const Arguments& arguments) {
    refuse_dash(arguments, "--depfile");
    EmitOptions options;
    options.emitter = emit::find_emitter(arguments.value("NAME"));
    options.artefact = artefact_options(arguments, *options.emitter);
    options.generic = arguments.given("--generic");
    check_file_argument(arguments, options.generic);
    options.file = arguments.value("FILE");
    options.against = arguments.value("--against");
    if (options.file == "-" && options.against == "-") {
        throw UsageError("standard input (-) can be read only once");
    }
    options.output = arguments.value("--output");
    options.check = arguments.given("--check");
    options.list_outputs = arguments.given("--list-outputs");
    options.depfile = arguments.value("--depfile");
    options.color = use_color(arguments, stderr);
    if (options.output == "-" && (options.check || !options.depfile.empty())) {
        throw UsageError("--check and --depfile need an output file: -o PATH");
    }
    return emit(options);
}

}  // namespace

const Verb emit_verb = {"emit", "check a parameter file and write one artefact", emit_options, run_emit};

}  // namespace cgw::cli
