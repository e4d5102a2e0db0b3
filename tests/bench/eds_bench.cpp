// How fast generated EDS files of 10 to 50,000 objects are read, checked, repaired and written.
#include <benchmark/benchmark.h>

#include <map>

#include "bench/eds_stages.hpp"

namespace {

using namespace cgw::bench;

const EdsSample& sample_of(unsigned objects) {
    static std::map<unsigned, EdsSample> samples;
    return samples.try_emplace(objects, objects).first->second;
}

void run(benchmark::State& state, const EdsStage& stage) {
    const EdsSample& sample = sample_of(static_cast<unsigned>(state.range(0)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(stage.run(sample));
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(sample.text.size()) * state.iterations());
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    for (const EdsStage& stage : eds_stages()) {
        auto* const made = benchmark::RegisterBenchmark(
            std::string(stage.name).c_str(), [&stage](benchmark::State& state) { run(state, stage); });
        for (const int objects : {10, 1'000, 5'000, 50'000}) {
            made->Arg(objects);
        }
        made->Unit(benchmark::kMillisecond);
    }
    benchmark::RunSpecifiedBenchmarks();
}
