// A line for each signal of a PDO, and one for every other frame.
#include <fmt/format.h>

#include "base/numbers.hpp"
#include "base/text_cells.hpp"
#include "signals/codec.hpp"
#include "traffic/render_parts.hpp"

namespace cgw::traffic {

std::string csv_head(const Subject& /*subject*/) {
    return "time_s,interface,id,data,service,name,node,signal,raw,physical,unit,text\n";
}

std::string csv_frame(const Told& told) {
    const frame::Frame& frame = told.logged.frame;
    const Meaning& meaning = told.meaning;
    const std::span<const std::uint8_t> data(frame.data.data(), frame.remote ? 0U : frame.length);
    const std::uint64_t time = told.logged.time_us;
    const std::string front = fmt::format(
        "{},{},{:0{}X},{},{},{},{},",
        told.has_time ? fmt::format("{}.{:06}", time / 1'000'000, time % 1'000'000) : "",
        base::csv_field(told.logged.interface_name), frame.id, frame.extended ? 8 : 3,
        frame.remote ? "R" : fmt::format("{:02X}", fmt::join(data, "")), to_text(meaning.owner.service),
        meaning.name, meaning.owner.node == 0 ? "" : fmt::format("{}", meaning.owner.node));
    if (meaning.owner.frame == nullptr) {
        return fmt::format("{},,,,{}\n", front, base::csv_field(meaning.text));
    }
    std::string text;
    for (const signals::Signal& signal : meaning.owner.frame->signals) {
        if (signals::reaches(signal, data)) {
            const std::int32_t raw = signals::raw_value(signal, data);
            text += fmt::format("{}{},{},{},{},{}\n", front, signal.name, raw,
                                signals::physical_text(signal, raw), base::csv_field(signal.unit),
                                base::csv_field(signals::value_text(signal, raw)));
        }
    }
    return text.empty() ? fmt::format("{},,,,{}\n", front, base::csv_field(meaning.text)) : text;
}

}  // namespace cgw::traffic
