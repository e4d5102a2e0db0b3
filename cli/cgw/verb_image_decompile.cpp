#include <fmt/format.h>

#include <cstdio>

#include "authoring/from_image.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/decompile.hpp"

namespace cgw::cli {
namespace {

constexpr Option decompile_options[] = {
    image_option,
    text_output_option,
    force_option,
    color_option,
};

constexpr std::string_view decompile_details =
    "The file compiles to the identical image where the image holds labels and the\n"
    "canonical model. Without them the file is the best that PDOs, buses and objects\n"
    "allow: standard error and the first lines of the file say what is lost. The file\n"
    "is compiled in memory and compared with the image before it is written. Exit\n"
    "code 0 when a gateway with the new image works as with the old one, else 1.\n";

// What became of it, one line each, on stderr; nothing when the image is the identical one.
void report(const std::string& path, const driver::DecompiledImage& decompiled) {
    const std::string name = base::printable(path);
    std::string text;
    for (const std::string& lost : decompiled.lost) {
        text += fmt::format("{}: lost: {}\n", name, lost);
    }
    if (decompiled.other_version) {
        text +=
            fmt::format("{}: written by another version of cgw; the rest of the image is identical\n", name);
    }
    if (decompiled.file.valid() && !decompiled.differing.empty()) {
        text += fmt::format("{}: the file compiles to another image, of configuration {}; different: {}\n",
                            name, decompiled.new_id, fmt::join(decompiled.differing, ", "));
    }
    std::fputs(text.c_str(), stderr);
}

int image_decompile(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const std::string output = arguments.value("--output");
    refuse_input_as_output(output, {path});
    refuse_existing_output(arguments, output);
    const LoadedImage loaded = load_image(path);
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    if (!authoring::model_fits(loaded.image)) {
        print_error(
            fmt::format("{}: the configuration id is not that of the model in the image; one of the two "
                        "is not this plant's",
                        path));
        return exit_findings;
    }
    const std::string name = output == "-" ? "<stdout>" : output;
    const driver::DecompiledImage decompiled = driver::decompile(loaded.image, name);
    if (const int written = write_text(output, schema_line(output) + decompiled.text); written != exit_fine) {
        return written;
    }
    report(path, decompiled);
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
