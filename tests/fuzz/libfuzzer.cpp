// The targets as libFuzzer calls them. Usage: cgw_fuzz TARGET [libFuzzer's options and directories]
#include <cstdio>
#include <cstdlib>

#include "fuzz/mutation.hpp"

namespace {

const cgw::fuzz::Target* target = nullptr;

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t limit);

namespace cgw::fuzz {

std::size_t change_bytes(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned) {
    return LLVMFuzzerMutate(data, size, limit);
}

}  // namespace cgw::fuzz

// Where libFuzzer runs this program again, it leaves the target out: the environment has it then.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    constexpr const char* variable = "CGW_FUZZ_TARGET";
    if (*argc > 1 && cgw::fuzz::find_target((*argv)[1]) != nullptr) {
        setenv(variable, (*argv)[1], 1);
        (*argv)[1] = (*argv)[0];
        ++*argv;
        --*argc;
    }
    const char* const name = std::getenv(variable);
    target = cgw::fuzz::find_target(name == nullptr ? "" : name);
    if (target == nullptr) {
        std::fputs("usage: cgw_fuzz TARGET [libFuzzer's options and directories]\n", stderr);
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    target->run({data, size});
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t limit,
                                               unsigned seed) {
    return target->mutate(data, size, limit, seed);
}
