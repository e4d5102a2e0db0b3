// What `cgw build` does, stage by stage, without the process around it.
//   cmake --preset bench && cmake --build --preset bench && build/bench/tests/bench/cgw_bench
#include <benchmark/benchmark.h>

#include <filesystem>
#include <stdexcept>

#include "driver/check_files.hpp"
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

// As `cgw check 'plants/**/*.toml' -j N`: items are files.
void check_many(benchmark::State& state) {
    const std::vector<std::string> paths(static_cast<std::size_t>(state.range(0)),
                                         std::string(CGW_SAMPLES) + "/genset.toml");
    for (auto _ : state) {
        driver::check_files(paths, static_cast<unsigned>(state.range(1)),
                            [](driver::CheckedFile&& file) { benchmark::DoNotOptimize(file); });
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

}  // namespace

BENCHMARK(check)->DenseRange(0, 2);
BENCHMARK(artefacts)->DenseRange(0, 2);
BENCHMARK(build)->DenseRange(0, 2);
BENCHMARK(check_many)
    ->ArgsProduct({{100, 1'000, 10'000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
