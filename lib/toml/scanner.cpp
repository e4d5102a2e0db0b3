#include "toml/scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "diagnostic/rules/files.hpp"
#include "toml/literal.hpp"
#include "toml/strings.hpp"
#include "toml/tokens.hpp"
#include "toml/tree.hpp"

namespace cgw::toml {
namespace {

// The second judge looks at the whole line, and at the comments above it, for every value, and copies values
// at every level. Its work in these units is bounded here; a file that people write needs a thousandth.
constexpr std::size_t work_limit = 100'000'000;
constexpr std::size_t work_per_level = 150;
constexpr std::size_t work_per_header_part = 2000;

constexpr std::size_t longest_safe_binary = 62;  // digits after 0b that the judge computes without overflow

class Scanner {
  public:
    explicit Scanner(const Source& source) : source_(source), text_(source.text()), judged_(text_) {}

    ScanResult run() {
        at_ = text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
        for (skip_lines(); at_ < text_.size(); skip_lines()) {
            if (text_[at_] == '[') {
                header();
            } else {
                key_and_value(table_, 0);
            }
            end_of_line();
        }
        return {tree_.take(), std::move(out_of_range_), std::move(judged_)};
    }

  private:
    bool next_is(char c) const { return at_ < text_.size() && text_[at_] == c; }
    bool at_line_end() const { return at_ == text_.size() || next_is('\n') || next_is('\r'); }

    bool take(char c) {
        const bool found = next_is(c);
        at_ += found ? 1 : 0;
        return found;
    }

    void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }

    void skip_comment() {
        if (next_is('#')) {
            at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
        }
    }

    void skip_lines() {
        while (at_ < text_.size()) {
            at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
            if (!next_is('#')) {
                return;
            }
            skip_comment();
        }
    }

    [[noreturn]] void fail(std::string message, std::string help = {}) const {
        fail_at(source_.range(at_, at_ + 1), std::move(message), std::move(help));
    }

    [[noreturn]] static void fail_at(const diagnostic::Range& where, std::string message,
                                     std::string help = {}) {
        throw Complaint{&diagnostic::rules::toml_syntax, where, std::move(message), std::move(help)};
    }

    void end_of_line() {
        skip_blanks();
        skip_comment();
        if (at_line_end()) {
            return;
        }
        fail(fmt::format("expected the end of the line, found {}", describe(source_, at_)),
             next_is(',') ? "decimal numbers have a point; several values stand between [ and ]" : "");
    }

    void charge(std::size_t work, std::size_t where) {
        work_ += work;
        if (work_ > work_limit) {
            throw Complaint{&diagnostic::rules::file_too_large, source_.range(where, where + 1),
                            "the file has too many values on too long lines",
                            "break lists over several lines"};
        }
    }

    KeyPart key_part() {
        const std::size_t begin = at_;
        if (next_is('"') || next_is('\'')) {
            StringLiteral literal = read_string(source_, at_, false);
            at_ = literal.end;
            return {std::move(literal.content), source_.range(begin, at_)};
        }
        while (at_ < text_.size() && is_bare_key_character(text_[at_])) {
            ++at_;
        }
        if (at_ == begin) {
            fail(fmt::format("expected a key, found {}", describe(source_, at_)));
        }
        return {std::string(text_.substr(begin, at_ - begin)), source_.range(begin, at_)};
    }

    std::vector<KeyPart> key_path() {
        std::vector<KeyPart> path;
        do {
            skip_blanks();
            path.push_back(key_part());
            skip_blanks();
            if (path.size() > static_cast<std::size_t>(maximum_nesting)) {
                throw Complaint{&diagnostic::rules::toml_nesting, path.back().range,
                                fmt::format("a key has more than {} parts", maximum_nesting)};
            }
        } while (take('.'));
        return path;
    }

    void header() {
        const std::size_t begin = at_++;
        const bool is_array = take('[');
        const std::vector<KeyPart> path = key_path();
        const std::string_view close = is_array ? "]]" : "]";
        if (text_.substr(at_, close.size()) != close) {
            fail(fmt::format("expected '{}' at the end of the table's name, found {}", close,
                             describe(source_, at_)),
                 "a name with blanks or other signs stands in quotes");
        }
        at_ += close.size();
        charge(path.size() * work_per_header_part, begin);
        const diagnostic::Range range = source_.range(begin, at_);
        table_ = is_array ? tree_.open_array_element(path, range) : tree_.open_table(path, range);
    }

