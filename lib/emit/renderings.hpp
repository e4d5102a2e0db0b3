// Inside the emit room: an artefact of several forms as one table, its formats beside what renders them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "emit/emitter.hpp"

namespace cgw::emit {

template <typename Content>
struct Rendering {
    Format format;
    std::string (*render)(const Content& content);
};

// The formats alone, as the emitter's row lists them.
template <typename Content, std::size_t count>
constexpr std::array<Format, count> formats_of(const std::array<Rendering<Content>, count>& renderings) {
    std::array<Format, count> formats{};
    for (std::size_t i = 0; i < count; ++i) {
        formats[i] = renderings[i].format;
    }
    return formats;
}

// The first one where there is none of that name.
template <typename Content, std::size_t count>
const Rendering<Content>& find_rendering(const std::array<Rendering<Content>, count>& renderings,
                                         std::string_view name) {
    const auto* const found =
        std::find_if(renderings.begin(), renderings.end(),
                     [name](const Rendering<Content>& row) { return row.format.name == name; });
    return found != renderings.end() ? *found : renderings.front();
}

}  // namespace cgw::emit
