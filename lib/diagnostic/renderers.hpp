// Findings as text, one renderer per format, chosen by name.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"

namespace cgw::diagnostic {

// The findings of one checked file.
struct FileReport {
    std::string path;
    std::vector<Diagnostic> findings;
    std::vector<std::string> not_verified{};  // what no check can know, one line each
    bool is_catalogue = false;                // and no parameter file
    std::string hint{};                       // for people: one line behind the count of findings
};

struct RenderInput {
    std::vector<FileReport> files;
    // Text of every file a finding may point into (parameter files and catalogues), for the caret lines.
    std::map<std::string, std::string> sources;
    bool color = false;
    std::string tool_version{};
    bool verdicts = true;  // for people: behind the findings of a file a line whether it is valid
};

struct Renderer {
    std::string_view name;
    std::string_view summary;
    std::string (*render)(const RenderInput&);
    bool whole_document;  // json, sarif: the output is that document and nothing else
};

std::span<const Renderer> all_renderers();
const Renderer* find_renderer(std::string_view name);

std::string render_human(const RenderInput& input);
std::string render_concise(const RenderInput& input);
std::string render_json(const RenderInput& input);
std::string render_sarif(const RenderInput& input);
std::string render_github(const RenderInput& input);

}  // namespace cgw::diagnostic
