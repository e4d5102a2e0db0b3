#include "traffic/typed_frame.hpp"

#include <fmt/format.h>

#include "base/ascii.hpp"
#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/frames.hpp"
#include "facts/identifiers.hpp"

namespace cgw::traffic {
namespace {

namespace rules = diagnostic::rules;

struct Reader {
    diagnostic::Findings& findings;
    frame::Frame frame{};

    void refuse(const std::string& word, std::string message, std::string help = {}) {
        findings.report({&rules::frame_text, std::move(message), {word, {}}, {}, std::move(help)});
    }

    bool take_identifier(const std::string& word, std::string_view digits) {
        const std::optional<std::int64_t> number = base::parse_integer(digits, 16);
        if (!number || !base::consists_of(digits, base::hexadecimal_digits)) {
            refuse(word, "this is no identifier", "write it as 0x181 or 181h");
            return false;
        }
        if (*number > facts::cob::highest) {
            refuse(word,
                   fmt::format("an identifier is at most {}", base::identifier_text(facts::cob::highest)));
            return false;
        }
        frame.id = static_cast<std::uint32_t>(*number);
        return true;
    }

    bool take_bytes(const std::string& word, std::string_view digits) {
        if (digits == "R" || digits == "r") {
            frame.remote = true;
            return true;
        }
        digits = digits.starts_with("0x") || digits.starts_with("0X") ? digits.substr(2) : digits;
        if (digits.size() % 2 != 0 ||
            (!digits.empty() && !base::consists_of(digits, base::hexadecimal_digits))) {
            refuse(word, "these are no bytes", "write each byte as two hexadecimal digits");
            return false;
        }
        for (; !digits.empty(); digits.remove_prefix(2)) {
            if (frame.length == frame.data.size()) {
                refuse(word, fmt::format("a frame has at most {} bytes", frame.data.size()));
                return false;
            }
            frame.data[frame.length++] =
                static_cast<std::uint8_t>(*base::parse_integer(digits.substr(0, 2), 16));
        }
        return true;
    }
};

// The digits of "0x181" and "181h"; "" for anything else.
std::string_view identifier_digits(std::string_view text) {
    if (text.starts_with("0x") || text.starts_with("0X")) {
        return text.substr(2);
    }
    if (text.size() > 1 && base::lower(text.back()) == 'h' &&
        base::consists_of(text.substr(0, text.size() - 1), base::hexadecimal_digits)) {
        return text.substr(0, text.size() - 1);
    }
    return {};
}

}  // namespace

bool begins_frame(std::string_view text) {
    constexpr std::size_t longest_identifier = 8;  // digits
    return !identifier_digits(text).empty() || text.find('#') <= longest_identifier;
}

frame::Frame read_typed_frame(std::span<const std::string> words, diagnostic::Findings& findings) {
    Reader reader{findings};
    const std::string& first = words.front();
    const std::size_t hash = first.find('#');
    bool fine = true;
    if (hash != std::string::npos) {
        fine = reader.take_identifier(first, std::string_view(first).substr(0, hash)) &&
               reader.take_bytes(first, std::string_view(first).substr(hash + 1));
    } else {
        fine = reader.take_identifier(first, identifier_digits(first));
    }
    for (std::size_t i = 1; fine && i < words.size(); ++i) {
        fine = reader.take_bytes(words[i], words[i]);
    }
    if (fine && reader.frame.remote && reader.frame.length != 0) {
        reader.refuse(words.back(), "a remote frame has no data");
    }
    return reader.frame;
}

}  // namespace cgw::traffic
