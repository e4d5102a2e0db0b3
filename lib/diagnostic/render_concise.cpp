#include <fmt/format.h>

#include "base/utf8.hpp"
#include "diagnostic/renderers.hpp"
#include "diagnostic/source_lines.hpp"

namespace cgw::diagnostic {

std::string render_concise(const RenderInput& input) {
    std::string text;
    for (const FileReport& file : input.files) {
        for (const Diagnostic& finding : file.findings) {
            text += fmt::format("{}: {}: {} [{} {}]\n", to_text(finding.where), to_text(finding.level()),
                                base::printable(finding.message), finding.rule->code, finding.rule->name);
        }
    }
    return text;
}

}  // namespace cgw::diagnostic
