#include <fmt/format.h>

#include <algorithm>

#include "authoring/from_image.hpp"
#include "base/sha256.hpp"
#include "cli/cgw/comparison_format.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "driver/image_parts.hpp"

namespace cgw::cli {
namespace {

constexpr Option image_diff_options[] = {
    {.names = "A",
     .summary = "image, or a file with one in it; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "B",
     .summary = "what it is compared with, likewise",
     .required = true,
     .completes = Completes::files},
    firmware_section_option,
    firmware_address_option,
    comparison_format_option,
    color_option,
};

constexpr std::string_view image_diff_details =
    "Tells what differs in terms of the configuration, as cgw diff does for parameter\n"
    "files. Where one of the two holds no canonical model, both are compared by what\n"
    "a gateway needs to run, and not all parameters are known. Sections of the image\n"
    "are named where no parameter explains that they differ. Exit code 0 when the\n"
    "images are byte for byte the same, 1 when they differ or one is refused, 3 when\n"
    "one cannot be read.\n";

bool holds(const image::Image& image, image::SectionId id) {
    return image.records(id).data != nullptr;
}

bool has_model(const image::Image& image) {
    return holds(image, image::SectionId::model) && authoring::model_fits(image);
}

struct Kind {
    driver::PartKind part;
    std::string_view word;  // of the JSON document
    bool by_itself;         // no parameter explains it
};
constexpr Kind kinds[] = {
    {driver::PartKind::version, "image-version", true},
    {driver::PartKind::format, "image-format", true},
    {driver::PartKind::header, "image-header", true},
    {driver::PartKind::configuration_id, "image-id", false},
    {driver::PartKind::section, "image-section", false},
    {driver::PartKind::later_section, "image-section", true},
};

bool is_left_out(const image::Image& image, const driver::PartDifference& part) {
    return (part.name == "labels" && !holds(image, image::SectionId::labels)) ||
           (part.name == "model" && !holds(image, image::SectionId::model)) ||
           (part.name == "strings" && !holds(image, image::SectionId::strings));
}

// What only images know. Sections and id follow from the parameters: where those differ, they are explained.
void compare_images(const image::Image& a, const image::Image& b, compare::Comparison& comparison) {
    const bool explained = !comparison.same();
    for (const driver::PartDifference& part : driver::differing_parts(a, b)) {
        const Kind& kind = *std::find_if(std::begin(kinds), std::end(kinds),
                                         [&](const Kind& one) { return one.part == part.kind; });
        if (is_left_out(a, part) || is_left_out(b, part)) {
            if (part.name != "strings") {
                const auto presence = [&](const image::Image& image) {
                    return is_left_out(image, part) ? "left out" : "in the image";
                };
                comparison.otherwise.push_back({part.name == "labels" ? "image-labels" : "image-model",
                                                part.name == "labels" ? "labels" : "canonical model",
                                                presence(a), presence(b)});
            }
        } else if (kind.by_itself || !explained) {
            const bool section = part.kind == driver::PartKind::section;
            comparison.otherwise.push_back(
                {kind.word, section ? "section " + part.name : part.name, part.a, part.b});
        }
    }
}

driver::CheckedFile configuration_of(const std::string& path, const image::Image& image,
                                     authoring::Basis basis) {
    return driver::check_text(path, authoring::file_from_image(image, {}, basis).text);
}

compare::Comparison compared(const LoadedImage& a, const LoadedImage& b) {
    if (a.found.bytes == b.found.bytes) {
        return {};
    }
    const bool models = has_model(a.image) && has_model(b.image);
    const bool labels = holds(a.image, image::SectionId::labels) && holds(b.image, image::SectionId::labels);
    const authoring::Basis basis = models   ? authoring::Basis::model
                                   : labels ? authoring::Basis::sections
                                            : authoring::Basis::bare;
    const driver::CheckedFile file_a = configuration_of(a.found.name, a.image, basis);
    const driver::CheckedFile file_b = configuration_of(b.found.name, b.image, basis);
    compare::Comparison comparison =
        compare::compare({file_a.settings, file_a.configuration, *file_a.catalogue},
                         {file_b.settings, file_b.configuration, *file_b.catalogue});
    comparison.all_parameters_known = models;
    compare_images(a.image, b.image, comparison);
    return comparison;
}

int image_diff(const Arguments& arguments) {
    const std::string path_a = arguments.value("A");
    const std::string path_b = arguments.value("B");
    if (path_a == "-" && path_b == "-") {
        throw UsageError("standard input can be read only once");
    }
    const std::optional<firmware_file::Target> place = place_of(arguments);
    const LoadedImage a = load_image(find_one_in_file(arguments, path_a, place, true));
    const LoadedImage b = load_image(find_one_in_file(arguments, path_b, place, true));
    if (a.exit_code != exit_fine || b.exit_code != exit_fine) {
        return worse(a.exit_code, b.exit_code);
    }
    if (place && !a.in_firmware && !b.in_firmware) {
        throw UsageError("--section and --address are for firmware files, and neither of the two is one");
    }
    const compare::Comparison comparison = compared(a, b);
    const compare::SideName name_a{{a.found.name}, base::short_id(a.image.configuration_id())};
    const compare::SideName name_b{{b.found.name}, base::short_id(b.image.configuration_id())};
    const int exit_code = print_comparison(arguments, comparison, name_a, name_b);
    const bool say_so = exit_code == exit_fine && arguments.value("--format") == "text";
    return say_so && !print("The images are byte for byte the same.\n") ? exit_environment : exit_code;
}

}  // namespace

const Verb image_diff_verb = {"image diff", "compare two images in terms of the configuration",
                              image_diff_options, image_diff, image_diff_details};

}  // namespace cgw::cli