    void key_and_value(Tree::Id table, std::size_t level) {
        const std::size_t begin = at_;
        const std::vector<KeyPart> path = key_path();
        if (!next_is('=')) {
            fail(fmt::format("expected '=' after the key, found {}", describe(source_, at_)),
                 "a key with blanks, brackets or other signs stands in quotes");
        }
        ++at_;
        charge(path.size() * (source_.line_and_comments(begin) + work_per_level), begin);
        const Tree::Id id = tree_.add(table, path);
        skip_blanks();
        if (at_line_end() || next_is('#')) {
            fail("there is no value after '='");
        }
        value(id, level);
    }

    void value(Tree::Id id, std::size_t level) {
        const std::size_t begin = at_;
        charge(source_.line_and_comments(begin) + level * work_per_level, begin);
        Kind kind = Kind::string;
        if (next_is('"') || next_is('\'')) {
            StringLiteral read = read_string(source_, at_, true);
            at_ = read.end;
            tree_.value(id).text = std::move(read.content);
        } else if (next_is('[')) {
            kind = Kind::array;
            tree_.value(id).kind = kind;
            array(id, level + 1);
        } else if (next_is('{')) {
            kind = Kind::table;
            inline_table(id, level + 1);
        } else {
            literal(id);
            kind = tree_.value(id).kind;
        }
        tree_.value(id).kind = kind;
        tree_.value(id).range = source_.range(begin, at_);
    }

    void array(Tree::Id id, std::size_t level) {
        const std::size_t begin = at_++;
        while (true) {
            skip_lines();
            if (take(']')) {
                return;
            }
            check_closed(begin, "list", ']');
            value(tree_.append(id, source_.range(at_, at_ + 1)), level);
            skip_lines();
            if (!take(',') && !next_is(']')) {
                check_closed(begin, "list", ']');
                fail(fmt::format("expected ',' or ']' in the list, found {}", describe(source_, at_)));
            }
        }
    }

    void check_closed(std::size_t begin, std::string_view what, char close) {
        if (at_ == text_.size()) {
            fail_at(source_.range(begin, begin + 1),
                    fmt::format("the {} that begins here is not closed by '{}'", what, close));
        }
    }

    void inline_table(Tree::Id id, std::size_t level) {
        const std::size_t begin = at_++;
        skip_blanks();
        if (take('}')) {
            return;
        }
        while (true) {
            check_inline_table_line(begin);
            key_and_value(id, level);
            skip_blanks();
            if (take('}')) {
                return;
            }
            check_inline_table_line(begin);
            if (!take(',')) {
                fail(fmt::format("expected ',' or '}}' in the inline table, found {}",
                                 describe(source_, at_)));
            }
            skip_blanks();
            if (next_is('}')) {
                fail("an inline table ends without a comma");
            }
        }
    }

    void check_inline_table_line(std::size_t begin) {
        check_closed(begin, "inline table", '}');
        if (at_line_end() || next_is('#')) {
            fail_at(source_.range(begin, begin + 1),
                    "the inline table that begins here does not end on its line",
                    "an inline table stands on one line");
        }
    }

    void literal(Tree::Id id) {
        const std::string_view token = literal_token(text_, at_);
        if (token.empty()) {
            fail(fmt::format("expected a value, found {}", describe(source_, at_)));
        }
        Literal read = read_literal(token);
        const diagnostic::Range range = source_.range(at_, at_ + token.size());
        if (read.verdict == Verdict::not_a_value) {
            fail_at(range, fmt::format("'{}' is not a value", shortened(token)), advice_about(token));
        }
        if (read.verdict == Verdict::out_of_range) {
            const std::string_view limits =
                read.node.kind == Kind::integer ? "64 bits with sign" : "a double-precision number";
            out_of_range_.push_back({&diagnostic::rules::toml_number_range, range,
                                     fmt::format("{} does not fit {}", shortened(token), limits)});
        }
        if (read.node.notation == Notation::binary && token.size() - 2 > longest_safe_binary) {
            std::fill_n(judged_.begin() + static_cast<std::ptrdiff_t>(at_), token.size(), '1');
        }
        tree_.value(id) = std::move(read.node);
        at_ += token.size();
    }

    const Source& source_;
    std::string_view text_;
    std::size_t at_ = 0;
    Tree tree_;
    Tree::Id table_ = Tree::root;
    std::size_t work_ = 0;
    std::vector<Complaint> out_of_range_;
    std::string judged_;
};

}  // namespace

ScanResult scan(const Source& source) {
    return Scanner(source).run();
}

}  // namespace cgw::toml
