// Frames as drawings of 80 columns.
#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "signals/layout.hpp"

namespace cgw::signals {
namespace {

constexpr std::size_t word_width = 15;  // between the lines of a box
constexpr std::size_t name_width = 13;
constexpr std::size_t bit_width = 5;
constexpr unsigned byte_bits = 8;
constexpr std::string_view margin = "      ";

// How much of the name goes into the first line: up to an underscore or before a capital letter.
std::size_t first_piece(std::string_view name) {
    for (std::size_t length = name_width; length > 1; --length) {
        if (name[length - 1] == '_' || (name[length] >= 'A' && name[length] <= 'Z')) {
            return length;
        }
    }
    return name_width;
}

// Pieces that fit into a box.
std::vector<std::string> pieces_of(std::string_view name) {
    std::vector<std::string> pieces;
    while (name.size() > name_width) {
        const std::size_t length = first_piece(name);
        pieces.emplace_back(name.substr(0, length));
        name.remove_prefix(length);
    }
    pieces.emplace_back(name);
    return pieces;
}

const Signal* signal_at(const Frame& frame, unsigned bit) {
    for (const Signal& signal : frame.signals) {
        if (signal.first_bit == bit) {
            return &signal;
        }
    }
    return nullptr;
}

std::vector<std::string> box_of(const Frame& frame, std::size_t word) {
    const Word& mapped = frame.words[word];
    const Signal* const signal = signal_at(frame, static_cast<unsigned>(word * config::word_bits));
    if (signal == nullptr) {
        return {"(not used)", base::object_text(mapped.index)};
    }
    std::vector<std::string> lines = pieces_of(signal->name);
    lines.push_back(base::object_text(mapped.index, mapped.sub_index));
    return lines;
}

std::string line_across(std::size_t boxes, std::size_t width) {
    std::string text(margin);
    for (std::size_t i = 0; i < boxes; ++i) {
        text += '+' + std::string(width, '-');
    }
    return text + "+\n";
}

std::string trimmed_line(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text + '\n';
}

std::string words_diagram(const Frame& frame) {
    std::string bytes = "byte  ";
    std::string bits = "bit   ";
    for (unsigned byte = 0; byte < frame.length; ++byte) {
        bytes += fmt::format(" {:<7}", byte);
        bits += fmt::format(" {:<7}", fmt::format("{}..{}", byte * byte_bits, byte * byte_bits + 7));
    }
    std::vector<std::vector<std::string>> boxes;
    std::size_t height = 0;
    for (std::size_t word = 0; word < frame.words.size(); ++word) {
        boxes.push_back(box_of(frame, word));
        height = std::max(height, boxes.back().size());
    }
    const std::string across = line_across(boxes.size(), word_width);
    std::string text = trimmed_line(bytes) + trimmed_line(bits) + across;
    for (std::size_t line = 0; line < height; ++line) {
        text += margin;
        for (const std::vector<std::string>& box : boxes) {
            text += fmt::format("| {:<{}}", line < box.size() ? box[line] : "", word_width - 1);
        }
        text += "|\n";
    }
    return text + across;
}

std::string bit_cell(const Signal* signal) {
    if (signal == nullptr) {
        return ".";
    }
    return fmt::format("{}", signal->number != 0 ? signal->number : signal->object_bit + 1U);
}

std::string bits_diagram(const Frame& frame) {
    std::string text = "bit   ";
    for (unsigned bit = byte_bits; bit > 0; --bit) {
        text += fmt::format("   {}  ", bit - 1);
    }
    const std::string across = line_across(byte_bits, bit_width);
    text = trimmed_line(text) + across;
    for (unsigned byte = 0; byte < frame.length; ++byte) {
        text += fmt::format("byte {}", byte);
        for (unsigned bit = byte_bits; bit > 0; --bit) {
            text += fmt::format("|{:^{}}", bit_cell(signal_at(frame, byte * byte_bits + bit - 1)), bit_width);
        }
        text += "|\n";
    }
    return text + across;
}

}  // namespace

std::string diagram_of(const Frame& frame) {
    const bool has_bits = std::any_of(frame.signals.begin(), frame.signals.end(),
                                      [](const Signal& signal) { return signal.is_bit(); });
    return has_bits ? bits_diagram(frame) : words_diagram(frame);
}

}  // namespace cgw::signals
