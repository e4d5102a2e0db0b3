#include "dbc/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "dbc/attributes.hpp"
#include "dbc/tokens.hpp"
#include "dbc/words.hpp"
#include "diagnostic/rules/dbc.hpp"

namespace cgw::dbc {
namespace {

namespace rules = diagnostic::rules;

constexpr std::uint32_t extended_flag = 0x80000000;

// What ends the reading of one statement: it is not as the format has it.
struct Unreadable {
    const Token* token;  // nullptr: the file ends
    std::string_view wanted;
};

class Reader {
  public:
    Reader(std::string_view text, const std::string& path, diagnostic::Findings& findings)
        : tokens_(tokens_of(text)), path_(path), findings_(findings) {}

    Database run() {
        if (tokens_.open.line != 0) {
            report(rules::dbc_text, tokens_.open, 1, "this text is not closed by a quote");
        }
        while (next_ < tokens_.all.size()) {
            const std::size_t statement = next_;
            try {
                read_statement();
            } catch (const Unreadable& mistake) {
                complain(mistake);
            }
            skip_to_next_statement(statement);
        }
        attributes_.apply(database_.messages);
        if (database_.messages.empty()) {
            findings_.report(
                {&rules::dbc_text, "the file has no message: it is no CAN database", {path_, {}}});
        }
        return std::move(database_);
    }

  private:
    void report(const diagnostic::Rule& rule, diagnostic::Position at, std::size_t length,
                std::string message) {
        const diagnostic::Position end{at.line, at.column + static_cast<std::uint32_t>(length)};
        findings_.report({&rule, std::move(message), {path_, {at, end}}});
    }

    void complain(const Unreadable& mistake) {
        const Token& token = mistake.token != nullptr ? *mistake.token : tokens_.all.back();
        report(rules::dbc_statement, token.at, token.text.size(),
               mistake.token != nullptr
                   ? fmt::format("{} is wanted here, not `{}`", mistake.wanted, base::printable(token.text))
                   : fmt::format("the file ends where {} is wanted", mistake.wanted));
    }

    void skip_to_next_statement(std::size_t statement) {
        next_ = std::max(next_, statement + 1);
        while (next_ < tokens_.all.size() && !tokens_.all[next_].begins_line) {
            ++next_;
        }
    }

    const Token* peek(std::size_t ahead = 0) const {
        return next_ + ahead < tokens_.all.size() ? &tokens_.all[next_ + ahead] : nullptr;
    }
    const Token& take(TokenKind kind, std::string_view wanted) {
        const Token* const token = peek();
        if (token == nullptr || token->kind != kind) {
            throw Unreadable{token, wanted};
        }
        ++next_;
        return *token;
    }
    void take_sign(std::string_view sign) {
        const Token* const token = peek();
        if (token == nullptr || token->kind != TokenKind::sign || token->text != sign) {
            throw Unreadable{token, sign};
        }
        ++next_;
    }
    bool is_next(TokenKind kind) const { return peek() != nullptr && peek()->kind == kind; }

    std::uint32_t take_natural(std::string_view wanted, std::uint32_t highest) {
        const Token& token = take(TokenKind::number, wanted);
        const auto number = base::parse_integer(token.text);
        if (!number || *number < 0 || *number > std::int64_t{highest}) {
            throw Unreadable{&token, wanted};
        }
        return static_cast<std::uint32_t>(*number);
    }
    double take_real(std::string_view wanted) {
        const Token& token = take(TokenKind::number, wanted);
        const auto number = base::parse_real(token.text);
        if (!number) {
            throw Unreadable{&token, wanted};
        }
        return *number;
    }

