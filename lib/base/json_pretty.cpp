#include <utility>

#include "base/json.hpp"

namespace cgw::base {
namespace {

class Pretty {
  public:
    Pretty(std::string_view document, std::size_t width) : rest_(document), width_(width) {}

    std::string take() && {
        value(0);
        return std::move(text_) + "\n";
    }

  private:
    // Bytes of the value, or of the key with its value, that `text` begins with.
    static std::size_t length_of_item(std::string_view text) {
        std::size_t depth = 0;
        bool in_string = false;
        std::size_t i = 0;
        for (; i < text.size(); ++i) {
            const char c = text[i];
            if (in_string) {
                i += c == '\\' ? 1U : 0U;
                in_string = c != '"';
            } else if (c == '"') {
                in_string = true;
            } else if (c == '{' || c == '[') {
                ++depth;
            } else if (c == '}' || c == ']' || c == ',') {
                if (depth == 0) {
                    break;
                }
                depth -= c == ',' ? 0U : 1U;
            }
        }
        return i;
    }

    // `item` with a blank behind each colon and comma.
    static std::string on_one_line(std::string_view item) {
        std::string line;
        bool in_string = false;
        for (std::size_t i = 0; i < item.size(); ++i) {
            line += item[i];
            if (in_string && item[i] == '\\') {
                line += item[++i];
            } else if (item[i] == '"') {
                in_string = !in_string;
            } else if (!in_string && (item[i] == ':' || item[i] == ',')) {
                line += ' ';
            }
        }
        return line;
    }

    static std::size_t length_of_key(std::string_view item) {
        std::size_t i = 1;
        while (item[i] != '"') {
            i += item[i] == '\\' ? 2U : 1U;
        }
        return i + 2;  // with quote and colon
    }

    void take_over(std::size_t length) {
        text_ += rest_.substr(0, length);
        rest_.remove_prefix(length);
    }

    std::size_t column() const { return text_.size() - (text_.rfind('\n') + 1); }

    // The value that rest_ begins with; `indent` is that of the line it stands on.
    void value(std::size_t indent) {
        const std::string_view item = rest_.substr(0, length_of_item(rest_));
        const std::string line = on_one_line(item);
        const bool is_container = item.size() > 2 && (item.front() == '{' || item.front() == '[');
        if (!is_container || column() + line.size() + 1 <= width_) {  // 1: the comma
            text_ += line;
            rest_.remove_prefix(item.size());
            return;
        }
        const bool has_keys = item.front() == '{';
        take_over(1);
        while (true) {
            text_ += "\n" + std::string(indent + 2, ' ');
            if (has_keys) {
                take_over(length_of_key(rest_));
                text_ += ' ';
            }
            value(indent + 2);
            if (rest_.front() != ',') {
                break;
            }
            take_over(1);
        }
        text_ += "\n" + std::string(indent, ' ');
        take_over(1);
    }

    std::string_view rest_;
    std::size_t width_;
    std::string text_;
};

}  // namespace

std::string pretty_json(std::string_view document, std::size_t width) {
    if (document.ends_with('\n')) {
        document.remove_suffix(1);
    }
    return Pretty(document, width).take();
}

}  // namespace cgw::base
