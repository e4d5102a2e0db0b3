#include <gtest/gtest.h>
#include "explain/explain.hpp"
#include "explain/lists.hpp"
#include "catalogue/catalogue.hpp"
#include <cstdlib>
#include <cstdio>
TEST(A, b) {
    cgw::parameter::Catalogue c(cgw::catalogue::shipped_rows());
    if (const char* q = std::getenv("Q")) {
        std::vector<cgw::explain::Answer> answers;
        std::string text(q);
        for (std::size_t at = 0; at <= text.size();) { auto e = std::min(text.find(';', at), text.size()); answers.push_back(cgw::explain::explain(text.substr(at, e - at), c)); at = e + 1; }
        std::printf("%s", cgw::explain::render_text(answers).c_str());
        for (auto& a : answers) if (!a.understood()) std::printf("** %s | %s\n", a.complaint.c_str(), a.help.c_str());
    }
    if (const char* q = std::getenv("L")) {
        const std::string w(q); const auto* f = cgw::explain::find_table_format(std::getenv("F"));
        auto t = w == "p" ? cgw::explain::parameter_list(c, {}, f->for_people) : w == "c" ? cgw::explain::check_list() : cgw::explain::code_list(c, {});
        std::printf("%s", f->render(t).c_str());
    }
}
