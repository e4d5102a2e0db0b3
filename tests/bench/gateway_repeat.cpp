// gateway_repeat OPERATION COUNT: does one thing COUNT times. Two runs under a tool that counts instructions,
// and their difference, give the cost of one (tests/bench/instructions).
#include <cstdlib>
#include <iostream>

#include "gateway_operations.hpp"

int main(int argc, char** argv) {
    if (argc == 1) {
        for (const cgw::bench::Operation& operation : cgw::bench::operations()) {
            std::cout << operation.name << '\n';
        }
        return 0;
    }
    cgw::bench::RunningGateway running;
    const std::uint64_t before = running.port.frames;
    for (const cgw::bench::Operation& operation : cgw::bench::operations()) {
        if (argc == 3 && operation.name == argv[1]) {
            const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
            for (std::uint64_t i = 0; i < count; ++i) {
                operation.run(running);
            }
            return running.port.frames - before == count * operation.frames ? 0 : 1;
        }
    }
    std::cerr << "usage: gateway_repeat [OPERATION COUNT]\n";
    return 2;
}
