#include "simulation/text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/canopen_text.hpp"
#include "simulation/scaling.hpp"

namespace cgw::simulation {
namespace {

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
    if (!has_scaling(image, number)) {
        return fmt::format("{:.1f} % of range", scale_of(image, number, 0, 100).to_engineering(word));
    }
    const Scale scale = scale_of(image, number, 0, 100);
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

}  // namespace cgw::simulation
