#include <csignal>
#include <exception>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verb_image.hpp"
#include "cli/cgw/verbs.hpp"

namespace {

struct Run {
    int operator()(const cgw::cli::CheckOptions& options) const { return cgw::cli::check(options); }
    int operator()(const cgw::cli::BuildOptions& options) const { return cgw::cli::build(options); }
    int operator()(const cgw::cli::EmitOptions& options) const { return cgw::cli::emit(options); }
    int operator()(const cgw::cli::ImageVerifyOptions& options) const {
        return cgw::cli::image_verify(options.file);
    }
    int operator()(const cgw::cli::ImageInspectOptions& options) const {
        return cgw::cli::image_inspect(options.file, options.json);
    }
};

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is a write that fails, not a crash
    try {
        const cgw::cli::ParsedCommand parsed = cgw::cli::parse_command_line(argc, argv);
        return parsed.run ? std::visit(Run{}, parsed.command) : parsed.exit_code;
    } catch (const std::exception& error) {
        cgw::cli::print_error(std::string("internal error: ") + error.what());
    } catch (...) {
        cgw::cli::print_error("internal error");
    }
    return cgw::cli::exit_internal;
}
