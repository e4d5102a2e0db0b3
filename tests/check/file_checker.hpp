// A parameter file through input, configuration and checks, without the driver.
#pragma once

#include <filesystem>
#include <string>

#include "base/files.hpp"
#include "catalogue/catalogue.hpp"
#include "check/checks.hpp"
#include "config/configuration.hpp"
#include "input/parameter_file.hpp"

namespace cgw::test {

struct CheckedText {
    diagnostic::Findings findings;
    config::Configuration configuration;
    bool usable = false;
};

// `path` is what the findings say; catalogues named in the text are looked up in `directory`. Rows belong to
// `catalogue`, which must outlive the configuration.
inline CheckedText check_text(const std::string& text, const std::string& path,
                              const std::filesystem::path& directory, parameter::Catalogue& catalogue) {
    CheckedText checked;
    const auto load = [&](const std::string& name) {
        const std::filesystem::path file = directory / name;
        base::Result<std::string> content = base::read_file(file.string(), 1U << 20U);
        if (!content) {  // without the directory, which differs from machine to machine
            return base::Result<std::string>(base::failure("cannot open " + name));
        }
        return content;
    };
    const input::ReadResult read = input::read_parameter_file(text, path, catalogue, load, checked.findings);
    checked.usable = read.usable;
    if (read.usable) {
        checked.configuration = config::resolve(read.file.settings, catalogue);
        check::check({read.file.settings, catalogue, checked.configuration, checked.findings});
    }
    checked.findings.sort();
    return checked;
}

}  // namespace cgw::test
