#include "parameter/canonical_model.hpp"

#include <array>
#include <deque>

#include "base/numbers.hpp"
#include "base/utf8.hpp"

namespace cgw::parameter {
namespace {

// Takes one line apart; after the first thing that does not fit it is false.
class Line {
  public:
    explicit Line(std::string_view text) : rest_(text) {}

    bool fits() const { return fits_; }
    bool at_end() const { return rest_.empty(); }

    // Up to the next blank.
    std::string_view word() {
        const std::string_view word = rest_.substr(0, rest_.find(' '));
        fits_ = fits_ && !word.empty();
        drop(word.size());
        return word;
    }

    std::int64_t integer(std::int64_t lowest, std::int64_t highest) {
        return integer_of(word(), lowest, highest);
    }

    std::int64_t integer_of(std::string_view text, std::int64_t lowest, std::int64_t highest) {
        const auto number = base::parse_integer(text);
        fits_ = fits_ && number && *number >= lowest && *number <= highest;
        return fits_ ? *number : 0;
    }

    double real_of(std::string_view text) {
        const auto number = base::parse_real(text);
        fits_ = fits_ && number.has_value();
        return number.value_or(0);
    }

    // A JSON string and the blank behind it.
    std::string string() {
        std::string text;
        fits_ = fits_ && rest_.starts_with('"');
        std::size_t at = 1;
        while (fits_ && at < rest_.size() && rest_[at] != '"') {
            at += rest_[at] == '\\' ? escape(rest_.substr(at + 1), text) : plain(rest_.substr(at), text);
        }
        fits_ = fits_ && at < rest_.size() && (at + 1 == rest_.size() || rest_[at + 1] == ' ');
        drop(std::min(at + 1, rest_.size()));
        return text;
    }

    template <typename Value, std::size_t count>
    Value one_of(const std::array<std::pair<std::string_view, Value>, count>& known) {
        const std::string_view found = word();
        for (const auto& [name, value] : known) {
            if (name == found) {
                return value;
            }
        }
        fits_ = false;
        return {};
    }

    void fail() { fits_ = false; }

  private:
    // And the blank behind it, which stands between two things.
    void drop(std::size_t size) {
        rest_.remove_prefix(size);
        fits_ = fits_ && rest_ != " ";
        rest_.remove_prefix(rest_.empty() ? 0 : 1);
    }

    std::size_t plain(std::string_view from, std::string& text) {
        const std::size_t size = base::utf8_sequence_length(from);
        fits_ = fits_ && size != 0;
        text += from.substr(0, size);
        return size;
    }

    // The writer escapes what is below U+0080 only.
    std::size_t escape(std::string_view from, std::string& text) {
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
        const std::size_t letter = from.empty() ? std::string_view::npos : letters.find(from.front());
        if (letter != std::string_view::npos) {
            text += meanings[letter];
            return 2;
        }
        const bool is_code = from.starts_with('u') && from.size() >= 5;
        const auto code = base::parse_integer(is_code ? from.substr(1, 4) : "", 16);
        fits_ = fits_ && code && *code >= 0 && *code < 0x80;
        text += fits_ ? std::string(1, static_cast<char>(*code)) : "";
        return 6;
    }

