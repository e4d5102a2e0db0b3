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

// Catalogues beside the parameter file.
input::CatalogueLoader loader_of(CheckedFile& file) {
    return [&file](const std::string& name) {
        const std::string path = base::beside(file.path, name);
        file.dependencies.push_back(path);
        base::Result<std::string> content = base::read_file(path, toml::maximum_file_size);
        file.unreadable = file.unreadable || (!content && !content.error().too_large);
        return content;
    };
}

void check_parameters(CheckedFile& file, const toml::Node& document) {
    input::ReadResult read =
        input::read_parameter_file(document, file.path, *file.catalogue, loader_of(file), file.findings);
    file.complete = read.usable && !file.findings.has_errors();
    file.sources = std::move(read.file.sources);
    file.settings = std::move(read.file.settings);
    if (!read.usable) {
        return;
    }
    file.configuration = config::resolve(file.settings, *file.catalogue);
    const check::Context context{file.settings, *file.catalogue, file.configuration, file.findings};
    check::check(context);
    if (file.valid()) {
        file.not_verified = check::not_verified(context);
    }
}

// What is no TOML counts as a parameter file.
CheckedFile check_text(const std::string& path, std::string text, bool may_be_catalogue) {
    CheckedFile file = empty_file(path);
    file.settings.path = path;
    const std::optional<toml::Node> root = toml::parse(text, path, file.findings);
    file.is_catalogue = may_be_catalogue && root && catalogue::is_catalogue(*root);
    if (file.is_catalogue) {
        catalogue::read_catalogue(*root, path, *file.catalogue, file.findings);
    } else if (root) {
        check_parameters(file, *root);
    }
    file.sources[path] = std::move(text);
    file.findings.sort();
    return file;
}

CheckedFile check(const std::string& path, bool may_be_catalogue) {
    base::Result<std::string> text = base::read_file(path, toml::maximum_file_size);
    if (!text) {
        CheckedFile file = empty_file(path);
        file.unreadable = report_unreadable(path, text.error(), file.findings);
        return file;
    }
    return check_text(path, std::move(*text), may_be_catalogue);
}

}  // namespace

CheckedFile check_file(const std::string& path) {
    return check(path, false);
}

CheckedFile check_file_or_catalogue(const std::string& path) {
    return check(path, true);
}

CheckedFile check_text(const std::string& path, std::string text) {
    return check_text(path, std::move(text), false);
}

}  // namespace cgw::driver
