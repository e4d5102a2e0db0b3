#include "cli/cgw/description_input.hpp"

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"

namespace cgw::cli {

std::optional<std::uint8_t> node_id_of(const Arguments& arguments) {
    if (!arguments.given("--node-id")) {
        return std::nullopt;
    }
    constexpr std::int64_t highest = 127;
    const std::string text = arguments.value("--node-id");
    const auto number = base::parse_integer(text);
    if (!number || *number < 1 || *number > highest) {
        throw UsageError(fmt::format("--node-id {}: a node number is 1 to {}", text, highest));
    }
    return static_cast<std::uint8_t>(*number);
}

driver::DeviceDescription load_description(const Arguments& arguments, const std::string& path,
                                           int& exit_code) {
    auto read = driver::read_device_description(path);
    if (!read) {
        throw UsageError(read.error().message);
    }
    if (!read->findings.all().empty()) {
        diagnostic::RenderInput input;
        input.files.push_back({path, read->findings.all()});
        input.sources = read->sources;
        input.color = use_color(arguments, stderr);
        report_findings(input);
    }
    const int of_this = read->unreadable ? exit_environment : read->valid() ? exit_fine : exit_findings;
    exit_code = worse(exit_code, of_this);
    return std::move(*read);
}

}  // namespace cgw::cli
