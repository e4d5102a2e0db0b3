#include <algorithm>

#include "emit/artefacts.hpp"
#include "emit/pdo_rows.hpp"

namespace cgw::emit {
namespace {

constexpr std::array formats{
    Format{"text", ""},
    Format{"md", "pdo-table.md"},
    Format{"csv", "pdo-table.csv"},
    Format{"json", "pdo-table.json"},
};

// In the order of the formats.
constexpr std::array renderers{render_text, render_markdown, render_csv, render_json};
static_assert(formats.size() == renderers.size());

}  // namespace

std::span<const Format> pdo_table_formats() {
    return formats;
}

base::Bytes emit_pdo_table(const Plant& plant, const Options& options) {
    const auto* const format = std::find_if(formats.begin(), formats.end(),
                                            [&](const Format& row) { return row.name == options.format; });
    const std::size_t position =
        format != formats.end() ? static_cast<std::size_t>(format - formats.begin()) : 0;
    return base::to_bytes(renderers.at(position)(pdo_table(plant)));
}

}  // namespace cgw::emit
