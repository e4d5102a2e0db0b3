// Host program of the build: writes man pages and completion scripts as they are installed.
//   cgw_write_texts DIRECTORY     DIRECTORY is the future share/
#include <fmt/format.h>

#include <filesystem>

#include "cli/canopen-gateway/options.hpp"
#include "cli/cgw/man_page.hpp"
#include "cli/cgw/shell_completion.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"

namespace {

using cgw::driver::Artefact;

Artefact text(std::string name, const std::string& content) {
    return {std::move(name), cgw::base::to_bytes(content)};
}

std::vector<Artefact> texts() {
    const std::string version = cgw::driver::tool_version();
    std::vector<Artefact> all = {
        text("man/man1/cgw.1", cgw::cli::program_man_page(version)),
        text("bash-completion/completions/cgw", cgw::cli::bash_completion()),
        text("zsh/site-functions/_cgw", cgw::cli::zsh_completion()),
        text("fish/vendor_completions.d/cgw.fish", cgw::cli::fish_completion()),
    };
    const cgw::cli::Verb& gateway = cgw::gateway_cli::command();
    all.push_back(
        text("man/man1/canopen-gateway.1",
             cgw::cli::command_man_page(gateway, cgw::gateway_cli::exit_code_texts(), "cgw", version)));
    all.push_back(text("bash-completion/completions/canopen-gateway", cgw::cli::bash_completion(gateway)));
    all.push_back(text("zsh/site-functions/_canopen-gateway", cgw::cli::zsh_completion(gateway)));
    all.push_back(text("fish/vendor_completions.d/canopen-gateway.fish", cgw::cli::fish_completion(gateway)));
    for (const cgw::cli::Verb* verb : cgw::cli::all_verbs()) {
        all.push_back(text(fmt::format("man/man1/{}.1", cgw::cli::man_page_name(*verb)),
                           cgw::cli::verb_man_page(*verb, version)));
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: cgw_write_texts DIRECTORY\n");
        return 2;
    }
    const std::filesystem::path share = argv[1];
    for (const Artefact& artefact : texts()) {
        const std::filesystem::path path = share / artefact.file_name;
        std::error_code ignored;  // the write below says why
        std::filesystem::create_directories(path.parent_path(), ignored);
        const auto written =
            cgw::driver::write_artefacts(path.parent_path(), {{path.filename().string(), artefact.content}});
        if (!written) {
            fmt::print(stderr, "cgw_write_texts: {}\n", written.error().message);
            return 1;
        }
    }
}
