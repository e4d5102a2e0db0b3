#include "cli/cgw/artefact_options.hpp"
#include "base/ascii.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace cgw::cli {
namespace {

bool is_of_identifier(char c) {
    return base::is_letter_or_digit(c) || c == '_';
}

std::string format_of(const Arguments& arguments, const emit::Emitter& emitter) {
    std::string name = arguments.value("--format");
    if (emit::find_format(emitter, name) == nullptr) {
        std::vector<std::string_view> names;
        for (const emit::Format& format : emitter.formats) {
            names.push_back(format.name);
        }
        throw UsageError(fmt::format("--format {}: the formats of {} are {}{}", name, emitter.name,
                                     fmt::join(names, ", "), did_you_mean(name, names)));
    }
    return name;
}

unsigned alignment_of(const std::string& text) {
    constexpr unsigned largest = 4096;
    unsigned n = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, n);
    if (error != std::errc{} || stop != end || n == 0 || n > largest || (n & (n - 1)) != 0) {
        throw UsageError(
            fmt::format("--align {}: the alignment is a power of two from 1 to {}", text, largest));
    }
    return n;
}

std::string symbol_of(const std::string& symbol) {
    if (symbol.empty() || !is_of_identifier(symbol.front()) || base::is_digit(symbol.front()) ||
        !std::all_of(symbol.begin(), symbol.end(), is_of_identifier)) {
        throw UsageError(fmt::format("--symbol {}: not a C identifier", symbol));
    }
    return symbol;
}

std::string section_of(const std::string& section) {
    const auto fits = [](char c) { return is_of_identifier(c) || c == '.' || c == '-' || c == '$'; };
    if (section.empty() || !std::all_of(section.begin(), section.end(), fits)) {
        throw UsageError(
            fmt::format("--section {}: a section name has letters, digits and . _ - $ only", section));
    }
    return section;
}

bool takes(const emit::Emitter& emitter, std::string_view option) {
    return std::find(emitter.options.begin(), emitter.options.end(), option) != emitter.options.end();
}

void refuse_foreign_option(const emit::Emitter& emitter, std::string_view option) {
    std::vector<std::string_view> takers;
    for (const emit::Emitter& other : emit::all_emitters()) {
        if (takes(other, option)) {
            takers.push_back(other.name);
        }
    }
    throw UsageError(
        fmt::format("{} is an option of {}, not of {}", option, fmt::join(takers, ", "), emitter.name));
}

void refuse_foreign_options(const Arguments& arguments, const emit::Emitter& emitter) {
    for (const emit::Emitter& other : emit::all_emitters()) {
        for (const std::string_view option : other.options) {
            if (!takes(emitter, option) && arguments.given(option)) {
                refuse_foreign_option(emitter, option);
            }
        }
    }
}

}  // namespace

std::vector<Word> emitter_words() {
    std::vector<Word> words;
    for (const emit::Emitter& emitter : emit::all_emitters()) {
        words.push_back({emitter.name, emitter.summary});
    }
    return words;
}

std::vector<Word> artefact_format_words() {
    std::vector<Word> words;
    for (const emit::Emitter& emitter : emit::all_emitters()) {
        for (const emit::Format& format : emitter.formats) {
            const bool known = std::any_of(words.begin(), words.end(),
                                           [&format](const Word& word) { return word.name == format.name; });
            if (!known) {
                words.push_back({format.name, ""});
            }
        }
    }
    return words;
}

std::string eds_name_of(const Arguments& arguments) {
    const base::Result<std::string> name = emit::eds_file_name(arguments.value("--eds-name"));
    if (!name) {
        throw UsageError(fmt::format("--eds-name: {}", name.error().message));
    }
    return *name;
}

emit::Options artefact_options(const Arguments& arguments, const emit::Emitter& emitter) {
    refuse_foreign_options(arguments, emitter);
    emit::Options options;
    options.format = format_of(arguments, emitter);
    options.section = section_of(arguments.value("--section"));
    options.alignment = alignment_of(arguments.value("--align"));
    options.symbol = symbol_of(arguments.value("--symbol"));
    options.eds_name = eds_name_of(arguments);
    options.labels = !arguments.given("--no-labels");
    return options;
}

}  // namespace cgw::cli
