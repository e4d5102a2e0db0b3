// The only file with CLI11: the command line to plain option structs.
#include "cli/cgw/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "base/edit_distance.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "driver/plant.hpp"

namespace cgw::cli {
namespace {

const std::map<std::string, Color> color_names = {
    {"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}};

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& known) {
    const std::string nearest = base::nearest_name(name, known);
    return nearest.empty() ? std::string() : fmt::format("; did you mean '{}'?", nearest);
}

[[noreturn]] void refuse(const std::string& message) {
    throw CLI::ValidationError(message);
}

template <typename Table>
std::vector<std::string_view> names_of(const Table& table) {
    std::vector<std::string_view> names;
    for (const auto& row : table) {
        names.push_back(row.name);
    }
    return names;
}

std::string joined(const std::vector<std::string_view>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

void add_color(CLI::App& verb, Color& color) {
    verb.add_option_function<std::string>(
            "--color", [&color](const std::string& name) { color = color_names.at(name); },
            "When to colour findings: auto (on a terminal), always, never")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->type_name("WHEN");
}

// -W NAME and -W no-NAME, the last word on a rule wins.
std::vector<const diagnostic::Rule*> hidden_rules(const std::vector<std::string>& words) {
    std::map<std::string_view, const diagnostic::Rule*> by_name;
    std::vector<std::string_view> names;
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        by_name[rule->name] = rule;
        names.push_back(rule->name);
    }
    std::vector<const diagnostic::Rule*> hidden;
    for (const std::string& word : words) {
        const bool hide = word.starts_with("no-") && !by_name.contains(word);
        const std::string name = hide ? word.substr(3) : word;
        const auto found = by_name.find(name);
        if (found == by_name.end()) {
            refuse(fmt::format("-W {}: there is no rule '{}'{}", word, name, did_you_mean(name, names)));
        }
        if (hide && found->second->level == diagnostic::Level::error) {
            refuse(fmt::format("-W {}: '{}' is an error and cannot be hidden", word, name));
        }
        std::erase(hidden, found->second);
        if (hide) {
            hidden.push_back(found->second);
        }
    }
    return hidden;
}

// Fills `command` when its verb was given; the texts live as long as the parser.
class Parser {
  public:
    Parser() {
        app_.require_subcommand(1);
        app_.set_version_flag("--version", fmt::format("cgw {}", driver::tool_version()),
                              "Print the version");
        app_.footer(
            "Exit codes: 0 fine, 1 findings of level error, 2 usage, 3 cannot read or write, 70 internal.");
        add_check();
        add_build();
        add_emit();
        add_image();
    }

    ParsedCommand parse(int argc, const char* const* argv) {
        try {
            suggest_verb(argc, argv);
            app_.parse(argc, argv);
            return {true, finish(), exit_fine};
        } catch (const CLI::Success& success) {  // --help, --version
            return {false, {}, app_.exit(success) == 0 ? exit_fine : exit_usage};
        } catch (const CLI::ParseError& error) {
            print_error(fmt::format("{} (see cgw --help, cgw VERB --help)", error.what()));
            return {false, {}, exit_usage};
        }
    }

  private:
    void suggest_verb(int argc, const char* const* argv) {
        if (argc < 2 || argv[1][0] == '-') {
            return;
        }
        std::vector<std::string> verbs;
        for (const CLI::App* verb : app_.get_subcommands({})) {
            verbs.push_back(verb->get_name());
        }
        const std::string given = argv[1];
        if (std::find(verbs.begin(), verbs.end(), given) == verbs.end()) {
            const std::vector<std::string_view> names(verbs.begin(), verbs.end());
            refuse(fmt::format("there is no verb '{}'{}", given, did_you_mean(given, names)));
        }
    }

    void add_check() {
        check_ = app_.add_subcommand("check", "Check parameter files and report every finding");
        check_->add_option("FILE", check_options_.files, "Parameter files; - is standard input")->required();
        check_->add_option("--format", format_, "human, concise or json")->type_name("FORMAT");
        check_->add_flag("--werror", check_options_.werror, "Treat warnings as errors");
        check_->add_option("-W", warnings_, "Show (NAME) or hide (no-NAME) a warning or note; repeatable")
            ->type_name("NAME")
            ->expected(1)
            ->take_all();
        add_color(*check_, check_options_.color);
    }

    void add_build() {
        build_ = app_.add_subcommand("build", "Check a parameter file and write all artefacts");
        build_->add_option("FILE", build_options_.file, "Parameter file; - is standard input")->required();
        build_
            ->add_option("-o,--output", build_options_.directory,
                         "Directory for the artefacts; created if missing")
            ->required()
            ->type_name("DIR");
        build_->add_flag("--check", build_options_.check,
                         "Write nothing; exit 1 when an artefact is missing or stale");
        build_->add_flag("--list-outputs", build_options_.list_outputs,
                         "Print the paths that would be written");
        build_
            ->add_option("--depfile", build_options_.depfile,
                         "Also write a dependency file for make and ninja")
            ->type_name("PATH");
        add_color(*build_, build_options_.color);
    }

    void add_emit() {
        emit_ = app_.add_subcommand("emit", "Check a parameter file and write one artefact");
        emit_->add_option("NAME", emitter_, "Artefact: " + joined(names_of(emit::all_emitters())))
            ->required();
        emit_->add_option("FILE", emit_options_.file, "Parameter file; - is standard input")->required();
        emit_->add_option("-o,--output", emit_options_.output, "Output file; - is standard output")
            ->capture_default_str()
            ->type_name("PATH");
        emit_->add_option("--format", format_, "Form of the artefact, where it has several")
            ->type_name("FORMAT");
        emit_->add_option("--section", emit_options_.artefact.section, "image-source: linker section")
            ->capture_default_str();
        emit_->add_option("--align", emit_options_.artefact.alignment, "image-source: alignment in bytes")
            ->capture_default_str();
        emit_->add_option("--symbol", emit_options_.artefact.symbol, "image-source: name of the array")
            ->capture_default_str();
        emit_->add_flag("--check", emit_options_.check,
                        "Write nothing; exit 1 when the output is missing or stale");
        emit_->add_flag("--list-outputs", emit_options_.list_outputs, "Print the path that would be written");
        emit_
            ->add_option("--depfile", emit_options_.depfile,
                         "Also write a dependency file for make and ninja")
            ->type_name("PATH");
        add_color(*emit_, emit_options_.color);
    }

    void add_image() {
        image_ = app_.add_subcommand("image", "Verify and inspect configuration images");
        image_->require_subcommand(1);
        verify_ = image_->add_subcommand("verify", "Say whether the gateway would take the image");
        verify_->add_option("FILE", verify_options_.file, "Configuration image")->required();
        inspect_ = image_->add_subcommand("inspect", "Show what an image holds");
        inspect_->add_option("FILE", inspect_options_.file, "Configuration image")->required();
        inspect_->add_flag("--json", inspect_options_.json, "As one JSON document");
    }

    static void refuse_dash(const std::string& option, const std::string& path) {
        if (path == "-") {
            refuse(fmt::format("{} -: this needs a path; standard output is not possible here", option));
        }
    }

    Command finish() {
        if (*check_) {
            finish_check();
            return check_options_;
        }
        if (*build_) {
            refuse_dash("--output", build_options_.directory);
            refuse_dash("--depfile", build_options_.depfile);
            return build_options_;
        }
        if (*emit_) {
            finish_emit();
            return emit_options_;
        }
        if (*verify_) {
            return verify_options_;
        }
        return inspect_options_;
    }

    void finish_check() {
        const std::string name = format_.empty() ? "human" : format_;
        check_options_.renderer = diagnostic::find_renderer(name);
        if (check_options_.renderer == nullptr) {
            refuse(fmt::format("--format {}: the formats are {}", name,
                               joined(names_of(diagnostic::all_renderers()))));
        }
        if (std::count(check_options_.files.begin(), check_options_.files.end(), "-") > 1) {
            refuse("standard input (-) can be read only once");
        }
        check_options_.hidden = hidden_rules(warnings_);
    }

    void finish_emit() {
        emit_options_.emitter = emit::find_emitter(emitter_);
        if (emit_options_.emitter == nullptr) {
            const std::vector<std::string_view> names = names_of(emit::all_emitters());
            refuse(fmt::format("there is no artefact '{}'{} (artefacts: {})", emitter_,
                               did_you_mean(emitter_, names), joined(names)));
        }
        refuse_dash("--depfile", emit_options_.depfile);
        check_artefact_format();
        check_artefact_options();
        const bool to_stdout = emit_options_.output == "-";
        if (to_stdout && (emit_options_.check || !emit_options_.depfile.empty())) {
            refuse("--check and --depfile need an output file: -o PATH");
        }
    }

    void check_artefact_format() {
        const std::vector<std::string_view> formats = names_of(emit_options_.emitter->formats);
        emit_options_.artefact.format = format_.empty() ? std::string(formats.front()) : format_;
        if (std::find(formats.begin(), formats.end(), emit_options_.artefact.format) == formats.end()) {
            refuse(fmt::format("--format {}: the formats of {} are {}", format_, emitter_, joined(formats)));
        }
    }

    void check_artefact_options() {
        const emit::Options& artefact = emit_options_.artefact;
        constexpr unsigned largest_alignment = 4096;
        const unsigned n = artefact.alignment;
        if (n == 0 || n > largest_alignment || (n & (n - 1)) != 0) {
            refuse(fmt::format("--align {}: the alignment is a power of two from 1 to {}", n,
                               largest_alignment));
        }
        const auto is_name = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        };
        const auto is_name_or_digit = [&](char c) { return is_name(c) || (c >= '0' && c <= '9'); };
        const std::string& symbol = artefact.symbol;
        if (symbol.empty() || !is_name(symbol.front()) ||
            !std::all_of(symbol.begin(), symbol.end(), is_name_or_digit)) {
            refuse(fmt::format("--symbol {}: not a C identifier", symbol));
        }
        const std::string& section = artefact.section;
        if (section.empty() || !std::all_of(section.begin(), section.end(), [&](char c) {
                return is_name_or_digit(c) || c == '.' || c == '-' || c == '$';
            })) {
            refuse(fmt::format("--section {}: a section name has letters, digits and . _ - $ only", section));
        }
    }

    CLI::App app_{"Configuration compiler for HEINZMANN CANopen gateways", "cgw"};
    CLI::App* check_ = nullptr;
    CLI::App* build_ = nullptr;
    CLI::App* emit_ = nullptr;
    CLI::App* image_ = nullptr;
    CLI::App* verify_ = nullptr;
    CLI::App* inspect_ = nullptr;
    CheckOptions check_options_;
    BuildOptions build_options_;
    EmitOptions emit_options_;
    ImageVerifyOptions verify_options_;
    ImageInspectOptions inspect_options_;
    std::string format_;
    std::string emitter_;
    std::vector<std::string> warnings_;
};

}  // namespace

ParsedCommand parse_command_line(int argc, const char* const* argv) {
    return Parser().parse(argc, argv);
}

}  // namespace cgw::cli
