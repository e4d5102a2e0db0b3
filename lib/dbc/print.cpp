#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/numbers.hpp"
#include "dbc/database.hpp"
#include "dbc/words.hpp"
#include "dictionary/ascii.hpp"

namespace cgw::dbc {
namespace {

constexpr std::string_view line_end = "\r\n";
// What a reader may meet in the file, as all tools list it.
constexpr std::array<std::string_view, 10> new_symbols{
    "NS_DESC_", "CM_", "BA_DEF_", "BA_", "VAL_", "CAT_DEF_", "CAT_", "FILTER", "BA_DEF_DEF_", "VAL_TABLE_"};

class Printer {
  public:
    explicit Printer(const Database& database) : database_(&database) {}

    std::string print() {
        head();
        messages();
        comments();
        attribute_definitions();
        attributes();
        value_tables();
        return std::move(text_);
    }

  private:
    template <typename... Parts>
    void line(fmt::format_string<Parts...> format, Parts&&... parts) {
        text_ += fmt::format(format, std::forward<Parts>(parts)...);
        text_ += line_end;
    }
    void blank() { text_ += line_end; }

    // Readers disagree about escaped quotes and backslashes, so there are none.
    static std::string quoted(std::string_view text) {
        std::string ascii = dictionary::to_ascii(text);
        std::replace(ascii.begin(), ascii.end(), '"', '\'');
        std::replace(ascii.begin(), ascii.end(), '\\', '/');
        return '"' + ascii + '"';
    }

    void head() {
        line("VERSION {}", quoted(database_->version));
        blank();
        line("NS_ :");
        for (const std::string_view symbol : new_symbols) {
            line("\t{}", symbol);
        }
        blank();
        line("BS_:");
        blank();
        text_ += "BU_:";
        for (const Node& node : database_->nodes) {
            text_ += ' ' + node.name;
        }
        blank();
        blank();
    }

    void messages() {
        for (const Message& message : database_->messages) {
            line("BO_ {} {}: {} {}", message.identifier, message.name, message.length,
                 message.sender.empty() ? nobody : message.sender);
            for (const Signal& signal : message.signals) {
                line(" SG_ {}{}{} : {}|{}@{}{} ({},{}) [{}|{}] {} {}", signal.name,
                     signal.multiplexing.empty() ? "" : " ", signal.multiplexing, signal.start_bit,
                     signal.length, signal.big_endian ? 0 : 1, signal.is_signed ? '-' : '+',
                     base::to_text(signal.factor), base::to_text(signal.offset),
                     base::to_text(signal.minimum), base::to_text(signal.maximum), quoted(signal.unit),
                     signal.receivers.empty() ? std::string(nobody)
                                              : fmt::format("{}", fmt::join(signal.receivers, ",")));
            }
            blank();
        }
    }

    void comments() {
        comment("", database_->comment);
        for (const Node& node : database_->nodes) {
            comment(fmt::format("BU_ {} ", node.name), node.comment);
        }
        for (const Message& message : database_->messages) {
            comment(fmt::format("BO_ {} ", message.identifier), message.comment);
            for (const Signal& signal : message.signals) {
                comment(fmt::format("SG_ {} {} ", message.identifier, signal.name), signal.comment);
            }
        }
    }

    void comment(const std::string& where, const std::string& text) {
        if (!text.empty()) {
            line("CM_ {}{};", where, quoted(text));
        }
    }

    void attribute_definitions() {
        line(R"(BA_DEF_ "BusType" STRING ;)");
        line(R"(BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;)");
        line(R"(BA_DEF_ BO_ "GenMsgSendType" ENUM "{}";)", fmt::join(send_types, R"(",")"));
        line(R"(BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN";)");
        line(R"(BA_DEF_DEF_ "BusType" "CAN";)");
        line(R"(BA_DEF_DEF_ "GenMsgCycleTime" 0;)");
        line(R"(BA_DEF_DEF_ "GenMsgSendType" "{}";)", send_types.back());
        line(R"(BA_DEF_DEF_ "VFrameFormat" "StandardCAN";)");
    }

    // Values of an ENUM are indices here and texts in the defaults above.
    void attributes() {
        line(R"(BA_ "BusType" "CAN";)");
        for (const Message& message : database_->messages) {
            line(R"(BA_ "VFrameFormat" BO_ {} 0;)", message.identifier);
            line(R"(BA_ "GenMsgSendType" BO_ {} {};)", message.identifier,
                 static_cast<unsigned>(std::min(message.send_type, SendType::not_stated)));
            if (message.cycle_ms) {
                line(R"(BA_ "GenMsgCycleTime" BO_ {} {};)", message.identifier, *message.cycle_ms);
            }
        }
    }

    void value_tables() {
        for (const Message& message : database_->messages) {
            for (const Signal& signal : message.signals) {
                if (!signal.values.empty()) {
                    value_table(message, signal);
                }
            }
        }
    }

    void value_table(const Message& message, const Signal& signal) {
        text_ += fmt::format("VAL_ {} {}", message.identifier, signal.name);
        for (const NamedValue& value : signal.values) {
            text_ += fmt::format(" {} {}", value.value, quoted(value.text));
        }
        text_ += " ;";
        text_ += line_end;
    }

    const Database* database_;
    std::string text_;
};

}  // namespace

std::string print(const Database& database) {
    return Printer(database).print();
}

}  // namespace cgw::dbc