    void read_statement() {
        const Token& keyword = tokens_.all[next_++];
        if (keyword.text == "VERSION" && is_next(TokenKind::text)) {
            database_.version = peek()->text;
        } else if (keyword.text == "BU_" && peek() != nullptr && peek()->text == ":") {
            read_nodes();
        } else if (keyword.text == "BO_") {
            read_message();
        } else if (keyword.text == "SG_") {
            read_signal(keyword);
        } else if (keyword.text == "BA_DEF_" && peek() != nullptr && peek()->text == "BO_") {
            read_definition();
        } else if (keyword.text == "BA_DEF_DEF_" && is_next(TokenKind::text)) {
            read_default();
        } else if (keyword.text == "BA_" && is_next(TokenKind::text)) {
            read_attribute();
        } else if (keyword.text == "VAL_" && is_next(TokenKind::number)) {
            read_values();
        }
    }

    void read_nodes() {
        take_sign(":");
        while (is_next(TokenKind::word) && !peek()->begins_line) {
            database_.nodes.emplace_back().name = peek()->text;
            ++next_;
        }
    }

    void read_message() {
        const Token& at = *(peek() != nullptr ? peek() : &tokens_.all.back());
        message_ = nullptr;
        message_seen_ = true;
        const std::uint32_t identifier = take_natural("the identifier of a message", ~std::uint32_t{0});
        Message message;
        message.name = take(TokenKind::word, "the name of a message").text;
        take_sign(":");
        message.length = static_cast<std::uint8_t>(take_natural("its length in bytes", 64));
        message.sender = take(TokenKind::word, "the node that sends it").text;
        if ((identifier & extended_flag) != 0) {
            return;  // CANopen has none
        }
        if (identifier > 0x7FF) {
            throw Unreadable{&at, "an identifier of 11 bits"};
        }
        message.identifier = static_cast<std::uint16_t>(identifier);
        if (!by_identifier_.emplace(message.identifier, database_.messages.size()).second) {
            report(rules::dbc_twice, at.at, at.text.size(),
                   fmt::format("identifier {} stands in the file already; this message is not read",
                               identifier));
            return;
        }
        message_ = &database_.messages.emplace_back(std::move(message));
    }

    void read_signal(const Token& keyword) {
        if (message_ == nullptr) {
            if (!message_seen_) {
                throw Unreadable{&keyword, "a message (BO_)"};
            }
            return;  // of a message that is not read
        }
        Signal signal;
        signal.name = take(TokenKind::word, "the name of a signal").text;
        if (is_next(TokenKind::word)) {
            signal.multiplexing = take(TokenKind::word, "M or m").text;
        }
        take_sign(":");
        signal.start_bit = take_natural("the first bit of a signal", 511);
        take_sign("|");
        signal.length = take_natural("its length in bits", 512);
        take_sign("@");
        read_layout(signal);
        take_sign("(");
        signal.factor = take_real("a factor");
        take_sign(",");
        signal.offset = take_real("an offset");
        take_sign(")");
        take_sign("[");
        signal.minimum = take_real("a minimum");
        take_sign("|");
        signal.maximum = take_real("a maximum");
        take_sign("]");
        signal.unit = take(TokenKind::text, "a unit in quotes").text;
        read_receivers(signal);
        message_->signals.push_back(std::move(signal));
    }

    // Between them commas, after which some files have blanks, or blanks alone.
    void read_receivers(Signal& signal) {
        while (peek() != nullptr && !peek()->begins_line &&
               (is_next(TokenKind::word) || peek()->text == ",")) {
            if (is_next(TokenKind::word) && peek()->text != nobody) {
                signal.receivers.emplace_back(peek()->text);
            }
            ++next_;
        }
    }

    // "1+" is one token where nothing stands between: little-endian, unsigned.
    void read_layout(Signal& signal) {
        const Token& order = take(TokenKind::number, "the byte order, 0 or 1");
        signal.big_endian = order.text.front() == '0';
        std::string_view sign = order.text.substr(1);
        if (sign.empty()) {
            sign = take(TokenKind::sign, "+ or -").text;
        }
        if ((order.text.front() != '0' && order.text.front() != '1') || (sign != "+" && sign != "-")) {
            throw Unreadable{&order, "byte order and sign, as in 1+"};
        }
        signal.is_signed = sign == "-";
    }

