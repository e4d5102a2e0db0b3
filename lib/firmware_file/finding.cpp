#include "firmware_file/finding.hpp"

#include <fmt/format.h>

namespace cgw::firmware_file {

tl::unexpected<diagnostic::Diagnostic> refuse(const diagnostic::Rule& rule, std::string message,
                                              diagnostic::Range where, std::string help) {
    diagnostic::Diagnostic finding;
    finding.rule = &rule;
    finding.message = std::move(message);
    finding.where.range = where;
    finding.help = std::move(help);
    return tl::unexpected<diagnostic::Diagnostic>(std::move(finding));
}

std::string address_text(std::uint64_t address) {
    return fmt::format("0x{:08X}", address);
}

}  // namespace cgw::firmware_file
