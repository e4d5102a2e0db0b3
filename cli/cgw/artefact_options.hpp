// The options that only some artefacts take: --format, --section, …
#pragma once

#include "cli/cgw/command.hpp"
#include "emit/emitter.hpp"

namespace cgw::cli {

std::vector<Word> emitter_words();

// Every format of every emitter; which ones an emitter has, artefact_options() checks.
std::vector<Word> artefact_format_words();

inline constexpr Option emitter_option = {
    .names = "NAME", .summary = "artefact", .required = true, .words = emitter_words};
inline constexpr Option artefact_format_option = {.names = "--format",
                                                  .value = "FORMAT",
                                                  .summary = "form of the artefact, where it has several",
                                                  .words = artefact_format_words,
                                                  .only_words = false};
inline constexpr Option section_option = {.names = "--section",
                                          .value = "NAME",
                                          .summary = "image-source: linker section",
                                          .default_value = ".cgw_config"};
inline constexpr Option alignment_option = {.names = "--align",
                                            .value = "N",
                                            .summary = "image-source, ihex, srec: alignment in bytes",
                                            .default_value = "8"};
inline constexpr Option symbol_option = {.names = "--symbol",
                                         .value = "NAME",
                                         .summary = "image-source: name of the array",
                                         .default_value = "cgw_config_image"};
inline constexpr Option incbin_option = {.names = "--incbin",
                                         .value = "PATH",
                                         .summary = "image-source --format asm: the image file it includes",
                                         .default_value = emit::default_image_file,
                                         .completes = Completes::files};
inline constexpr Option base_option = {
    .names = "--base", .value = "ADDRESS", .summary = "ihex, srec: address of the image in the device"};
inline constexpr Option against_option = {.names = "--against",
                                          .value = "OLD",
                                          .summary = "report: parameter file to show the changes against",
                                          .completes = Completes::files};
inline constexpr Option no_labels_option = {
    .names = "--no-labels",
    .summary = "image, image-source: leave out names and units, which only displays need"};

inline constexpr Option eds_name_option = {
    .names = "--eds-name",
    .value = "NAME",
    .summary = "file name of the data sheets, inside them too; .dcf and .dbc follow",
    .default_value = emit::default_eds_name,
};
inline constexpr Option generic_option = {
    .names = "--generic", .summary = "eds: the manual's data sheet, faults mended; takes no FILE"};

// These throw UsageError when a value is wrong.
unsigned alignment_of(const Arguments& arguments);                           // --align
std::uint64_t address_of(const Arguments& arguments, std::string_view key);  // decimal, or 0x and hexadecimal

// Throws UsageError when a value is wrong or the emitter does not take an option that was given.
std::string eds_name_of(const Arguments& arguments);
emit::Options artefact_options(const Arguments& arguments, const emit::Emitter& emitter);

}  // namespace cgw::cli
