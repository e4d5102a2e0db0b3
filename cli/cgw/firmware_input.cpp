#include "cli/cgw/firmware_input.hpp"

#include <fmt/format.h>

#include "base/utf8.hpp"
#include "cli/cgw/artefact_options.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"

namespace cgw::cli {

firmware_file::Target target_of(const Arguments& arguments) {
    if (arguments.given("--section") && arguments.given("--address")) {
        throw UsageError("--section and --address: one of them says where");
    }
    firmware_file::Target target;
    target.section = arguments.value("--section");
    if (arguments.given("--section") && target.section.empty()) {
        throw UsageError("--section: the name is empty");
    }
    if (arguments.given("--address")) {
        target.address = address_of(arguments, "--address");
    }
    return target;
}

std::optional<firmware_file::Target> place_of(const Arguments& arguments) {
    const firmware_file::Target target = target_of(arguments);
    return arguments.given("--section") || arguments.given("--address") ? std::optional(target)
                                                                        : std::nullopt;
}

int report_refusal(const Arguments& arguments, const std::string& path, const base::Bytes& content,
                   diagnostic::Diagnostic finding) {
    finding.where.path = path;
    diagnostic::RenderInput input;
    if (finding.where.range.start.line != 0) {
        input.sources[path] = std::string(content.begin(), content.end());
    }
    input.files.push_back({path, {std::move(finding)}});
    input.color = use_color(arguments, stderr);
    input.verdicts = false;  // the file may be right, and only no place for the image
    report_findings(input);
    return exit_findings;
}

std::string place_text(const std::string& path, std::uint64_t address) {
    return fmt::format("{} at {}", base::printable(path), firmware_file::address_text(address));
}

}  // namespace cgw::cli
