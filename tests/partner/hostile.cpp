#include "partner/hostile.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <string_view>

#include "dbc/names.hpp"

namespace cgw::test {
namespace {

constexpr std::array<std::string_view, 40> names{
    "int",     "double", "class",    "register", "END_IF", "REAL",   "bool", "TRUE",   "Function",  "ABS",
    "ANY_INT", "raw",    "bit",      "set",      "value",  "turn",   "take", "COB_ID", "_",         "__",
    "_x",      "a__b",   "a___b__c", "X9",       "self",   "lambda", "None", "_Bool",  "pdo",       "data",
    "LENGTH",  "Decode", "result",   "limit",    "mod",    "a_b_2",  "a_b",  "word",   "Var_Input", "if"};

constexpr std::array<std::string_view, 18> texts{"*/ #error out /*",
                                                 "*) END_FUNCTION (*",
                                                 "\"; system(\"true\"); \"",
                                                 "'''\"\"\" + quit() + \"\"\"'''",
                                                 "a\nb\r\nc\x0b\x0c\x85 d",
                                                 "?\?/\n?\?' trigraph ?\?/",
                                                 "back\\slash\\",
                                                 "\xE2\x80\xAEright to left\xE2\x80\xAC",
                                                 "\xF0\x9F\x9A\xA2 ship \xC3\xA4\xC3\xB6\xC3\xBC \xC2\xB0"
                                                 "C",
                                                 "\xFF\xFE not UTF-8 \xC3",
                                                 "=1+1|cmd",
                                                 "$N$Q{pragma}",
                                                 "#define X",
                                                 "// slashes /* and stars",
                                                 "-- End_Program; End_Var;",
                                                 "%s%n {0} {x!r}",
                                                 "",
                                                 "plain"};

class Source {
  public:
    explicit Source(std::uint32_t seed) : random_(seed) {}

    std::string text() {
        std::string text(texts[random_() % texts.size()]);
        constexpr std::size_t very_long = 20'000;
        if (random_() % 8 == 0) {
            text += std::string(very_long, static_cast<char>(' ' + random_() % 95));
        }
        return text + std::string(texts[random_() % texts.size()]);
    }
    std::string name() {
        std::string name(names[random_() % names.size()]);
        if (random_() % 4 == 0) {
            name = (name + std::string(dbc::longest_name, random_() % 2 == 0 ? 'x' : '_'))
                       .substr(0, dbc::longest_name);
        }
        return name;
    }

    // Another line between raw numbers and physical values, falling ones and negative numbers among them.
    void scale(signals::Signal& signal) {
        constexpr std::array factors{0.0625, -0.5, 0.001, -12.25};
        constexpr std::array offsets{0.0, -273.15, 1000.0};
        constexpr std::int32_t half_of_all = 32768;
        signal.is_signed = random_() % 2 == 0;
        signal.scaled = true;
        signal.factor = factors[random_() % factors.size()];
        signal.offset = offsets[random_() % offsets.size()];
        signal.raw_minimum = signal.is_signed ? -static_cast<std::int32_t>(random_() % half_of_all) : 0;
        signal.raw_maximum = static_cast<std::int32_t>(1 + random_() % (half_of_all - 1));
        const double one = signal.raw_minimum * signal.factor + signal.offset;
        const double other = signal.raw_maximum * signal.factor + signal.offset;
        signal.minimum = std::min(one, other);
        signal.maximum = std::max(one, other);
    }

  private:
    std::mt19937 random_;
};

}  // namespace

partner::Half hostile(partner::Half half, std::uint32_t seed) {
    Source source(seed);
    half.title = source.text();
    for (signals::Frame& frame : half.frames) {
        dbc::Names taken;
        for (signals::Signal& signal : frame.signals) {
            signal.name = taken.take(source.name());
            if (!signal.is_bit()) {
                source.scale(signal);
            }
            signal.unit = signal.scaled ? source.text() : "";
            for (signals::Source& parameter : signal.sources) {
                parameter.name = source.text();
            }
            for (signals::Source& parameter : signal.scaled_as) {
                parameter.name = source.text();
            }
        }
    }
    return half;
}

}  // namespace cgw::test
