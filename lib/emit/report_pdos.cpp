#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "emit/report_parts.hpp"
#include "facts/gateway.hpp"
#include "signals/codec.hpp"
#include "signals/frames.hpp"
#include "signals/layout.hpp"

namespace cgw::emit {
namespace {

using signals::Frame;
using signals::Signal;

constexpr unsigned bits_of_byte = 8;

std::string word_label(const Frame& frame, std::size_t position) {
    const unsigned first = static_cast<unsigned>(position) * facts::word_bits;
    const Signal* only = nullptr;
    unsigned bits = 0;
    for (const Signal& signal : frame.signals) {
        if (signal.first_bit >= first && signal.first_bit < first + facts::word_bits) {
            only = &signal;
            bits += signal.is_bit() ? 1U : 0U;
        }
    }
    if (only == nullptr) {
        return "";
    }
    return bits == 0 ? meaning_of(*only) : fmt::format("{} bits", to_text(only->kind));
}

page::Frame drawing_of(const Frame& frame) {
    page::Frame drawing{fmt::format("The {} bytes of {}", frame.length, frame.name), frame.length, {}};
    for (std::size_t i = 0; i < frame.words.size(); ++i) {
        const std::string label = word_label(frame, i);
        drawing.parts.push_back({static_cast<unsigned>(i) * facts::word_bits, facts::word_bits,
                                 label.empty() ? "nothing" : label, !label.empty()});
    }
    return drawing;
}

std::string place_of(const Signal& signal) {
    const unsigned byte = signal.first_bit / bits_of_byte;
    return signal.is_bit() ? fmt::format("byte {}, bit {}", byte, signal.first_bit % bits_of_byte)
                           : fmt::format("bytes {}, {}", byte, byte + 1);
}

std::string example_text(const Signal& signal) {
    const signals::Example example = example_of(signal);
    return fmt::format("{} is {} = {}", example.bytes, example.raw, example.shown);
}

page::Table words_table(const Frame& frame) {
    page::Table table{fmt::format("What {} carries", frame.name),
                      {{"Bytes"}, {"Meaning"}, {"Object"}, {"Scaling"}, {"For example"}},
                      {}};
    for (const Signal& signal : frame.signals) {
        table.rows.push_back({place_of(signal), meaning_of(signal), object_place(signal),
                              scaling_text(signal), example_text(signal)});
    }
    return table;
}

// An error to which no manual gives a name; those in a row share a line.
bool nameless(const Signal& signal) {
    return signal.kind == signals::Kind::error &&
           std::all_of(signal.sources.begin(), signal.sources.end(),
                       [](const signals::Source& source) { return source.name.empty(); });
}

std::vector<page::Cell> bits_row(const Signal& first, const Signal& last) {
    if (&first == &last) {
        return {place_of(first), meaning_of(first), bit_values_text(first), object_place(first)};
    }
    return {fmt::format("{} to {}", place_of(first), place_of(last)),
            fmt::format("errors {} to {}, without a name in the manuals", first.number, last.number),
            bit_values_text(first), fmt::format("{} to {}", object_place(first), object_place(last))};
}

page::Table bits_table(const Frame& frame) {
    page::Table table{fmt::format("What the bits of {} mean", frame.name),
                      {{"Bit"}, {"Meaning"}, {"Values"}, {"Object"}},
                      {}};
    for (std::size_t i = 0; i < frame.signals.size(); ++i) {
        const Signal& first = frame.signals[i];
        while (nameless(first) && i + 1 < frame.signals.size() && nameless(frame.signals[i + 1])) {
            ++i;
        }
        table.rows.push_back(bits_row(first, frame.signals[i]));
    }
    return table;
}

void add_frame(const Frame& frame, Blocks& blocks) {
    blocks.emplace_back(
        page::Heading{3, fmt::format("{}, {}", frame.name, base::identifier_text(frame.identifier))});
    blocks.emplace_back(page::Paragraph{fmt::format("{} bytes, {}.", frame.length, time_text(frame))});
    blocks.emplace_back(drawing_of(frame));
    if (frame.signals.empty()) {
        return;
    }
    const bool all_bits = std::all_of(frame.signals.begin(), frame.signals.end(),
                                      [](const Signal& signal) { return signal.is_bit(); });
    blocks.emplace_back(all_bits ? bits_table(frame) : words_table(frame));
}

}  // namespace

void add_pdos(const Plant& plant, Blocks& blocks) {
    const std::vector<Frame> frames =
        signals::frames_of(plant.settings, plant.catalogue, plant.configuration);
    blocks.emplace_back(page::Heading{2, "PDOs"});
    blocks.emplace_back(page::Paragraph{
        frames.empty() ? "No PDO is active."
                       : "TPDOs are sent by the gateway, RPDOs are sent to it. Numbers lie low byte first."});
    for (const Frame& frame : frames) {
        add_frame(frame, blocks);
    }
}

}  // namespace cgw::emit
