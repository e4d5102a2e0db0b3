// Layouts for people: text for 80 columns, and Markdown.
#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/text_cells.hpp"
#include "base/wrap.hpp"
#include "signals/codec.hpp"
#include "signals/layout.hpp"
#include "signals/parts.hpp"

namespace cgw::signals {
namespace {

constexpr std::size_t columns = 80;
constexpr unsigned byte_bits = 8;

std::string bytes_of(const Signal& signal) {
    const unsigned byte = signal.first_bit / byte_bits;
    return signal.is_bit() ? fmt::format("{}.{}", byte, signal.first_bit % byte_bits)
                           : fmt::format("{}..{}", byte, byte + 1);
}

std::string mask_of(const Signal& signal) {
    return fmt::format("{:02X}h", 1U << signal.first_bit % byte_bits);
}

std::string scaling_line(const Signal& signal) {
    std::string text = signal.is_signed ? "signed" : "unsigned";
    text += signal.scaled ? ", " + scaling_text(signal) : "; its scaling is not known";
    if (!signal.scaled_as.empty()) {
        text += fmt::format(", as {}", labels_of(signal.scaled_as));
    }
    return text;
}

std::string example_line(const Signal& signal) {
    const Example example = example_of(signal);
    return fmt::format("{} -> {} -> {} -> {}", example.asked, example.raw, example.bytes, example.shown);
}

// An error without a name says nothing that the drawing does not.
bool is_listed(const Signal& signal) {
    return signal.kind != Kind::error || !signal.sources.empty();
}

std::string head_of(const Frame& frame) {
    return fmt::format("{}  {}  {} bytes  {}  ({}, {})", frame.name, base::identifier_text(frame.identifier),
                       frame.length, time_text(frame), base::object_text(frame.communication),
                       base::object_text(frame.mapping));
}

constexpr std::string_view bit_columns = "Bit   Mask Object          Parameter\n";
constexpr std::string_view word_columns =
    "Bytes  Object     Parameter, scaling, a value to the bus and back\n";
constexpr std::string_view nameless_errors =
    "The other bits are errors whose names the manuals do not print.";
constexpr std::string_view engine_bits =
    "What each bit means depends on the governor and is not printed (D22).";

bool has(const Frame& frame, Kind kind) {
    return std::any_of(frame.signals.begin(), frame.signals.end(),
                       [kind](const Signal& signal) { return signal.kind == kind; });
}

std::string_view remark_of(const Frame& frame) {
    if (has(frame, Kind::engine_state)) {
        return engine_bits;
    }
    return std::all_of(frame.signals.begin(), frame.signals.end(), is_listed) ? "" : nameless_errors;
}

void add_wrapped(std::string& text, std::string_view head, const std::string& line) {
    std::string indent(head);
    for (const std::string& part : base::wrap(line, columns - head.size())) {
        text += indent + part + '\n';
        indent.assign(head.size(), ' ');
    }
}

void add_bit(std::string& text, const Signal& signal) {
    const std::string meaning = bit_values_text(signal);
    add_wrapped(text,
                fmt::format("{:<5} {:<4} {:<15} ", bytes_of(signal), mask_of(signal), object_place(signal)),
                base::one_line(meaning_of(signal)) + (meaning.empty() ? "" : "; " + meaning));
}

void add_word(std::string& text, const Signal& signal) {
    const std::string indent(18, ' ');
    add_wrapped(text, fmt::format("{:<6} {:<10} ", bytes_of(signal), object_place(signal)),
                base::one_line(meaning_of(signal)));
    add_wrapped(text, indent, base::one_line(scaling_line(signal)));
    add_wrapped(text, indent, base::one_line(example_line(signal)));
}

void add_frame(std::string& text, const Frame& frame) {
    text += fmt::format("\n{}\n\n{}\n", head_of(frame), diagram_of(frame));
    if (!has(frame, Kind::engine_state)) {
        const bool bits = !frame.signals.empty() && frame.signals.front().is_bit();
        text += bits ? bit_columns : word_columns;
    }
    for (const Signal& signal : frame.signals) {
        if (!is_listed(signal) || signal.kind == Kind::engine_state) {
            continue;
        }
        signal.is_bit() ? add_bit(text, signal) : add_word(text, signal);
    }
    if (const std::string_view remark = remark_of(frame); !remark.empty()) {
        text += fmt::format("{}\n", remark);
    }
}

std::string heading(const Sheet& sheet) {
    return sheet.title.empty() ? "Frame layouts" : "Frame layouts: " + base::one_line(sheet.title);
}

void markdown_row(std::string& text, const Signal& signal) {
    const std::string meaning = signal.is_bit() ? bit_values_text(signal) : scaling_line(signal);
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", bytes_of(signal),
                        signal.is_bit() ? mask_of(signal) : "", object_place(signal),
                        base::markdown_cell(meaning_of(signal)), base::markdown_cell(meaning),
                        signal.is_bit() ? "" : base::markdown_cell(example_line(signal)));
}

}  // namespace

