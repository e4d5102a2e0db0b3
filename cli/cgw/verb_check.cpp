#include <utility>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"

namespace cgw::cli {

int check(const CheckOptions& options) {
    int exit_code = exit_fine;
    diagnostic::RenderInput input;
    input.color = use_color(options.color, stdout);
    input.tool_version = driver::tool_version();
    for (const std::string& path : options.files) {
        driver::CheckedFile file = driver::check_file(path);
        file.findings.hide(options.hidden);
        if (options.werror) {
            file.findings.promote_warnings();
        }
        exit_code = worse(exit_code, exit_code_of(file));
        input.files.push_back({path, file.findings.all(), std::move(file.not_verified)});
        input.sources.merge(std::move(file.sources));
    }
    return print(options.renderer->render(input)) ? exit_code : exit_environment;
}

}  // namespace cgw::cli
