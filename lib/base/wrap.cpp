#include "base/wrap.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace cgw::base {

std::vector<std::string> wrap(std::string_view text, std::size_t width) {
    std::vector<std::string> lines(1);
    while (!text.empty()) {
        const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
        const std::size_t blanks = start;
        text.remove_prefix(start);
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(word.size());
        std::string& line = lines.back();
        const std::string gap(line.empty() && lines.size() > 1 ? 0 : blanks, ' ');
        if (line.empty() || width_of(line) + gap.size() + width_of(word) <= width) {
            line += gap;
            line += word;
        } else if (!word.empty()) {
            lines.emplace_back(word);
        }
    }
    return lines;
}

}  // namespace cgw::base
