#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "dbc/read.hpp"
#include "emit/database.hpp"
#include "proof/configuration_id.hpp"
#include "proof/proof.hpp"
#include "proof/proving.hpp"

namespace cgw::proof {
namespace {

using dbc::Message;
using dbc::Signal;
using dictionary::Difference;

struct MessageRow {
    std::string_view name;
    std::string_view text;
    std::string (*value)(const Message& message);
};

// By dbc::SendType.
constexpr std::string_view send_type_texts[] = {"cyclic", "when something changes", "not stated",
                                                "another word"};

constexpr MessageRow message_rows[] = {
    {"message-name", "name", [](const Message& m) { return m.name; }},
    {"message-sender", "sender", [](const Message& m) { return m.sender; }},
    {"message-send-type", "send type",
     [](const Message& m) { return std::string(send_type_texts[static_cast<std::size_t>(m.send_type)]); }},
    {"message-format", "frame format",
     [](const Message& m) { return std::string(m.standard_format ? "standard" : "extended"); }},
    {"message-length", "length, bytes", [](const Message& m) { return fmt::format("{}", m.length); }},
    {"message-cycle", "cycle time, ms",
     [](const Message& m) {
         return m.cycle_ms ? fmt::format("{}", *m.cycle_ms) : std::string("not stated");
     }},
};

struct SignalRow {
    std::string_view name;
    std::string_view text;
    std::string (*value)(const Signal& signal);
};

std::string values_text(const Signal& signal) {
    std::vector<dbc::NamedValue> values = signal.values;
    std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    std::string text;
    for (const dbc::NamedValue& value : values) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", value.value, value.text);
    }
    return text.empty() ? "none" : text;
}

// In any order, as the format means it.
std::string receivers_text(const Signal& signal) {
    std::vector<std::string> receivers = signal.receivers;
    std::sort(receivers.begin(), receivers.end());
    return receivers.empty() ? "none" : fmt::format("{}", fmt::join(receivers, ", "));
}

constexpr SignalRow signal_rows[] = {
    {"signal-place", "first bit, length",
     [](const Signal& s) {
         return fmt::format("{}, {}{}{}", s.start_bit, s.length, s.big_endian ? ", big-endian" : "",
                            s.multiplexing.empty() ? "" : ", multiplexed " + s.multiplexing);
     }},
    {"signal-sign", "sign", [](const Signal& s) { return std::string(s.is_signed ? "signed" : "unsigned"); }},
    {"signal-scaling", "factor, offset",
     [](const Signal& s) { return fmt::format("{}, {}", base::to_text(s.factor), base::to_text(s.offset)); }},
    {"signal-range", "range",
     [](const Signal& s) {
         return fmt::format("{}..{}", base::to_text(s.minimum), base::to_text(s.maximum));
     }},
    {"signal-unit", "unit", [](const Signal& s) { return s.unit; }},
    {"signal-values", "named values", values_text},
    {"signal-receivers", "receivers", receivers_text},
};

class Comparer {
  public:
    Comparer(const dbc::Database& expected, const dbc::Database& found, const std::string& gateway)
        : expected_(expected), found_(found), gateway_(gateway) {}

    dictionary::Differences run() {
        for (const dbc::Node& node : expected_.nodes) {
            const bool is_there = std::any_of(found_.nodes.begin(), found_.nodes.end(),
                                              [&](const dbc::Node& each) { return each.name == node.name; });
            add("node", "node", "list of nodes", node.name, is_there ? node.name : "missing");
        }
        for (const Message& message : expected_.messages) {
            const auto same = find(found_, message.identifier);
            if (same == nullptr) {
                add("message", "message", subject_of(message), message.name, "missing");
            } else {
                compare(message, *same);
            }
        }
        for (const Message& message : found_.messages) {
            if (find(expected_, message.identifier) == nullptr && is_of_gateway(message)) {
                add("message", "message", subject_of(message), "missing", message.name);
            }
        }
        return std::move(result_);
    }

  private:
    static const Message* find(const dbc::Database& database, std::uint16_t identifier) {
        const auto found = std::find_if(database.messages.begin(), database.messages.end(),
                                        [&](const Message& each) { return each.identifier == identifier; });
        return found != database.messages.end() ? &*found : nullptr;
    }

    bool is_of_gateway(const Message& message) const { return message.sender == gateway_; }

    static std::string subject_of(const Message& message) {
        return fmt::format("{} {}", base::identifier_text(message.identifier), message.name);
    }

    void add(std::string_view aspect, std::string_view text, const std::string& subject, std::string a,
             std::string b) {
        if (a != b) {
            Difference difference{aspect, text, {}, {}, subject};
            difference.a = std::move(a);
            difference.b = std::move(b);
            result_.all.push_back(std::move(difference));
        }
    }

    void compare(const Message& a, const Message& b) {
        for (const MessageRow& row : message_rows) {
            add(row.name, row.text, subject_of(a), row.value(a), row.value(b));
        }
        for (const Signal& signal : a.signals) {
            const auto same = find(b, signal.name);
            if (same == nullptr) {
                add("signal", "signal", subject_of(a), signal.name, "missing");
                continue;
            }
            for (const SignalRow& row : signal_rows) {
                add(row.name, row.text, fmt::format("{}, {}", subject_of(a), signal.name), row.value(signal),
                    row.value(*same));
            }
        }
        for (const Signal& signal : b.signals) {
            if (find(a, signal.name) == nullptr) {
                add("signal", "signal", subject_of(a), "missing", signal.name);
            }
        }
    }

    static const Signal* find(const Message& message, const std::string& name) {
        const auto found = std::find_if(message.signals.begin(), message.signals.end(),
                                        [&](const Signal& each) { return each.name == name; });
        return found != message.signals.end() ? &*found : nullptr;
    }

    const dbc::Database& expected_;
    const dbc::Database& found_;
    const std::string& gateway_;  // as sender
    dictionary::Differences result_;
};

}  // namespace

Proof prove_database(const emit::Plant& plant, const dbc::Database& database) {
    const dbc::Database made = emit::database_of(plant);
    // Printed and read again, so that both sides have gone through the format.
    diagnostic::Findings none;
    const dbc::Database expected = dbc::read(dbc::print(made), "", none);
    Proof proof;
    proof.differences = Comparer(expected, database, made.nodes.front().name).run();
    compare_id(proof, plant.configuration_id_text, configuration_id(database));
    proof.compared = fmt::format("{} messages", expected.messages.size());
    return proof;
}

}  // namespace cgw::proof
