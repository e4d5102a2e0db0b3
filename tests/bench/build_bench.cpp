// What `cgw build` does, stage by stage, without the process around it.
//   cmake --preset bench && cmake --build --preset bench && build/bench/tests/bench/cgw_bench
#include <benchmark/benchmark.h>

#include <filesystem>
#include <stdexcept>

#include "driver/check_file.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"

namespace driver = cgw::driver;

namespace {

std::string sample(benchmark::State& state) {
    const char* names[] = {"minimal.toml", "genset.toml", "manual-example.toml"};
    const std::string name = names[state.range(0)];
    state.SetLabel(name);
    return std::string(CGW_SAMPLES) + "/" + name;
}

driver::CheckedFile checked(const std::string& path) {
    driver::CheckedFile file = driver::check_file(path);
    if (!file.valid()) {
        throw std::runtime_error(path + " is not valid");
    }
    return file;
}

void check(benchmark::State& state) {
    const std::string path = sample(state);
    for (auto _ : state) {
        benchmark::DoNotOptimize(checked(path));
    }
}

void artefacts(benchmark::State& state) {
    const driver::CheckedFile file = checked(sample(state));
    for (auto _ : state) {
        benchmark::DoNotOptimize(driver::build_artefacts(driver::Plant::make(file)->view()));
    }
}

void build(benchmark::State& state) {
    const std::string path = sample(state);
    const std::filesystem::path directory =
        std::filesystem::temp_directory_path() / ("cgw-bench-" + std::to_string(state.range(0)));
    for (auto _ : state) {
        std::filesystem::remove_all(directory);
        const driver::CheckedFile file = checked(path);
        const auto plant = driver::Plant::make(file);
        if (!driver::write_artefacts(directory, driver::build_artefacts(plant->view()))) {
            state.SkipWithError("cannot write");
        }
    }
    std::filesystem::remove_all(directory);
}

}  // namespace

BENCHMARK(check)->DenseRange(0, 2);
BENCHMARK(artefacts)->DenseRange(0, 2);
BENCHMARK(build)->DenseRange(0, 2);
