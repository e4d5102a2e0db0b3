#include <algorithm>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "eds_check/keys.hpp"
#include "fuzz/mutation.hpp"
#include "input/sections.hpp"
#include "scenario/actions.hpp"

namespace cgw::fuzz {
namespace {

using Words = std::vector<std::string>;

void add_keys(Words& words, const input::Table& table) {
    for (const input::Key& key : table.keys) {
        words.emplace_back(key.name);
        words.insert(words.end(), key.words.begin(), key.words.end());
        if (key.below != nullptr) {
            add_keys(words, *key.below);
        }
    }
}

void add_parameters(Words& words) {
    for (const parameter::Row& row : catalogue::shipped_rows()) {
        words.push_back(std::to_string(row.number));
        if (!row.name.empty()) {
            words.emplace_back(row.name);
            words.push_back("\"" + std::to_string(row.number) + " " + std::string(row.name) + "\"");
        }
    }
}

void add_scenario(Words& words, std::span<const scenario::Key> keys) {
    for (const scenario::Key& key : keys) {
        words.emplace_back(key.name);
        if (key.words != nullptr) {
            for (const scenario::Word& word : key.words()) {
                words.push_back("\"" + std::string(word.name) + "\"");
            }
        }
    }
}

void add_sheets(Words& words) {
    constexpr auto last = static_cast<std::size_t>(eds::SectionKind::module_sub_extension);
    for (std::size_t kind = 0; kind <= last; ++kind) {
        const std::string_view section = eds::standard_name(static_cast<eds::SectionKind>(kind));
        if (!section.empty()) {
            words.push_back("[" + std::string(section) + "]");
        }
        for (const eds_check::KeyRow& row : eds_check::rows_of(static_cast<eds::SectionKind>(kind))) {
            words.emplace_back(row.name);
        }
    }
    for (const std::string_view word : {"[1018]",
                                        "[1018sub0]",
                                        "[1A00]",
                                        "[1A00sub1]",
                                        "[2000Value]",
                                        "[M1ModuleInfo]",
                                        "[M1SubExt2000]",
                                        "$NODEID+0x180",
                                        "0x180+$NODEID",
                                        "0x20000010",
                                        "0x0x12",
                                        "010",
                                        "12:00AM",
                                        "rww",
                                        "RO",
                                        "12345678",
                                        "0xFFFFFFFF",
                                        "0x80000180",
                                        "#",
                                        ";"}) {
        words.emplace_back(word);
    }
}

// What the tables know, and what TOML and printed tables are made of.
Words all_words() {
    Words words = {"true",
                   "false",
                   "0",
                   "-1",
                   "65535",
                   "0xFFFF",
                   "1.5",
                   "1e400",
                   "inf",
                   "nan",
                   "\"\"",
                   "''",
                   "[]",
                   "{}",
                   "[[governor.declare]]",
                   "[governor.parameters]",
                   "[gateway.parameters]",
                   "\"\"\"",
                   "'''",
                   "\\u0000",
                   "1979-05-27",
                   "\xEF\xBB\xBF",
                   R"(kind = "measurement")",
                   "[[row]]",
                   "device = ",
                   "Number;Parameter;Value;Unit",
                   "Number,Parameter,Value",
                   "| Number | Parameter | Value |",
                   "Device",
                   "\t",
                   ";",
                   "|",
                   "1,0",
                   "#### gateway",
                   "#### catalogue"};
    add_sheets(words);
    add_keys(words, input::file_table());
    add_parameters(words);
    add_scenario(words, scenario::file_keys());
    add_scenario(words, scenario::step_keys());
    for (const scenario::Action& action : scenario::actions()) {
        add_scenario(words, {&action.key, 1});
        add_scenario(words, action.further);
    }
    return words;
}

bool is_word(char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           c == '-' || c == '.';
}

// Begin and end of the word at `at`, which is empty between words.
std::pair<std::size_t, std::size_t> word_at(const std::string& text, std::size_t at) {
    std::size_t begin = at;
    std::size_t end = at;
    while (begin > 0 && is_word(text[begin - 1])) {
        --begin;
    }
    while (end < text.size() && is_word(text[end])) {
        ++end;
    }
    return {begin, end};
}

std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t behind = text.find('\n', at);
    return {begin, behind == std::string::npos ? text.size() : behind + 1};
}

void change_words(std::string& text, std::size_t at, unsigned seed) {
    static const Words words = all_words();
    const auto [begin, end] = word_at(text, at);
    text.replace(begin, end - begin, words[seed % words.size()]);
}

// Doubles it, leaves it out, or moves it to another place.
void change_lines(std::string& text, std::size_t at, unsigned seed) {
    const auto [begin, end] = line_at(text, at);
    const std::string line = text.substr(begin, end - begin);
    if (seed % 3 != 0) {
        text.erase(begin, end - begin);
    }
    if (seed % 3 != 1) {
        text.insert(line_at(text, text.empty() ? 0 : seed / 3 % text.size()).first, line);
    }
}

}  // namespace

std::size_t mutate_text(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed) {
    if (seed % 8 < 3 || size == 0) {
        return change_bytes(data, size, limit, seed);
    }
    std::string text(data, data + size);
    const unsigned choice = seed / 8;
    const std::size_t at = choice % text.size();
    seed % 8 < 6 ? change_words(text, at, choice / 7) : change_lines(text, at, choice / 7);
    if (text.size() > limit) {
        return change_bytes(data, size, limit, seed);
    }
    std::copy(text.begin(), text.end(), data);
    return text.size();
}

}  // namespace cgw::fuzz
