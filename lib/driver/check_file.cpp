#include "driver/check_file.hpp"

#include <optional>
#include <utility>

#include "base/files.hpp"
#include "catalogue/catalogue.hpp"
#include "check/checks.hpp"
#include "check/not_verified.hpp"
#include "driver/report_unreadable.hpp"
#include "input/parameter_file.hpp"
#include "toml/document.hpp"

namespace cgw::driver {
namespace {

CheckedFile empty_file(const std::string& path) {
    CheckedFile file;
    file.path = path;
    file.catalogue = std::make_unique<parameter::Catalogue>(catalogue::shipped_rows());
    file.dependencies.push_back(path);
    return file;
}

CheckedFile check_catalogue(const std::string& path, std::string text) {
    CheckedFile file = empty_file(path);
    file.is_catalogue = true;
    catalogue::read_catalogue(text, path, *file.catalogue, file.findings);
    file.sources[path] = std::move(text);
    file.findings.sort();
    return file;
}

// What is no TOML is read as a parameter file, and refused as one.
bool is_catalogue(const std::string& path, const std::string& text) {
    diagnostic::Findings unused;
    const std::optional<toml::Node> root = toml::parse(text, path, unused);
    return root && catalogue::is_catalogue(*root);
}

CheckedFile check(const std::string& path, bool may_be_catalogue) {
    base::Result<std::string> text = base::read_file(path, toml::maximum_file_size);
    if (!text) {
        CheckedFile file = empty_file(path);
        file.unreadable = report_unreadable(path, text.error(), file.findings);
        return file;
    }
    return may_be_catalogue && is_catalogue(path, *text) ? check_catalogue(path, std::move(*text))
                                                         : check_text(path, std::move(*text));
}

}  // namespace

CheckedFile check_file(const std::string& path) {
    return check(path, false);
}

CheckedFile check_file_or_catalogue(const std::string& path) {
    return check(path, true);
}

CheckedFile check_text(const std::string& path, std::string text) {
    CheckedFile file = empty_file(path);
    const auto load = [&](const std::string& name) {
        const std::string catalogue_path = base::beside(path, name);
        file.dependencies.push_back(catalogue_path);
        base::Result<std::string> content = base::read_file(catalogue_path, toml::maximum_file_size);
        file.unreadable = file.unreadable || (!content && !content.error().too_large);
        return content;
    };
    input::ReadResult read = input::read_parameter_file(text, path, *file.catalogue, load, file.findings);
    file.complete = read.usable && !file.findings.has_errors();
    file.sources = std::move(read.file.sources);
    file.sources[path] = std::move(text);
    file.settings = std::move(read.file.settings);
    if (read.usable) {
        file.configuration = config::resolve(file.settings, *file.catalogue);
        const check::Context context{file.settings, *file.catalogue, file.configuration, file.findings};
        check::check(context);
        if (file.valid()) {
            file.not_verified = check::not_verified(context);
        }
    }
    file.findings.sort();
    return file;
}

}  // namespace cgw::driver
