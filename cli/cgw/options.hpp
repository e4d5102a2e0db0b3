// The command line as plain data. Only options.cpp knows how it is parsed.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "diagnostic/renderers.hpp"
#include "emit/emitter.hpp"

namespace cgw::cli {

enum class Color { automatic, always, never };

struct CheckOptions {
    std::vector<std::string> files;
    const diagnostic::Renderer* renderer = nullptr;
    bool werror = false;
    std::vector<const diagnostic::Rule*> hidden;
    Color color = Color::automatic;
};

struct BuildOptions {
    std::string file;
    std::string directory;
    bool check = false;         // compare instead of write
    bool list_outputs = false;  // print the paths instead of write
    std::string depfile;
    Color color = Color::automatic;
};

struct EmitOptions {
    const emit::Emitter* emitter = nullptr;
    emit::Options artefact;
    std::string file;
    std::string output = "-";
    bool check = false;
    bool list_outputs = false;
    std::string depfile;
    Color color = Color::automatic;
};

struct ImageVerifyOptions {
    std::string file;
};

struct ImageInspectOptions {
    std::string file;
    bool json = false;
};

using Command =
    std::variant<CheckOptions, BuildOptions, EmitOptions, ImageVerifyOptions, ImageInspectOptions>;

// Either a command to run, or everything is said already and the program ends with `exit_code`.
struct ParsedCommand {
    bool run = false;
    Command command;
    int exit_code = 0;
};

ParsedCommand parse_command_line(int argc, const char* const* argv);

}  // namespace cgw::cli
