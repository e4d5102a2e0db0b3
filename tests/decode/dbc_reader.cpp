#include "dbc_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace cgw::test {
namespace {

std::uint64_t bits_of(const frame::Frame& frame) {
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < 8; ++i) {
        bits |= std::uint64_t{frame.data[i]} << (8 * i);
    }
    return bits;
}

DbcSignal signal_of(const std::smatch& match) {
    DbcSignal signal;
    signal.start = static_cast<unsigned>(std::stoul(match[2]));
    signal.length = static_cast<unsigned>(std::stoul(match[3]));
    signal.is_signed = match[4] == "-";
    signal.factor = std::stod(match[5]);
    signal.offset = std::stod(match[6]);
    signal.minimum = std::stod(match[7]);
    signal.maximum = std::stod(match[8]);
    signal.unit = match[9];
    return signal;
}

void read_values(const std::smatch& match, std::map<std::string, DbcMessage>& messages) {
    static const std::regex pair("(\\d+) \"([^\"]*)\"");
    for (auto& [name, message] : messages) {
        if (message.id != std::stoul(match[1])) {
            continue;
        }
        const std::string pairs = match[3];
        for (std::sregex_iterator it(pairs.begin(), pairs.end(), pair), end; it != end; ++it) {
            message.signals.at(match[2]).values[static_cast<unsigned>(std::stoul((*it)[1]))] = (*it)[2];
        }
    }
}

}  // namespace

double DbcSignal::decode(const frame::Frame& frame) const {
    const std::uint64_t mask = (std::uint64_t{1} << length) - 1;
    auto raw = static_cast<std::int64_t>((bits_of(frame) >> start) & mask);
    if (is_signed && (raw >> (length - 1)) != 0) {
        raw -= std::int64_t{1} << length;
    }
    return static_cast<double>(raw) * factor + offset;
}

void DbcSignal::encode(double physical, frame::Frame& frame) const {
    const std::uint64_t mask = ((std::uint64_t{1} << length) - 1) << start;
    const auto raw = static_cast<std::uint64_t>(std::llround((physical - offset) / factor));
    const std::uint64_t bits = (bits_of(frame) & ~mask) | ((raw << start) & mask);
    for (unsigned i = 0; i < 8; ++i) {
        frame.data[i] = static_cast<std::uint8_t>(bits >> (8 * i));
    }
}

const DbcSignal& DbcMessage::at(unsigned start) const {
    for (const auto& [name, signal] : signals) {
        if (signal.start == start) {
            return signal;
        }
    }
    static const DbcSignal none;
    ADD_FAILURE() << "no signal begins at bit " << start << " of message " << id;
    return none;
}

std::map<std::string, DbcMessage> read_dbc(const std::string& text) {
    static const std::regex message_line(R"(BO_ (\d+) (\w+): (\d) (\w+)\r?)");
    static const std::regex signal_line(
        R"re( SG_ (\w+) : (\d+)\|(\d+)@1([+-]) \(([^,]+),([^)]+)\) \[([^|]+)\|([^\]]+)\] "([^"]*)" .*\r?)re");
    static const std::regex values_line(R"(VAL_ (\d+) (\w+) (.*);\r?)");
    std::map<std::string, DbcMessage> messages;
    DbcMessage* last = nullptr;
    std::istringstream lines(text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, match, message_line)) {
            last = &messages[match[2]];
            last->id = static_cast<std::uint32_t>(std::stoul(match[1]));
            last->length = static_cast<std::uint8_t>(std::stoul(match[3]));
        } else if (last != nullptr && std::regex_match(line, match, signal_line)) {
            last->signals[match[1]] = signal_of(match);
        } else if (std::regex_match(line, match, values_line)) {
            read_values(match, messages);
        }
    }
    return messages;
}

}  // namespace cgw::test
