// Texts that are nearly an EDS, and texts changed at random; the same for the same seed.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace cgw::test {

class RandomText {
  public:
    explicit RandomText(std::uint32_t seed) : random_(seed) {}

    std::string text() {
        std::string result = below(8) == 0 ? "\xEF\xBB\xBF" : "";
        for (std::uint32_t pieces = below(60); pieces > 0; --pieces) {
            result += piece();
        }
        return result;
    }

    // Some bytes changed, removed, added, and some parts put elsewhere.
    std::string mutated(std::string text) {
        for (std::uint32_t changes = 1 + below(12); changes > 0 && !text.empty(); --changes) {
            const std::size_t at = below(static_cast<std::uint32_t>(text.size()));
            switch (below(4)) {
                case 0:
                    text[at] = static_cast<char>(below(256));
                    break;
                case 1:
                    text.erase(at, below(40));
                    break;
                case 2:
                    text.insert(at, piece());
                    break;
                default:
                    text.insert(at, text.substr(below(static_cast<std::uint32_t>(text.size())), below(200)));
            }
        }
        return text;
    }

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  private:
    std::string piece() {
        using namespace std::string_view_literals;
        constexpr std::array pieces{"[1000]"sv,
                                    "[1018sub1]"sv,
                                    "["sv,
                                    "]"sv,
                                    "ParameterName=Name"sv,
                                    "DataType=0x0007"sv,
                                    "="sv,
                                    "\n"sv,
                                    "\r\n"sv,
                                    "\n"sv,
                                    "\r"sv,
                                    ";"sv,
                                    "# comment"sv,
                                    " "sv,
                                    "\t"sv,
                                    "\0"sv,
                                    "\xE4"sv,
                                    "\xC3\xA4"sv,
                                    "\n[2000]\n"sv,
                                    "SubNumber=2"sv,
                                    "\nDefaultValue=$NODEID+0x180\n"sv,
                                    "CompactSubObj=254\n"sv,
                                    "[2000Value]\n"sv,
                                    "1=0x1000\n"sv};
        return std::string(pieces[below(pieces.size())]);
    }

    std::mt19937 random_;
};

}  // namespace cgw::test
