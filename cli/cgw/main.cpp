#include <fmt/format.h>

#include <csignal>
#include <exception>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/help.hpp"
#include "cli/cgw/parser.hpp"
#include "cli/cgw/terminal.hpp"
#include "driver/plant.hpp"

namespace {

int run(std::span<const char* const> words) {
    const cgw::cli::Call call = cgw::cli::parse(words);
    if (call.verb != nullptr) {
        return call.verb->run(call.arguments);
    }
    const std::string text = call.version ? fmt::format("cgw {}\n", cgw::driver::tool_version())
                                          : cgw::cli::help_text(call.help_of);
    return cgw::cli::print(text) ? cgw::cli::exit_fine : cgw::cli::exit_environment;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is a write that fails, not a crash
    try {
        return run(std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 0 ? 1 : 0));
    } catch (const cgw::cli::UsageError& error) {
        cgw::cli::print_error(error.what());
        return cgw::cli::exit_usage;
    } catch (const std::exception& error) {
        cgw::cli::print_error(std::string("internal error: ") + error.what());
    } catch (...) {
        cgw::cli::print_error("internal error");
    }
    return cgw::cli::exit_internal;
}
