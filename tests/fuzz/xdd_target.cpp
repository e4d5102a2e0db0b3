// Any text is read for an XDD or XDC; what has no errors is written, and reads back as it was.
#include "convert/formats.hpp"
#include "fuzz/fuzz.hpp"
#include "xdd/reader.hpp"

namespace cgw::fuzz {
namespace {

constexpr const char* path = "device.xdd";

convert::Description description_of(const std::string& text, diagnostic::Findings& findings) {
    xdd::Sheet sheet = xdd::read(text, path, findings);
    findings.sort();
    return {std::move(sheet.dictionary), std::move(sheet.commissioning)};
}

}  // namespace

void xdd(Input input) {
    const std::string text(input.begin(), input.end());
    diagnostic::Findings findings;
    convert::Description description = description_of(text, findings);
    demand_sound({path, findings.all(), {}}, {{path, text}});
    if (findings.has_errors()) {
        return;
    }
    const bool of_node = description.node && description.node->node_id != 0;
    const auto product =
        convert::convert(description, {.format = *convert::find_format(of_node ? "xdc" : "xdd")});
    demand(product.has_value(), "what is read can be written");
    diagnostic::Findings again;
    const convert::Description back = description_of({product->bytes.begin(), product->bytes.end()}, again);
    demand(again.all().empty(), "nothing is to be said of what cgw writes");
    convert::lose(description, of_node ? convert::Medium::xdc : convert::Medium::xdd);
    demand(back == description, "what is written reads back as it was");
}

}  // namespace cgw::fuzz
