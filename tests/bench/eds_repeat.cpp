// eds_repeat STAGE OBJECTS COUNT: makes an EDS of so many objects and takes it COUNT times through a stage.
// Two runs under a tool that counts instructions, and their difference, give the cost of one
// (tests/bench/eds_instructions). Prints the bytes of the EDS; without arguments the names of the stages.
#include <cstdlib>
#include <iostream>

#include "bench/eds_stages.hpp"

int main(int argc, char** argv) {
    using namespace cgw::bench;
    if (argc == 1) {
        for (const EdsStage& stage : eds_stages()) {
            std::cout << stage.name << '\n';
        }
        return 0;
    }
    for (const EdsStage& stage : eds_stages()) {
        if (argc == 4 && stage.name == argv[1]) {
            const EdsSample sample(static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)));
            std::size_t sum = 0;
            const unsigned long count = std::strtoul(argv[3], nullptr, 10);
            for (unsigned long i = 0; i < count; ++i) {
                sum += stage.run(sample);
            }
            std::cout << sample.text.size() << '\n';
            return count == 0 || sum > 0 ? 0 : 1;
        }
    }
    std::cerr << "usage: eds_repeat [STAGE OBJECTS COUNT]\n";
    return 2;
}
