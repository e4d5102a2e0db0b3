#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <optional>

#include "support/strict_eds.hpp"

namespace cgw::test {
namespace {

// Decimal or 0x with upper-case digits; a leading 0 would be octal.
std::optional<std::uint64_t> parse(const std::string& text) {
    const bool hexadecimal = text.starts_with("0x");
    const std::string digits = hexadecimal ? text.substr(2) : text;
    const char* const allowed = hexadecimal ? "0123456789ABCDEF" : "0123456789";
    const bool octal = !hexadecimal && digits.size() > 1 && digits.front() == '0';
    if (digits.empty() || digits.size() > 10 || octal ||
        digits.find_first_not_of(allowed) != std::string::npos) {
        return std::nullopt;
    }
    return std::strtoull(digits.c_str(), nullptr, hexadecimal ? 16 : 10);
}

bool is_key(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(),
                                        [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

bool is_trimmed(const std::string& text) {
    return text.empty() || (text.front() != ' ' && text.back() != ' ');
}

void read_line(const std::string& line, std::string& section, StrictEds& eds) {
    const auto find = [&](const std::string& what) { eds.findings.push_back("[" + section + "] " + what); };
    if (line.size() > 255) {
        find("line longer than 255");
    }
    for (const char c : line) {
        if (c < ' ' || c > '~') {
            find("character outside printable ASCII");
            return;
        }
    }
    if (line.empty() || line.front() == ';') {
        return;
    }
    if (line.size() > 2 && line.front() == '[' && line.find(']') == line.size() - 1) {
        section = line.substr(1, line.size() - 2);
        if (!eds.sections.emplace(section, EdsSection{}).second) {
            find("section appears twice");
        }
        return;
    }
    const std::size_t equals = line.find('=');
    const std::string key = line.substr(0, equals);
    const std::string value = equals != std::string::npos ? line.substr(equals + 1) : " ";
    if (!is_key(key) || !is_trimmed(value)) {
        find("not a line of an EDS: " + line);
    } else if (!eds.sections[section].emplace(key, value).second) {
        find(key + " appears twice");
    }
}

}  // namespace

StrictEds read_strictly(const std::string& text) {
    StrictEds eds;
    std::string section;
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = text.find("\r\n", start);
        if (end == std::string::npos) {
            eds.findings.push_back("[" + section + "] line does not end in CRLF");
            break;
        }
        read_line(text.substr(start, end - start), section, eds);
        start = end + 2;
    }
    return eds;
}

std::string StrictEds::value(const std::string& section, const std::string& key) {
    const auto found = sections.find(section);
    if (found == sections.end() || !found->second.contains(key)) {
        findings.push_back("[" + section + "] " + key + " is missing");
        return "";
    }
    return found->second.at(key);
}

void StrictEds::find(const std::string& where, const std::string& what) {
    findings.push_back("[" + where + "] " + what);
}

std::uint64_t StrictEds::number(const std::string& section, const std::string& key) {
    const std::string text = value(section, key);
    const auto parsed = parse(text);
    if (!parsed) {
        find(section, key + " is no number: " + text);
    }
    return parsed.value_or(0);
}

unsigned bits_of(std::uint64_t data_type) {
    constexpr std::array<unsigned, 8> bits{0, 8, 8, 16, 32, 8, 16, 32};
    return data_type < bits.size() ? bits[data_type] : 0;
}

std::string hex_digits(std::uint64_t value, int width) {
    std::string digits;
    for (int shift = 28; shift >= 0; shift -= 4) {
        const auto digit = static_cast<std::size_t>(value >> static_cast<unsigned>(shift) & 0xFU);
        if (digit != 0 || !digits.empty() || shift < 4 * width) {
            digits += "0123456789ABCDEF"[digit];
        }
    }
    return digits;
}

}  // namespace cgw::test
