#include "diagnostic/renderers.hpp"

namespace cgw::diagnostic {
namespace {

constexpr Renderer table[] = {
    {"human", "source line and caret for every finding, with a summary", render_human, false},
    {"concise", "one line per finding: path:line:column: level: message [code name]", render_concise, false},
    {"json", "one JSON document with every finding", render_json, true},
    {"sarif", "one SARIF 2.1.0 document, for code scanning and editors", render_sarif, true},
    {"github", "one workflow command per finding, for annotations in GitHub Actions", render_github, false},
};

}  // namespace

std::span<const Renderer> all_renderers() {
    return table;
}

const Renderer* find_renderer(std::string_view name) {
    for (const Renderer& renderer : table) {
        if (renderer.name == name) {
            return &renderer;
        }
    }
    return nullptr;
}

}  // namespace cgw::diagnostic
