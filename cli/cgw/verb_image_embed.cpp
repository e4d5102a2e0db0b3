#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "authoring/from_image.hpp"
#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/artefact_options.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/firmware_input.hpp"
#include "cli/cgw/image_file.hpp"
#include "cli/cgw/image_report.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "diagnostic/rules/firmware.hpp"
#include "firmware_file/embed.hpp"

namespace cgw::cli {
namespace {

using firmware_file::Embedded;
using firmware_file::Replaced;

constexpr std::string_view erased = "0xFF";
constexpr std::string_view zero = "0x00";

std::vector<Word> fill_words() {
    return {{erased, "erased flash memory"}, {zero, "zeros"}};
}

// Where the new file goes; a firmware that somebody may still need is only overwritten when that was said.
std::string output_of(const Arguments& arguments) {
    const bool in_place = arguments.given("--in-place");
    if (in_place == arguments.given("--output")) {
        throw UsageError(in_place ? "--in-place and -o: one of them says where to write"
                                  : "-o PATH says where to write, --in-place changes the file itself");
    }
    std::string firmware = arguments.value("--into");
    if (in_place) {
        return firmware;
    }
    std::string output = arguments.value("--output");
    if (base::same_file(output, firmware)) {
        throw UsageError(fmt::format("-o {}: this is the file itself; --in-place changes it", output));
    }
    return output;
}

std::string replaced_text(const Embedded& embedded) {
    switch (embedded.replaced) {
        case Replaced::nothing:
            return "nothing, the file had no bytes there";
        case Replaced::reserved:
            return "a reserved area";
        case Replaced::image:
            break;
    }
    return fmt::format("an image, configuration id {}", embedded.replaced_id);
}

std::string report(const Arguments& arguments, const std::string& output, const Embedded& embedded,
                   const image::Image& image) {
    const std::string section = arguments.value("--section");
    const std::uint64_t rest = embedded.size - image.bytes().size();
    std::string text = fmt::format("{}\n", image_summary(place_text(output, embedded.address), image));
    if (!section.empty()) {
        text += fmt::format("  section   {}, {} bytes\n", base::printable(section), embedded.size);
    }
    if (rest != 0) {
        text +=
            fmt::format("  filling   {} bytes behind the image with {}\n", rest, arguments.value("--fill"));
    }
    return text + fmt::format("  replaces  {}\n", replaced_text(embedded));
}

// Whole or not at all, and then as it is on the disk.
base::Result<void> write(const std::string& firmware, const std::string& output, const base::Bytes& content) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(firmware, ignored);
    std::optional<std::filesystem::perms> model;  // a program stays one that can be run
    if (std::filesystem::is_regular_file(status)) {
        model = status.permissions();
    }
    if (base::Result<void> written = base::write_file(output, content, model); !written) {
        return written;
    }
    if (!std::filesystem::is_regular_file(output, ignored)) {
        return {};
    }
    const base::Result<std::string> read = base::read_file(output, content.size());
    if (!read || base::to_bytes(*read) != content) {
        return base::failure(fmt::format("{} was written, and reads back otherwise", output));
    }
    return {};
}

tl::unexpected<diagnostic::Diagnostic> other_model() {
    return firmware_file::refuse(diagnostic::rules::image_model,
                                 "the configuration id is not that of the model in the image", {},
                                 "make the image again from its parameter file");
}

int image_embed(const Arguments& arguments) {
    if (arguments.value("--into") == "-") {
        throw UsageError("--into -: a firmware file cannot come from standard input");
    }
    refuse_dash(arguments, "--output");
    const std::string firmware = arguments.value("--into");
    const std::string image_path = arguments.value("IMAGE");
    const std::string output = output_of(arguments);
    refuse_input_as_output(output, {image_path});
    if (arguments.given("--section") == arguments.given("--address")) {
        throw UsageError("--section NAME or --address ADDRESS says where the image goes, one of them");
    }
    const firmware_file::EmbedOptions options{
        target_of(arguments), alignment_of(arguments),
        arguments.value("--fill") == zero ? std::uint8_t{0} : std::uint8_t{0xFF},
        arguments.given("--beside")};
    const LoadedImage loaded = load_image(find_one_in_file(arguments, image_path, std::nullopt));
    if (loaded.exit_code != exit_fine) {
        return loaded.exit_code;
    }
    const base::Result<std::string> read = base::read_file(firmware, largest_firmware_file);
    if (!read) {
        print_error(read.error().message);
        return exit_environment;
    }
    if (!authoring::model_fits(loaded.image)) {
        return report_refusal(arguments, image_path, {}, other_model().value());
    }
    const base::Bytes content = base::to_bytes(*read);
    const firmware_file::Outcome<Embedded> embedded = embed(content, loaded.image, options);
    if (!embedded) {
        return report_refusal(arguments, firmware, content, embedded.error());
    }
    if (const base::Result<void> written = write(firmware, output, embedded->file); !written) {
        print_error(written.error().message);
        return exit_environment;
    }
    return print(report(arguments, output, *embedded, loaded.image)) ? exit_fine : exit_environment;
}

constexpr Option embed_options[] = {
    {.names = "IMAGE",
     .summary = "image, or a file with one in it; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "--into",
     .value = "FILE",
     .summary = "firmware: ELF program, Intel HEX or S-record file",
     .required = true,
     .completes = Completes::files},
    firmware_section_option,
    firmware_address_option,
    {.names = "-o,--output",
     .value = "PATH",
     .summary = "the new firmware file",
     .completes = Completes::files},
    {.names = "--in-place", .summary = "change the firmware file itself"},
    {.names = "--align", .value = "N", .summary = "alignment demanded, in bytes", .default_value = "8"},
    {.names = "--fill",
     .value = "BYTE",
     .summary = "behind the image; what a free area holds",
     .default_value = erased,
     .words = fill_words},
    {.names = "--beside", .summary = "a new place, though an image stands elsewhere in the file"},
    color_option,
};

}  // namespace

const Verb image_embed_verb = {
    "image embed", "put an image into a firmware file", embed_options, image_embed,
    "Replaces an earlier image or a reserved area, never anything else. Checksums\n"
    "that a firmware keeps over itself must be made afterwards.\n"};

}  // namespace cgw::cli
