// The generated pages of docs/ are those that the tables give, and their links lead somewhere.
#include "explain/pages.hpp"

#include <gtest/gtest.h>

#include <set>

#include "catalogue/catalogue.hpp"
#include "support/golden.hpp"

namespace {

using cgw::explain::generated_pages;
using cgw::explain::Page;

const std::filesystem::path docs = CGW_DOCS;

TEST(ExplainPages, are_up_to_date_in_docs) {
    const cgw::parameter::Catalogue catalogue{cgw::catalogue::shipped_rows()};
    for (const Page& page : generated_pages()) {
        const std::string made = page.text(catalogue);
        EXPECT_TRUE(made.ends_with("\n") && !made.ends_with("\n\n")) << page.file_name;
        cgw::test::expect_golden("../../docs/" + std::string(page.file_name), made);
    }
}

// Ids that the page defines by <a id="…">.
std::set<std::string> ids_of(const std::string& text) {
    std::set<std::string> ids;
    const std::string mark = "<a id=\"";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
        const std::size_t start = at + mark.size();
        ids.insert(text.substr(start, text.find('"', start) - start));
    }
    return ids;
}

// Every D… after `mark` that leads to the rulings.
void expect_known_rulings(const std::string& text, const std::string& mark, std::string_view name) {
    const std::set<std::string> ids = ids_of(cgw::test::read_text(docs / "rulings.md"));
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
        const std::size_t start = at + mark.size();
        const std::string id = text.substr(start, text.find(')', start) - start);
        EXPECT_TRUE(ids.contains(id)) << name << " links to rulings.md#" << id;
    }
}

TEST(ExplainPages, link_to_rulings_that_exist) {
    const cgw::parameter::Catalogue catalogue{cgw::catalogue::shipped_rows()};
    for (const Page& page : generated_pages()) {
        const std::string text = page.text(catalogue);
        EXPECT_NE(text.find("](rulings.md#d"), std::string::npos) << page.file_name;
        expect_known_rulings(text, "](rulings.md#", page.file_name);
    }
}

// The rulings whose text says **Inference**, and the ones that docs/assumptions.md lists.
TEST(ExplainPages, every_inference_is_an_assumption_and_the_reverse) {
    const std::string rulings = cgw::test::read_text(docs / "rulings.md");
    const std::string assumptions = cgw::test::read_text(docs / "assumptions.md");
    expect_known_rulings(assumptions, "](rulings.md#", "assumptions.md");
    std::set<std::string> inferred;
    const std::string mark = "<a id=\"d";
    for (std::size_t at = rulings.find(mark); at != std::string::npos;) {
        const std::size_t next = rulings.find(mark, at + 1);
        const std::string section = rulings.substr(at, next - at);
        const std::size_t start = mark.size() - 1;
        if (section.find("**Inference") != std::string::npos) {
            inferred.insert(section.substr(start, section.find('"', start) - start));
        }
        at = next;
    }
    std::set<std::string> listed;
    const std::string link = "| [D";
    for (std::size_t at = assumptions.find(link); at != std::string::npos;
         at = assumptions.find(link, at + 1)) {
        const std::size_t start = at + link.size();
        listed.insert("d" + assumptions.substr(start, assumptions.find(']', start) - start));
    }
    EXPECT_GT(listed.size(), 10U);
    EXPECT_EQ(inferred, listed);
}

}  // namespace