Example example_of(const Signal& signal) {
    Example example;
    Data data{};
    if (signal.is_bit()) {
        example.raw = 1;
        put_raw(signal, data, example.raw);
        example.bytes = fmt::format("{:02X}", data[signal.first_bit / byte_bits]);
        example.asked = example.shown = value_text(signal, example.raw);
        return example;
    }
    constexpr double part = 0.75;
    const double wanted = signal.minimum + part * (signal.maximum - signal.minimum);
    example.raw = raw_of(signal, wanted).value_or(signal.raw_maximum);
    put_raw(signal, data, example.raw);
    const std::size_t byte = signal.first_bit / byte_bits;
    example.bytes = fmt::format("{:02X} {:02X}", data[byte], data[byte + 1]);
    example.shown = value_text(signal, example.raw);
    example.asked = signal.scaled ? quantity_text(signal, wanted) : example.shown;
    return example;
}

std::string time_text(const Frame& frame) {
    if (frame.transmit()) {
        return frame.period_us == 0 ? "sent when a bit changes"
                                    : "sent every " + base::milliseconds_text(frame.period_us);
    }
    return frame.monitoring_us == 0 ? "not monitored"
                                    : "monitored for " + base::milliseconds_text(frame.monitoring_us);
}

std::string object_place(const Signal& signal) {
    const std::string object = base::object_text(signal.index, signal.sub_index);
    return signal.is_bit() ? fmt::format("{} bit {}", object, signal.object_bit + 1) : object;
}

std::string bit_values_text(const Signal& signal) {
    switch (signal.kind) {
        case Kind::error:
            return "1: present";
        case Kind::sensor_flag:
            return "1: faulty";
        case Kind::switch_function:
            return signal.values.empty()
                       ? "its functions disagree about 0 and 1"
                       : fmt::format("0: {}, 1: {}", signal.values[0].text, signal.values[1].text);
        default:
            return {};
    }
}

std::string meaning_of(const Signal& signal) {
    if (signal.kind == Kind::engine_state) {
        return fmt::format("engine state bit {}", signal.object_bit + 1);
    }
    if (signal.sources.empty()) {
        return fmt::format("error {}", signal.number);
    }
    if (signal.kind == Kind::error) {
        return signal.sources.front().label();
    }
    const std::string labels = labels_of(signal.sources);
    if (signal.kind == Kind::sensor_flag) {
        return fmt::format("error flag of channel {}: {}", signal.channel, labels);
    }
    return signal.kind == Kind::sensor ? fmt::format("{}, channel {}", labels, signal.channel) : labels;
}

std::string render_layout_text(const Sheet& sheet) {
    std::string text =
        fmt::format("{}\nConfiguration {}, node {}\n", heading(sheet), sheet.configuration_id, sheet.node_id);
    for (const Frame& frame : sheet.frames) {
        add_frame(text, frame);
    }
    return text;
}

std::string render_layout_markdown(const Sheet& sheet) {
    std::string text =
        fmt::format("# {}\n\nConfiguration `{}`, node {}\n", base::markdown_cell(heading(sheet)),
                    sheet.configuration_id, sheet.node_id);
    for (const Frame& frame : sheet.frames) {
        text += fmt::format("\n## {}\n\n{}\n\n```\n{}```\n\n", frame.name, head_of(frame), diagram_of(frame));
        text += "| Byte | Mask | Object | Parameter | Meaning | Example |\n|---|---|---|---|---|---|\n";
        for (const Signal& signal : frame.signals) {
            if (is_listed(signal)) {
                markdown_row(text, signal);
            }
        }
        if (const std::string_view remark = remark_of(frame); !remark.empty()) {
            text += fmt::format("\n{}\n", remark);
        }
    }
    return text;
}

}  // namespace cgw::signals