    Message* find(std::uint32_t identifier) {
        const auto found = by_identifier_.find(static_cast<std::uint16_t>(identifier & 0x7FF));
        return identifier <= 0x7FF && found != by_identifier_.end() ? &database_.messages[found->second]
                                                                    : nullptr;
    }

    // BA_DEF_ BO_ "GenMsgSendType" ENUM "Cyclic","Spontaneous": values may count these words.
    void read_definition() {
        ++next_;
        const std::string_view name = take(TokenKind::text, "the name of an attribute").text;
        if (name != send_type_attribute && name != frame_format_attribute) {
            return;
        }
        auto& words =
            name == send_type_attribute ? attributes_.send_type_words : attributes_.frame_format_words;
        while (peek() != nullptr && !peek()->begins_line) {
            if (is_next(TokenKind::text)) {
                words.push_back(peek()->text);
            }
            ++next_;
        }
    }

    std::uint32_t take_cycle_time() { return take_natural("a cycle time in ms", 0x7FFFFFFF); }

    std::string_view take_word(std::string_view wanted) {
        return take(is_next(TokenKind::text) ? TokenKind::text : TokenKind::number, wanted).text;
    }
    std::string_view take_send_type() { return take_word("a send type"); }
    std::string_view take_frame_format() { return take_word("a frame format"); }

    void read_default() {
        const std::string_view name = take(TokenKind::text, "the name of an attribute").text;
        if (name == cycle_time_attribute) {
            attributes_.default_cycle_time = take_cycle_time();
        } else if (name == send_type_attribute) {
            attributes_.default_send_type = take_send_type();
        } else if (name == frame_format_attribute) {
            attributes_.default_frame_format = take_frame_format();
        }
    }

    void read_attribute() {
        const std::string_view name = take(TokenKind::text, "the name of an attribute").text;
        const bool is_known =
            name == cycle_time_attribute || name == send_type_attribute || name == frame_format_attribute;
        if (!is_known || peek() == nullptr || peek()->text != "BO_") {
            return;
        }
        ++next_;
        const std::uint32_t identifier = take_natural("the identifier of a message", ~std::uint32_t{0});
        if (name == cycle_time_attribute) {
            attributes_.cycle_times[identifier] = take_cycle_time();
        } else if (name == frame_format_attribute) {
            attributes_.frame_formats[identifier] = take_frame_format();
        } else {
            attributes_.send_types[identifier] = take_send_type();
        }
    }

    void read_values() {
        Message* const message = find(take_natural("the identifier of a message", ~std::uint32_t{0}));
        const std::string_view name = take(TokenKind::word, "the name of a signal").text;
        std::vector<NamedValue> values;
        while (is_next(TokenKind::number)) {
            const auto number = base::parse_integer(peek()->text);
            ++next_;
            const std::string_view text = take(TokenKind::text, "a text in quotes").text;
            values.push_back({static_cast<std::uint32_t>(number.value_or(0)), std::string(text)});
        }
        if (message != nullptr) {
            const auto signal = std::find_if(message->signals.begin(), message->signals.end(),
                                             [&](const Signal& each) { return each.name == name; });
            if (signal != message->signals.end()) {
                signal->values = std::move(values);
            }
        }
    }

    Tokens tokens_;
    std::size_t next_ = 0;
    const std::string& path_;
    diagnostic::Findings& findings_;
    Database database_;
    Attributes attributes_;
    std::map<std::uint16_t, std::size_t> by_identifier_;
    bool message_seen_ = false;
    Message* message_ = nullptr;  // whose signals follow; nullptr for one that is not read
};

}  // namespace

Database read(std::string_view text, const std::string& path, diagnostic::Findings& findings) {
    return Reader(text, path, findings).run();
}

}  // namespace cgw::dbc
