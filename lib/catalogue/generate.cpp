// cgw_catalogue_generate TABLE OUTPUT.cpp FILE.toml…: compiles the files of schemas/TABLE, which is
// parameters, errors or objects, into a table of rows.
#include <cstdio>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/files.hpp"
#include "catalogue/catalogue.hpp"
#include "catalogue/description_reader.hpp"
#include "catalogue/description_source.hpp"
#include "catalogue/row_source.hpp"

namespace cgw::catalogue {

namespace {

enum ExitCode { done = 0, mistakes = 1, usage = 2, no_file = 3 };

struct File {
    std::string path;
    std::string text;
};

std::string parameters(std::span<const File> files, diagnostic::Findings& findings) {
    parameter::Catalogue catalogue({});
    for (const File& file : files) {
        read_catalogue(file.text, file.path, catalogue, findings);
    }
    return row_source(catalogue.added());
}

std::string errors(std::span<const File> files, diagnostic::Findings& findings) {
    Descriptions descriptions;
    for (const File& file : files) {
        descriptions.read_errors(file.text, file.path, findings);
    }
    return error_source(descriptions.errors());
}

std::string objects(std::span<const File> files, diagnostic::Findings& findings) {
    Descriptions descriptions;
    for (const File& file : files) {
        descriptions.read_objects(file.text, file.path, findings);
    }
    return object_source(descriptions.objects());
}

struct Table {
    std::string_view name;
    std::string (*source)(std::span<const File> files, diagnostic::Findings& findings);
};

constexpr Table tables[] = {{"parameters", parameters}, {"errors", errors}, {"objects", objects}};

void print(const diagnostic::Findings& findings) {
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const diagnostic::Position& place = finding.where.range.start;
        fmt::print(stderr, "{}:{}:{}: {}: {} [{}]\n", finding.where.path, place.line, place.column,
                   to_text(finding.rule->level), finding.message, finding.rule->name);
    }
}

int generate(const Table& table, const std::string& output, std::span<const char* const> inputs) {
    std::vector<File> files;
    for (const char* path : inputs) {
        base::Result<std::string> text = base::read_file(path, toml::maximum_file_size);
        if (!text) {
            fmt::print(stderr, "{}\n", text.error().message);
            return no_file;
        }
        files.push_back({path, *std::move(text)});
    }
    diagnostic::Findings findings;
    const std::string source = table.source(files, findings);
    print(findings);
    if (!findings.all().empty()) {
        return mistakes;
    }
    const base::Result<void> written = base::write_file(output, base::to_bytes(source));
    if (!written) {
        fmt::print(stderr, "{}\n", written.error().message);
        return no_file;
    }
    return done;
}

}  // namespace

}  // namespace cgw::catalogue

int main(int argc, char** argv) {
    using cgw::catalogue::Table;
    const std::span<const char* const> arguments(argv, static_cast<std::size_t>(argc));
    constexpr std::size_t first_input = 3;
    if (arguments.size() > first_input) {
        for (const Table& table : cgw::catalogue::tables) {
            if (table.name == arguments[1]) {
                return cgw::catalogue::generate(table, arguments[2], arguments.subspan(first_input));
            }
        }
    }
    fmt::print(stderr, "usage: cgw_catalogue_generate parameters|errors|objects OUTPUT.cpp FILE.toml...\n");
    return cgw::catalogue::usage;
}
