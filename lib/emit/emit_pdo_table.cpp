#include "emit/artefacts.hpp"
#include "emit/pdo_rows.hpp"
#include "emit/renderings.hpp"

namespace cgw::emit {
namespace {

constexpr std::array renderings{
    Rendering<PdoTable>{{"text", ""}, render_text},
    Rendering<PdoTable>{{"md", "pdo-table.md"}, render_markdown},
    Rendering<PdoTable>{{"csv", "pdo-table.csv"}, render_csv},
    Rendering<PdoTable>{{"json", "pdo-table.json"}, render_json},
};
constexpr std::array formats = formats_of(renderings);

}  // namespace

std::span<const Format> pdo_table_formats() {
    return formats;
}

base::Bytes emit_pdo_table(const Plant& plant, const Options& options) {
    return base::to_bytes(find_rendering(renderings, options.format).render(pdo_table(plant)));
}

}  // namespace cgw::emit
