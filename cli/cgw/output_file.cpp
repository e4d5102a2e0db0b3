#include "cli/cgw/output_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "base/bytes.hpp"
#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "driver/outputs.hpp"
#include "parameter/settings.hpp"

namespace cgw::cli {

void refuse_input_as_output(const std::string& output, const std::vector<std::string>& inputs) {
    if (output == "-") {
        return;
    }
    if (const std::string why = driver::clash({output}, inputs); !why.empty()) {
        throw UsageError(why);
    }
}

void refuse_existing_output(const Arguments& arguments, const std::string& output) {
    std::error_code ignored;
    if (output != "-" && !arguments.given("--force") && std::filesystem::is_regular_file(output, ignored)) {
        throw UsageError(fmt::format("{} exists; --force overwrites it", output));
    }
}

std::string schema_line(const std::string& output) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path place = output == "-" ? fs::path() : fs::absolute(output, failed).lexically_normal();
    std::string upwards;
    for (fs::path directory = place.parent_path(); !directory.empty(); directory = directory.parent_path()) {
        for (const std::string_view name :
             {"schemas/parameter-file.schema.json", "parameter-file.schema.json"}) {
            if (fs::is_regular_file(directory / name, failed)) {
                return fmt::format("#:schema {}{}\n", upwards, name);
            }
        }
        if (directory == directory.root_path()) {
            break;
        }
        upwards += "../";
    }
    return "# Editors complete and explain parameters once the first line says where the\n"
           "# output of cgw schema lies: #:schema parameter-file.schema.json\n";
}

int write_text(const std::string& output, const std::string& text) {
    if (output == "-") {
        return print(text) ? exit_fine : exit_environment;
    }
    if (const base::Result<void> written = base::write_file(output, base::to_bytes(text)); !written) {
        print_error(written.error().message);
        return exit_environment;
    }
    return exit_fine;
}

std::string title_of(const Arguments& arguments) {
    constexpr std::size_t longest = parameter::longest_title;
    std::string title = arguments.value("--title");
    if (!arguments.given("--title")) {
        return title;
    }
    if (title.empty() || title.size() > longest) {
        throw UsageError(
            fmt::format("--title: a title has 1 to {} bytes, this has {}", longest, title.size()));
    }
    if (base::printable(title) != title) {
        throw UsageError("--title: a title is UTF-8 without control characters");
    }
    return title;
}

}  // namespace cgw::cli
