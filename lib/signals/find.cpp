#include "signals/find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/numbers.hpp"

namespace cgw::signals {
namespace {

// What the manual puts in front of the name of a sensor's and a switch's assignment.
constexpr std::array<std::string_view, 2> first_words{"AssignIn_", "Funct"};

std::string_view without_first_word(std::string_view name) {
    for (const std::string_view word : first_words) {
        if (name.size() > word.size() && name.starts_with(word)) {
            return name.substr(word.size());
        }
    }
    return name;
}

// Other names of a signal. Its sensor's flag shares all of them and must be called by its own name, or by it
// without the first word.
std::vector<std::string> other_names(const Signal& signal) {
    std::vector<std::string> names{std::string(without_first_word(signal.name))};
    if (signal.kind == Kind::sensor_flag) {
        return names;
    }
    std::vector<Source> sources = signal.sources;
    sources.insert(sources.end(), signal.scaled_as.begin(), signal.scaled_as.end());
    if (signal.number != 0) {
        names.push_back(fmt::format("{}", signal.number));
    }
    for (const Source& source : sources) {
        names.push_back(fmt::format("{}", source.number));
        names.push_back(source.name);
        names.push_back(source.label());
        names.emplace_back(without_first_word(source.name));
    }
    std::erase(names, "");
    return names;
}

std::optional<std::int64_t> identifier_of(std::string_view text) {
    if (text.starts_with("0x") || text.starts_with("0X")) {
        return base::parse_integer(text.substr(2), 16);
    }
    if (text.ends_with('h') || text.ends_with('H')) {
        return base::parse_integer(text.substr(0, text.size() - 1), 16);
    }
    return std::nullopt;
}

}  // namespace

const Frame* find_frame(const std::vector<Frame>& frames, std::string_view name) {
    const std::optional<std::int64_t> identifier = identifier_of(name);
    const auto found = std::find_if(frames.begin(), frames.end(), [&](const Frame& frame) {
        return base::lowered(frame.name) == base::lowered(name) || frame.identifier == identifier;
    });
    return found == frames.end() ? nullptr : &*found;
}

FoundSignal find_signal(const Frame& frame, std::string_view name) {
    const std::string wanted = base::lowered(name);
    FoundSignal found;
    for (const Signal& signal : frame.signals) {
        if (base::lowered(signal.name) == wanted) {
            return {&signal, false};
        }
        const std::vector<std::string> names = other_names(signal);
        const bool fits = std::any_of(names.begin(), names.end(), [&](const std::string& other) {
            return base::lowered(other) == wanted;
        });
        if (fits) {
            found.ambiguous = found.ambiguous || found.signal != nullptr;
            found.signal = &signal;
        }
    }
    if (found.ambiguous) {
        found.signal = nullptr;
    }
    return found;
}

std::string nearest_signal(const Frame& frame, std::string_view name) {
    std::vector<std::string> names;
    for (const Signal& signal : frame.signals) {
        names.push_back(signal.name);
        for (std::string& other : other_names(signal)) {
            names.push_back(std::move(other));
        }
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const std::string nearest = base::nearest_name(name, candidates);
    const FoundSignal found = find_signal(frame, nearest);
    return found.signal != nullptr ? found.signal->name : nearest;
}

}  // namespace cgw::signals
