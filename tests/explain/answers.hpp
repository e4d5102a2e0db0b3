// Asks `cgw explain`, and says in short what the answer holds.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "catalogue/catalogue.hpp"
#include "explain/explain.hpp"

namespace cgw::explain {

using parameter::Catalogue;

class Explain : public testing::Test {
  protected:
    Answer ask(std::string_view question) const { return explain::explain(question, catalogue); }

    std::string titles(std::string_view question) const {
        std::string text;
        for (const Entry& entry : ask(question).entries) {
            text += (text.empty() ? "" : " | ") + entry.title;
        }
        return text;
    }

    // Lines of a field of the answer's entry number `at`, joined by " / "; "-" when there is no such field.
    std::string field(std::string_view question, std::string_view label, std::size_t at = 0) const {
        const Answer answer = ask(question);
        if (at >= answer.entries.size()) {
            return "no entry";
        }
        for (const Field& one : answer.entries[at].fields) {
            if (one.label == label) {
                std::string text;
                for (const std::string& line : one.lines) {
                    text += (text.empty() ? "" : " / ") + line;
                }
                return text;
            }
        }
        return "-";
    }

    std::string complaint(std::string_view question) const {
        const Answer answer = ask(question);
        EXPECT_FALSE(answer.understood()) << question;
        return answer.complaint + (answer.help.empty() ? "" : " | " + answer.help);
    }

    Catalogue catalogue{catalogue::shipped_rows()};
};

}  // namespace cgw::explain
