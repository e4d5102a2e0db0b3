#include "dbc/tokens.hpp"

#include "base/ascii.hpp"

namespace cgw::dbc {
namespace {

bool is_of_word(char c) {
    return base::is_letter_or_digit(c) || c == '_';
}

bool is_of_number(char c) {
    return base::is_digit(c) || c == '.' || c == 'e' || c == 'E' || c == '+' || c == '-';
}

class Scanner {
  public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    Tokens run() {
        while (skip_blanks()) {
            take();
        }
        return std::move(tokens_);
    }

  private:
    void step() {
        if (rest_.front() == '\n') {
            ++at_.line;
            at_.column = 1;
            fresh_line_ = true;
        } else {
            ++at_.column;
        }
        rest_.remove_prefix(1);
    }

    bool skip_blanks() {
        while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_.front()) != std::string_view::npos) {
            step();
        }
        return !rest_.empty();
    }

    template <typename Belongs>
    std::string_view take_while(Belongs belongs) {
        const std::string_view from = rest_;
        do {
            step();
        } while (!rest_.empty() && belongs(rest_.front()));
        return from.substr(0, from.size() - rest_.size());
    }

    bool begins_number() const {
        const char first = rest_.front();
        const bool is_signed = first == '-' || first == '+';
        return base::is_digit(first) || (is_signed && rest_.size() > 1 && base::is_digit(rest_[1]));
    }

    void take() {
        Token token;
        token.at = at_;
        token.begins_line = fresh_line_;
        fresh_line_ = false;
        const char first = rest_.front();
        if (first == '"') {
            token.kind = TokenKind::text;
            token.text = take_text();
        } else if (begins_number()) {
            token.kind = TokenKind::number;
            token.text = take_while(is_of_number);
        } else if (is_of_word(first)) {
            token.kind = TokenKind::word;
            token.text = take_while(is_of_word);
        } else {
            token.text = take_while([](char) { return false; });
        }
        tokens_.all.push_back(token);
    }

    std::string_view take_text() {
        const diagnostic::Position begin = at_;
        step();
        const std::string_view from = rest_;
        while (!rest_.empty() && rest_.front() != '"') {
            step();
        }
        const std::string_view text = from.substr(0, from.size() - rest_.size());
        if (rest_.empty()) {
            tokens_.open = begin;
        } else {
            step();
        }
        fresh_line_ = false;
        return text;
    }

    std::string_view rest_;
    diagnostic::Position at_{1, 1};
    bool fresh_line_ = true;
    Tokens tokens_;
};

}  // namespace

Tokens tokens_of(std::string_view text) {
    return Scanner(text).run();
}

}  // namespace cgw::dbc
