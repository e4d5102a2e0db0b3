#include "cli/canopen-gateway/display.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/canopen_text.hpp"
#include "object/vocabulary.hpp"
#include "simulation/scaling.hpp"

namespace cgw::gateway_cli {
namespace {

using object::AbortCode;

struct AbortText {
    AbortCode code;
    std::string_view text;
};

constexpr AbortText abort_texts[] = {
    {AbortCode::timed_out, "no answer in time"},
    {AbortCode::command_unknown, "command not valid or unknown"},
    {AbortCode::unsupported_access, "unsupported access"},
    {AbortCode::write_only, "write-only object"},
    {AbortCode::read_only, "read-only object"},
    {AbortCode::object_missing, "object does not exist"},
    {AbortCode::length_too_high, "length too high"},
    {AbortCode::length_too_low, "length too low"},
    {AbortCode::sub_index_missing, "sub-index does not exist"},
    {AbortCode::general, "general error"},
};

bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// Digits after the point that still mean something for a range of this width.
int decimals(double span) {
    if (span > 2000) {
        return 0;
    }
    return span > 20 ? 1 : 2;
}

}  // namespace

std::string_view to_text(canopen::NmtState state) {
    switch (state) {
        case canopen::NmtState::initialising:
            return "boot-up";
        case canopen::NmtState::stopped:
            return "Stopped";
        case canopen::NmtState::operational:
            return "Operational";
        case canopen::NmtState::pre_operational:
            return "Pre-Operational";
    }
    return "unknown";
}

std::string_view to_text(device::GatewayState state) {
    switch (state) {
        case device::GatewayState::undefined:
            return "Undefined";
        case device::GatewayState::init:
            return "Init";
        case device::GatewayState::pre_operational:
            return "Pre-Operational";
        case device::GatewayState::operational:
            return "Operational";
        case device::GatewayState::stopped:
            return "Stopped";
    }
    return "unknown";
}

std::string abort_text(std::uint32_t code) {
    for (const AbortText& row : abort_texts) {
        if (static_cast<std::uint32_t>(row.code) == code) {
            return fmt::format("abort 0x{:08X}, {}", code, row.text);
        }
    }
    return fmt::format("abort 0x{:08X}", code);
}

std::string clipped(std::string_view text, std::size_t width) {
    std::size_t columns = 0;
    std::size_t cut = 0;  // where the text ends if "..." must follow
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (continues(text[i])) {
            continue;
        }
        if (columns + 3 == width) {
            cut = i;
        }
        if (columns == width) {
            return std::string(text.substr(0, cut)) + "...";
        }
        ++columns;
    }
    return std::string(text);
}

std::string parameter_text(const image::Image& image, std::uint16_t number) {
    image::Label label;
    if (image.find_label(number, label) && !label.name.empty()) {
        return fmt::format("{} {}", number, label.name);
    }
    return fmt::format("{}", number);
}

std::string value_text(const image::Image& image, std::uint16_t number, std::uint16_t word) {
    if (!simulation::has_scaling(image, number)) {
        return fmt::format("{:.1f} % of range",
                           simulation::scale_of(image, number, 0, 100).to_engineering(word));
    }
    const simulation::Scale scale = simulation::scale_of(image, number, 0, 100);
    const int digits = decimals(std::abs(scale.external_maximum - scale.external_minimum));
    std::string text = fmt::format("{:.{}f}", scale.to_engineering(word), digits);
    image::Label label;
    if (image.find_label(number, label) && !label.unit.empty()) {
        text += fmt::format(" {}", label.unit);
    }
    return text;
}

std::string pdo_text(const image::Pdo& pdo) {
    return base::pdo_name(!pdo.receive, pdo.number);
}

}  // namespace cgw::gateway_cli
