#include "signals/comment.hpp"

#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "signals/layout.hpp"
#include "signals/parts.hpp"

namespace cgw::signals {
namespace {

std::string object_text(const Signal& signal) {
    return base::object_text(signal.index, signal.sub_index);
}

std::string error_comment(const Signal& signal) {
    std::string comment = fmt::format("{}, {}", signal.number, object_text(signal));
    for (const Source& source : signal.sources) {
        comment += fmt::format("; {} {}", parameter::to_text(source.device), source.name);
    }
    return comment + "; 1: the error is present";
}

std::string switch_comment(const Signal& signal) {
    std::string comment = object_place(signal);
    for (const Source& source : signal.sources) {
        comment += fmt::format("; {}, {}", source.label(),
                               source.low_active ? "low-active: 0 is on" : "high-active: 1 is on");
    }
    return comment;
}

std::string sensor_comment(const Signal& signal) {
    std::string comment =
        fmt::format("channel {}, {}: {}", signal.channel, object_text(signal), labels_of(signal.sources));
    if (!signal.scaled_as.empty()) {
        comment += "; shown by " + labels_of(signal.scaled_as);
    }
    return comment;
}

}  // namespace

std::string labels_of(const std::vector<Source>& sources) {
    std::string text;
    for (const Source& source : sources) {
        text += (text.empty() ? "" : ", ") + source.label();
    }
    return text;
}

std::string comment_of(const Signal& signal) {
    switch (signal.kind) {
        case Kind::error:
            return error_comment(signal);
        case Kind::engine_state:
            return object_place(signal) + "; its meaning depends on the governor and is not printed";
        case Kind::switch_function:
            return switch_comment(signal);
        case Kind::sensor_flag:
            return fmt::format("{}, error flag of channel {}: {}; 1: faulty", object_place(signal),
                               signal.channel, labels_of(signal.sources));
        case Kind::measurement:
            return fmt::format("{}, {}", labels_of(signal.sources), object_text(signal));
        case Kind::sensor:
            break;
    }
    return sensor_comment(signal);
}

}  // namespace cgw::signals
