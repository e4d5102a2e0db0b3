#include "convert/unread.hpp"

#include "base/utf8.hpp"
#include "eds/document.hpp"
#include "eds/section_names.hpp"

namespace cgw::convert {

std::vector<std::string> sections_not_read(std::string text) {
    const eds::Document document(std::move(text));
    std::vector<std::string> names;
    for (const eds::Section& section : document.sections()) {
        const eds::SectionKind kind = eds::parse_section_name(document.name(section)).kind;
        if (kind == eds::SectionKind::unknown || kind == eds::SectionKind::tools ||
            kind == eds::SectionKind::dynamic_channels) {
            names.push_back("[" + base::printable(document.name(section)) + "]");
        }
    }
    return names;
}

}  // namespace cgw::convert
