#include "convert/losses.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cgw::convert {

std::vector<Loss> lose(Description& description, Medium medium) {
    std::vector<Loss> losses;
    for (const LossRow& row : loss_rows()) {
        if (std::find(row.lost_in.begin(), row.lost_in.end(), medium) == row.lost_in.end()) {
            continue;
        }
        if (const std::size_t count = row.lose(description); count > 0) {
            losses.push_back({&row, count});
        }
    }
    return losses;
}

std::string losses_markdown() {
    std::string text = "| What | EDS | DCF | XDD | XDC |\n|---|---|---|---|---|\n";
    for (const LossRow& row : loss_rows()) {
        text += fmt::format("| {} |", row.text);
        for (std::size_t medium = 0; medium < media; ++medium) {
            const bool is_lost = std::find(row.lost_in.begin(), row.lost_in.end(),
                                           static_cast<Medium>(medium)) != row.lost_in.end();
            text += is_lost ? " lost |" : " held |";
        }
        text += '\n';
    }
    return text;
}

}  // namespace cgw::convert
