#include "convert/losses.hpp"

#include <fmt/format.h>

namespace cgw::convert {

std::vector<Loss> lose(Description& description, Medium medium) {
    std::vector<Loss> losses;
    for (const LossRow& row : loss_rows()) {
        if (const std::size_t count = row.is_lost_in(medium) ? row.lose(description) : 0; count > 0) {
            losses.push_back({&row, count});
        }
    }
    return losses;
}

std::string losses_markdown() {
    std::string text = "| What | EDS | DCF | XDD | XDC | Markdown | CSV |\n|---|---|---|---|---|---|---|\n";
    for (const LossRow& row : loss_rows()) {
        text += fmt::format("| {} |", row.text);
        for (std::size_t medium = 0; medium < media; ++medium) {
            text += row.is_lost_in(static_cast<Medium>(medium)) ? " lost |" : " held |";
        }
        text += '\n';
    }
    return text;
}

}  // namespace cgw::convert
