#include <fmt/format.h>

#include "catalogue/objects.hpp"
#include "explain/entries.hpp"
#include "explain/wording.hpp"

namespace cgw::explain {

namespace {

using catalogue::ErrorDescription;
using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using parameter::Row;

std::vector<std::string> copies(std::span<const std::string_view> texts) {
    return {texts.begin(), texts.end()};
}

std::string references(std::span<const std::uint16_t> numbers, const ErrorDescription& error,
                       const Catalogue& catalogue) {
    std::string text;
    for (const std::uint16_t number : numbers) {
        const Device device = error.gateway ? Device::gateway : Device::governor;
        text += fmt::format("{}{}", text.empty() ? "" : ", ",
                            reference_text(number, device, error.program, catalogue));
    }
    return text;
}

std::string devices_text(const ErrorDescription& error) {
    if (error.governor && error.gateway) {
        return "governor and gateway";
    }
    return program_text(error.governor ? Device::governor : Device::gateway, error.program);
}

// A key is the name of what has no number of its own.
std::string name_of(const ErrorDescription& error, const Catalogue& catalogue) {
    if (error.number == 0) {
        return std::string(error.key);
    }
    const Row* row =
        catalogue.find(error.gateway ? Device::gateway : Device::governor, error.program, error.number);
    return row != nullptr ? label(*row) : fmt::format("{}", error.number);
}

}  // namespace

std::string reference_text(std::uint16_t number, Device device, Program program, const Catalogue& catalogue) {
    if (const Row* row = catalogue.find(device, program, number)) {
        return label(*row);
    }
    for (const Device other : {Device::governor, Device::gateway}) {
        if (const Row* row = catalogue.find(other, program, number)) {
            return fmt::format("{} {}", to_text(other), label(*row));
        }
    }
    return fmt::format("{}", number);
}

Entry error_entry(const ErrorDescription& error, const Catalogue& catalogue) {
    Entry entry{"error", fmt::format("error {} ({})", name_of(error, catalogue), devices_text(error)), {}};
    entry.add("cause", copies(error.cause));
    entry.add("response", copies(error.response));
    entry.add("action", copies(error.action));
    entry.add("clears", error.clears);
    entry.add("read", references(error.with, error, catalogue));
    if (error.counter != 0) {
        const std::uint16_t counter[] = {error.counter};
        entry.add("counter", fmt::format("{} counts it in the permanent error memory",
                                         references(counter, error, catalogue)));
    }
    entry.add("see also", references(error.see, error, catalogue));
    entry.add("source", error.section);
    return entry;
}

}  // namespace cgw::explain
