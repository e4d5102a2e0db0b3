#include <fmt/format.h>

#include <cstdio>

#include "authoring/from_image.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/decompile.hpp"

namespace cgw::cli {
namespace {

constexpr Option decompile_options[] = {
    image_option, firmware_section_option, firmware_address_option, text_output_option, force_option,
    color_option,
};

constexpr std::string_view decompile_details =
    "The file compiles to the identical image where the image holds labels and the\n"
    "canonical model. Without them the file is the best that PDOs, buses and objects\n"
    "allow, and only --no-labels makes an image like the old one of it: standard\n"
    "error and the first lines of the file say what is lost. The file is compiled in\n"
    "memory and compared with the image before it is written. Exit code 0 when a\n"
    "gateway with the new image works as with the old one, else 1.\n";

// What became of it, one line each, on stderr; nothing when the image is the identical one.
void report(const std::string& name, const driver::DecompiledImage& decompiled) {
    std::string text;
    for (const std::string& lost : decompiled.lost) {
        text += fmt::format("{}: lost: {}\n", name, lost);
    }
    const std::string_view how = decompiled.labels ? "" : " with --no-labels";
    if (!decompiled.file.valid()) {
        std::fputs(text.c_str(), stderr);
        return;
    }
    if (!decompiled.differing.empty()) {
        text += fmt::format("{}: the file compiles{} to another image, of configuration {}; different: {}\n",
                            name, how, decompiled.new_id, fmt::join(decompiled.differing, ", "));
    } else if (!decompiled.labels) {
        text += fmt::format("{}: the file compiles{} to the identical image\n", name, how);
    }
    if (decompiled.other_version) {
        text += fmt::format("{}: written by another version of cgw{}\n", name,
                            decompiled.differing.empty() ? "; the rest of the image is identical" : "");
    }
    std::fputs(text.c_str(), stderr);
}

int image_decompile(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const std::string output = arguments.value("--output");
    refuse_input_as_output(output, {path});
    refuse_existing_output(arguments, output);
    const LoadedImage loaded = load_image(find_one_in_file(arguments, path, place_of(arguments)));
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    if (!authoring::model_fits(loaded.image)) {
        print_error(
            fmt::format("{}: the configuration id is not that of the model in the image; one of the two "
                        "is not this plant's",
                        loaded.found.name));
        return exit_findings;
    }
    const std::string name = output == "-" ? "<stdout>" : output;
    const driver::DecompiledImage decompiled = driver::decompile(loaded.image, name);
    if (const int written = write_text(output, schema_line(output) + decompiled.text); written != exit_fine) {
        return written;
    }
    report(loaded.found.name, decompiled);
    if (!decompiled.file.valid()) {
        report_findings(driver::check_text(name, schema_line(output) + decompiled.text),
                        use_color(arguments, stderr));
        print_error(fmt::format("{} says what the image says, and is not valid as it stands", name));
    }
    return decompiled.works_alike() ? exit_fine : exit_findings;
}

}  // namespace

const Verb image_decompile_verb = {"image decompile", "write a parameter file that compiles to this image",
                                   decompile_options, image_decompile, decompile_details};

}  // namespace cgw::cli
