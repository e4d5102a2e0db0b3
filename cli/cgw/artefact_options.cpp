#include "cli/cgw/artefact_options.hpp"
#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "image/layout.hpp"

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

bool contains(std::span<const std::string_view> options, std::string_view option) {
    return std::find(options.begin(), options.end(), option) != options.end();
}

bool takes(const emit::Emitter& emitter, const emit::Format& format, std::string_view option) {
    return contains(emitter.options, option) || contains(format.options, option);
}

void refuse_foreign_option(const emit::Emitter& emitter, const emit::Format& format,
                           std::string_view option) {
    std::vector<std::string> takers;
    bool of_another_format = false;
    for (const emit::Emitter& other : emit::all_emitters()) {
        if (contains(other.options, option)) {
            takers.emplace_back(other.name);
        }
        for (const emit::Format& form : other.formats) {
            if (contains(form.options, option)) {
                takers.push_back(fmt::format("{} --format {}", other.name, form.name));
                of_another_format = of_another_format || &other == &emitter;
            }
        }
    }
    throw UsageError(fmt::format("{} is an option of {}, not of {}{}", option, fmt::join(takers, ", "),
                                 emitter.name,
                                 of_another_format ? fmt::format(" --format {}", format.name) : ""));
}

void refuse_foreign_options(const Arguments& arguments, const emit::Emitter& emitter,
                            const emit::Format& format) {
    const auto check = [&](std::span<const std::string_view> options) {
        for (const std::string_view option : options) {
            if (arguments.given(option) && !takes(emitter, format, option)) {
                refuse_foreign_option(emitter, format, option);
            }
        }
    };
    for (const emit::Emitter& other : emit::all_emitters()) {
        check(other.options);
        for (const emit::Format& form : other.formats) {
            check(form.options);
        }
    }
}

// Any image fits behind it: the verifier takes none of more than 64 KiB.
std::uint32_t base_of(const Arguments& arguments, const emit::Format& format, unsigned alignment) {
    constexpr std::uint64_t highest = (std::uint64_t{1} << 32U) - image::maximum_size;
    if (!contains(format.options, "--base")) {
        return 0;
    }
    if (!arguments.given("--base")) {
        throw UsageError(fmt::format("--format {} needs --base ADDRESS: where the image stands in the device",
                                     format.name));
    }
    const std::uint64_t base = address_of(arguments, "--base");
    if (base > highest || base % alignment != 0) {
        throw UsageError(fmt::format("--base {}: the address is a multiple of {} up to 0x{:X}",
                                     arguments.value("--base"), alignment, highest));
    }
    return static_cast<std::uint32_t>(base);
}

std::string image_file_of(const std::string& name) {
    if (name.empty() || base::printable(name) != name || name.find_first_of("\"\\") != std::string::npos) {
        throw UsageError(fmt::format("--incbin {}: a file name without quotes and backslashes", name));
    }
    return name;
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

unsigned alignment_of(const Arguments& arguments) {
    constexpr unsigned largest = 4096;
    const std::string text = arguments.value("--align");
    unsigned n = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, n);
    if (error != std::errc{} || stop != end || n == 0 || n > largest || (n & (n - 1)) != 0) {
        throw UsageError(
            fmt::format("--align {}: the alignment is a power of two from 1 to {}", text, largest));
    }
    return n;
}

std::uint64_t address_of(const Arguments& arguments, std::string_view key) {
    const std::string text = arguments.value(key);
    const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    const std::string_view number = std::string_view(text).substr(hexadecimal ? 2 : 0);
    const std::string_view digits = hexadecimal ? base::hexadecimal_digits : base::digits;
    const auto value = base::parse_integer(number, hexadecimal ? 16 : 10);
    if (!number.empty() && base::consists_of(number, digits) && !value) {
        throw UsageError(fmt::format("{} {}: the address is too large", key, text));
    }
    if (!base::consists_of(number, digits) || !value) {
        throw UsageError(fmt::format("{} {}: an address is a number such as 0x08010000", key, text));
    }
    return static_cast<std::uint64_t>(*value);
}

std::string eds_name_of(const Arguments& arguments) {
    const base::Result<std::string> name = emit::eds_file_name(arguments.value("--eds-name"));
    if (!name) {
        throw UsageError(fmt::format("--eds-name: {}", name.error().message));
    }
    return *name;
}

emit::Options artefact_options(const Arguments& arguments, const emit::Emitter& emitter) {
    emit::Options options;
    options.format = format_of(arguments, emitter);
    const emit::Format& format = *emit::find_format(emitter, options.format);
    refuse_foreign_options(arguments, emitter, format);
    options.section = section_of(arguments.value("--section"));
    options.alignment = alignment_of(arguments);
    options.symbol = symbol_of(arguments.value("--symbol"));
    options.image_file = image_file_of(arguments.value("--incbin"));
    options.base = base_of(arguments, format, options.alignment);
    options.eds_name = eds_name_of(arguments);
    options.labels = !arguments.given("--no-labels");
    return options;
}

}  // namespace cgw::cli
