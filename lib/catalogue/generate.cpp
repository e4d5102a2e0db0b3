// cgw_catalogue_generate OUTPUT.cpp CATALOGUE.toml…: compiles catalogue files into a table of rows.
#include <cstdio>
#include <span>
#include <string>

#include <fmt/format.h>

#include "base/files.hpp"
#include "catalogue/catalogue.hpp"
#include "catalogue/row_source.hpp"

namespace cgw::catalogue {

namespace {

enum ExitCode { done = 0, mistakes = 1, usage = 2, no_file = 3 };

void print(const diagnostic::Findings& findings) {
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const diagnostic::Position& place = finding.where.range.start;
        fmt::print(stderr, "{}:{}:{}: {}: {} [{}]\n", finding.where.path, place.line, place.column,
                   to_text(finding.rule->level), finding.message, finding.rule->name);
    }
}

int generate(const std::string& output, std::span<const char* const> inputs) {
    parameter::Catalogue catalogue({});
    diagnostic::Findings findings;
    for (const char* path : inputs) {
        const base::Result<std::string> text = base::read_file(path, toml::maximum_file_size);
        if (!text) {
            fmt::print(stderr, "{}\n", text.error().message);
            return no_file;
        }
        read_catalogue(*text, path, catalogue, findings);
    }
    print(findings);
    if (!findings.all().empty()) {
        return mistakes;
    }
    const base::Result<void> written =
        base::write_file(output, base::to_bytes(row_source(catalogue.added())));
    if (!written) {
        fmt::print(stderr, "{}\n", written.error().message);
        return no_file;
    }
    return done;
}

}  // namespace

}  // namespace cgw::catalogue

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(stderr, "usage: cgw_catalogue_generate OUTPUT.cpp CATALOGUE.toml...\n");
        return cgw::catalogue::usage;
    }
    const std::span<const char* const> arguments(argv, static_cast<std::size_t>(argc));
    return cgw::catalogue::generate(arguments[1], arguments.subspan(2));
}
