// Nanoseconds of what a gateway does over and over; tests/bench/instructions counts instructions of the same.
#include <benchmark/benchmark.h>

#include "gateway_operations.hpp"

namespace {

void run(benchmark::State& state, const cgw::bench::Operation& operation) {
    cgw::bench::RunningGateway running;
    for (auto _ : state) {
        operation.run(running);
    }
    if (operation.received) {
        // What one core has to do, in percent, while the shortest frames follow each other at 1 Mbit/s.
        constexpr double frames_per_second = 18'182;
        state.counters["core%"] =
            benchmark::Counter(1 / (100 * frames_per_second),
                               benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    }
    if (operation.frames != 0 && running.port.frames == 0) {
        state.SkipWithError("nothing was sent");
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (const cgw::bench::Operation& operation : cgw::bench::operations()) {
        benchmark::RegisterBenchmark(std::string(operation.name).c_str(), run, operation);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
