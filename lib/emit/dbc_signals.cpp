// The signals of the plant's frames in the words of a CAN database.
#include "dictionary/ascii.hpp"
#include "emit/dbc_parts.hpp"
#include "signals/comment.hpp"

namespace cgw::emit {

dbc::Signal dbc_signal(const signals::Signal& from) {
    dbc::Signal signal;
    signal.name = from.name;
    signal.start_bit = from.first_bit;
    signal.length = from.width;
    signal.is_signed = from.is_signed;
    signal.factor = from.factor;
    signal.offset = from.offset;
    signal.minimum = from.minimum;
    signal.maximum = from.maximum;
    signal.comment = signals::comment_of(from);
    if (!from.is_bit() && !from.scaled) {
        signal.comment += "; raw number, its scaling is not known";
    } else if (dictionary::has_ascii_form(from.unit)) {
        signal.unit = from.unit;
    } else {
        signal.comment += "; scaled, but its unit has no spelling in ASCII and is left out";
    }
    for (const signals::NamedValue& value : from.values) {
        signal.values.push_back({static_cast<std::uint32_t>(value.raw), value.text});
    }
    return signal;
}

}  // namespace cgw::emit
