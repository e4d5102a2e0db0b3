#include <fmt/format.h>

#include <algorithm>

#include "authoring/from_image.hpp"
#include "base/sha256.hpp"
#include "cli/cgw/comparison_format.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "inspect/fields.hpp"

namespace cgw::cli {
namespace {

constexpr Option image_diff_options[] = {
    {.names = "A", .summary = "configuration image", .required = true, .completes = Completes::files},
    {.names = "B",
     .summary = "configuration image to compare with",
     .required = true,
     .completes = Completes::files},
    comparison_format_option,
};

constexpr std::string_view image_diff_details =
    "Tells what differs in terms of the configuration, as cgw diff does for parameter\n"
    "files. Where one of the two holds no canonical model, both are compared by what\n"
    "a gateway needs to run. Exit code 0 when the images are byte for byte the same,\n"
    "1 when they differ or one is refused, 3 when one cannot be read.\n";

void note(compare::Comparison& comparison, std::string_view kind, std::string subject, std::string a,
          std::string b) {
    if (a != b) {
        comparison.otherwise.push_back({kind, std::move(subject), std::move(a), std::move(b)});
    }
}

bool holds(const image::Image& image, image::SectionId id) {
    return image.records(id).data != nullptr;
}

bool has_model(const image::Image& image) {
    return holds(image, image::SectionId::model) && authoring::model_fits(image);
}

std::string presence(const image::Image& image, image::SectionId id) {
    return holds(image, id) ? "in the image" : "left out";
}

bool same_bytes(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// What only images know.
void compare_images(const image::Image& a, const image::Image& b, compare::Comparison& comparison) {
    note(comparison, "image-format", "format of the image",
         fmt::format("{}.{}", a.format_major(), a.format_minor()),
         fmt::format("{}.{}", b.format_major(), b.format_minor()));
    note(comparison, "image-version", "written by", "cgw " + tool_version_text(a),
         "cgw " + tool_version_text(b));
    note(comparison, "image-labels", "labels", presence(a, image::SectionId::labels),
         presence(b, image::SectionId::labels));
    note(comparison, "image-model", "canonical model", presence(a, image::SectionId::model),
         presence(b, image::SectionId::model));
}

// Images can differ where no parameter does: one was changed by other means than cgw.
void compare_sections(const image::Image& a, const image::Image& b, compare::Comparison& comparison) {
    for (const inspect::Record& record : inspect::all_records()) {
        const image::Records& of_a = a.records(record.section);
        const image::Records& of_b = b.records(record.section);
        if (record.is_section() && !same_bytes({of_a.data, of_a.size}, {of_b.data, of_b.size})) {
            comparison.otherwise.push_back({"image-section", fmt::format("section {}", record.name),
                                            fmt::format("{} bytes", of_a.size),
                                            fmt::format("{} other bytes", of_b.size)});
        }
    }
    if (comparison.same()) {
        comparison.otherwise.push_back({"image-section", "header", "these bytes", "other bytes"});
    }
}

driver::CheckedFile configuration_of(const std::string& path, const image::Image& image,
                                     authoring::Basis basis) {
    return driver::check_text(path, authoring::file_from_image(image, {}, basis).text);
}

int image_diff(const Arguments& arguments) {
    const std::string path_a = arguments.value("A");
    const std::string path_b = arguments.value("B");
    const LoadedImage a = load_image(path_a);
    const LoadedImage b = load_image(path_b);
    if (a.exit_code != exit_fine || b.exit_code != exit_fine) {
        return std::max(a.exit_code, b.exit_code);
    }
    const compare::SideName name_a{{path_a}, base::short_id(a.image.configuration_id())};
    const compare::SideName name_b{{path_b}, base::short_id(b.image.configuration_id())};
    compare::Comparison comparison;
    if (!same_bytes(a.bytes, b.bytes)) {
        const bool models = has_model(a.image) && has_model(b.image);
        const bool labels =
            holds(a.image, image::SectionId::labels) && holds(b.image, image::SectionId::labels);
        const authoring::Basis basis = models   ? authoring::Basis::model
                                       : labels ? authoring::Basis::sections
                                                : authoring::Basis::bare;
        const driver::CheckedFile file_a = configuration_of(path_a, a.image, basis);
        const driver::CheckedFile file_b = configuration_of(path_b, b.image, basis);
        comparison = compare::compare({file_a.settings, file_a.configuration, *file_a.catalogue},
                                      {file_b.settings, file_b.configuration, *file_b.catalogue});
        compare_images(a.image, b.image, comparison);
        if (comparison.same()) {
            compare_sections(a.image, b.image, comparison);
        }
    }
    const int exit_code = print_comparison(arguments, comparison, name_a, name_b);
    const bool say_so = exit_code == exit_fine && arguments.value("--format") == "text";
    return say_so && !print("The images are byte for byte the same.\n") ? exit_environment : exit_code;
}

}  // namespace

const Verb image_diff_verb = {"image diff", "compare two images in terms of the configuration",
                              image_diff_options, image_diff, image_diff_details};

}  // namespace cgw::cli
