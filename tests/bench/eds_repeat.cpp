// eds_repeat STAGE OBJECTS COUNT: makes an EDS of so many objects and takes it COUNT times through a stage.
// Two runs under a tool that counts instructions, and their difference, give the cost of one
// (tests/bench/eds_instructions). Prints the bytes of the EDS; without arguments the names of the stages.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <iostream>

#include "eds/reader.hpp"
#include "eds/writer.hpp"

namespace {

using namespace cgw;

// Every fourth object is a record of two entries; each begins with a value that follows the node number.
dictionary::Dictionary sample(unsigned objects) {
    dictionary::Dictionary dictionary;
    for (unsigned i = 0; i < objects; ++i) {
        dictionary::Object& object = dictionary.objects.emplace_back();
        object.index = static_cast<std::uint16_t>(0x1000 + i);
        object.name = fmt::format("Object number {}", i);
        const bool is_record = i % 4 == 3;
        object.code = is_record ? object::ObjectCode::record : object::ObjectCode::var;
        for (std::uint8_t sub = 0; sub < (is_record ? 3 : 1); ++sub) {
            dictionary::Variable& variable = object.variables.emplace_back();
            variable.sub_index = sub;
            variable.name = fmt::format("Entry number {}", sub);
            variable.type = object::DataType::unsigned32;
            variable.default_value = {0x180 + i, sub == 0 && i % 2 == 0};
        }
    }
    return dictionary;
}

struct Stage {
    std::string_view name;
    std::size_t (*run)(const std::string& text, const dictionary::Dictionary& dictionary);
};

constexpr std::array stages{
    Stage{"document", [](const std::string& text,
                         const dictionary::Dictionary&) { return eds::Document(text).sections().size(); }},
    Stage{"read",
          [](const std::string& text, const dictionary::Dictionary&) {
              diagnostic::Findings findings;
              const eds::Document document(text);
              return eds::read(document, "bench.eds", findings).dictionary.objects.size() +
                     findings.all().size();
          }},
    Stage{"write", [](const std::string&,
                      const dictionary::Dictionary& dictionary) { return eds::write(dictionary).size(); }},
};

}  // namespace

int main(int argc, char** argv) {
    if (argc == 1) {
        for (const Stage& stage : stages) {
            std::cout << stage.name << '\n';
        }
        return 0;
    }
    for (const Stage& stage : stages) {
        if (argc == 4 && stage.name == argv[1]) {
            const dictionary::Dictionary dictionary =
                sample(static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)));
            const std::string text = eds::write(dictionary);
            std::size_t sum = 0;
            const unsigned long count = std::strtoul(argv[3], nullptr, 10);
            for (unsigned long i = 0; i < count; ++i) {
                sum += stage.run(text, dictionary);
            }
            std::cout << text.size() << '\n';
            return count == 0 || sum > 0 ? 0 : 1;
        }
    }
    std::cerr << "usage: eds_repeat [STAGE OBJECTS COUNT]\n";
    return 2;
}
