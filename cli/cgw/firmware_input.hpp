// Firmware files as the verbs of `cgw image` take them.
#pragma once

#include <optional>
#include <string>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "cli/cgw/command.hpp"
#include "firmware_file/find_image.hpp"

namespace cgw::cli {

inline constexpr std::size_t largest_firmware_file = std::size_t{256} * 1024 * 1024;

inline constexpr Option firmware_section_option = {
    .names = "--section", .value = "NAME", .summary = "section of an ELF program that has the image"};
inline constexpr Option firmware_address_option = {
    .names = "--address", .value = "ADDRESS", .summary = "address where the program sees the image"};

// Of the two options above; throws UsageError when both are given.
firmware_file::Target target_of(const Arguments& arguments);

// The same; nullopt when neither is given.
std::optional<firmware_file::Target> place_of(const Arguments& arguments);

// Prints the finding about a file on stderr, with the line it speaks of; returns exit_findings.
int report_refusal(const Arguments& arguments, const std::string& path, const base::Bytes& content,
                   diagnostic::Diagnostic finding);

// "fw.elf at 0x08010000", for people.
std::string place_text(const std::string& path, std::uint64_t address);

}  // namespace cgw::cli