    std::string_view rest_;
    bool fits_ = true;
};

constexpr std::array<std::pair<std::string_view, Device>, 2> devices = {
    {{"governor", Device::governor}, {"gateway", Device::gateway}}};
constexpr std::array<std::pair<std::string_view, List>, 4> lists = {{{"parameter", List::parameter},
                                                                     {"measurement", List::measurement},
                                                                     {"function", List::function},
                                                                     {"curve", List::curve}}};
constexpr std::array<std::pair<std::string_view, Role>, 4> roles = {{{"switch", Role::switch_assignment},
                                                                     {"switch-type", Role::switch_type},
                                                                     {"sensor", Role::sensor_assignment},
                                                                     {"sensor-type", Role::sensor_type}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> signs = {{{"signed", true}, {"unsigned", false}}};

constexpr std::int64_t highest_number = 65535;

// "-100..100", where an end may also be "@980" or "?"
std::pair<std::string_view, std::string_view> ends_of(std::string_view text, Line& line) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) {
        line.fail();
        return {};
    }
    return {text.substr(0, dots), text.substr(dots + 2)};
}

void read_limit(std::string_view text, std::optional<double>& constant, std::uint16_t& reference,
                Line& line) {
    if (text.starts_with('@')) {
        reference = static_cast<std::uint16_t>(line.integer_of(text.substr(1), 1, highest_number));
    } else if (text != "?") {
        constant = line.real_of(text);
    }
}

Scaling read_scaling(Line& line) {
    Scaling scaling;
    const auto [low, high] = ends_of(line.word(), line);
    scaling.internal_minimum = static_cast<std::int32_t>(line.integer_of(low, INT32_MIN, INT32_MAX));
    scaling.internal_maximum = static_cast<std::int32_t>(line.integer_of(high, INT32_MIN, INT32_MAX));
    const auto [from, to] = ends_of(line.word(), line);
    read_limit(from, scaling.external_minimum, scaling.external_minimum_parameter, line);
    read_limit(to, scaling.external_maximum, scaling.external_maximum_parameter, line);
    return scaling;
}

void read_row(Line& line, CanonicalModel& model) {
    CanonicalRow row;
    row.device = line.one_of(devices);
    row.number = static_cast<std::uint16_t>(line.integer(1, highest_number));
    row.name = line.string();
    row.list = line.one_of(lists);
    if (row.list == List::measurement) {
        row.width = static_cast<std::uint8_t>(line.integer(0, 16));
        row.is_signed = line.one_of(signs);
        row.unit = line.string();
        if (!line.at_end()) {
            row.scaling = read_scaling(line);
        }
    } else if (!line.at_end()) {
        row.role = line.one_of(roles);
    }
    model.rows.push_back(std::move(row));
}

void read_value(std::string_view device, Line& line, CanonicalModel& model) {
    CanonicalValue value;
    value.device = device == "gateway" ? Device::gateway : Device::governor;
    value.number = static_cast<std::uint16_t>(line.integer(1, highest_number));
    value.value = line.real_of(line.word());
    model.values.push_back(value);
}

bool read_line(std::string_view text, CanonicalModel& model) {
    Line line(text);
    const std::string_view kind = line.word();
    if (kind == "cgw-configuration") {
        line.integer(1, 1);
    } else if (kind == "title") {
        model.title = line.string();
    } else if (kind == "identity") {
        model.identity.software_version = static_cast<std::uint32_t>(line.integer(0, UINT32_MAX));
        model.identity.serial_date = static_cast<std::uint32_t>(line.integer(0, UINT32_MAX));
        model.identity.serial_number = static_cast<std::uint32_t>(line.integer(0, UINT32_MAX));
    } else if (kind == "main-cycle-us") {
        model.main_cycle_us = static_cast<std::uint32_t>(line.integer(0, UINT32_MAX));
    } else if (kind == "row") {
        read_row(line, model);
    } else if (kind == "governor" || kind == "gateway") {
        read_value(kind, line, model);
    } else {
        return false;
    }
    return line.fits() && line.at_end();
}

// What canonical_text() says of a plant with this model.
std::string text_of(const CanonicalModel& model) {
    Settings settings;
    settings.title = model.title;
    settings.identity = model.identity;
    settings.main_cycle_us = model.main_cycle_us;
    std::deque<Row> rows;
    for (const CanonicalRow& row : model.rows) {
        settings.declarations.push_back(&rows.emplace_back(row.row()));
    }
    for (const CanonicalValue& value : model.values) {
        Row& row = rows.emplace_back();
        row.number = value.number;
        Assignment assignment;
        assignment.row = &row;
        assignment.value = value.value;
        (value.device == Device::governor ? settings.governor : settings.gateway).assign(assignment);
    }
    return canonical_text(settings);
}

}  // namespace

Row CanonicalRow::row() const {
    Row made;
    made.device = device;
    made.number = number;
    made.name = name;
    made.list = list;
    made.role = role;
    made.width = width;
    made.is_signed = is_signed;
    made.unit = unit;
    made.scaling = scaling;
    return made;
}

std::optional<CanonicalModel> read_canonical_text(std::string_view text) {
    if (!text.starts_with("cgw-configuration 1\n")) {
        return std::nullopt;
    }
    CanonicalModel model;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos || !read_line(rest.substr(0, end), model)) {
            return std::nullopt;
        }
        rest.remove_prefix(end + 1);
    }
    // A value twice, lines in another order, a number written otherwise: none of it is written by cgw.
    return text_of(model) == text ? std::optional(std::move(model)) : std::nullopt;
}

}  // namespace cgw::parameter
