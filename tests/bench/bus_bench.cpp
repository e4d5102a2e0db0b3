// The analysis of a bus, and logs as `cgw decode` reads them; items are messages and frames.
//   cmake --preset bench && cmake --build --preset bench && build/bench/tests/bench/bus_bench
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <iterator>
#include <random>
#include <stdexcept>

#include "driver/plant.hpp"
#include "driver/traffic_subject.hpp"
#include "media/log_reader.hpp"
#include "network/analysis.hpp"
#include "traffic/render.hpp"

namespace {

using cgw::network::Message;
namespace traffic = cgw::traffic;

cgw::driver::CheckedFile checked(const std::string& path) {
    cgw::driver::CheckedFile file = cgw::driver::check_file(path);
    if (!file.valid()) {
        throw std::runtime_error(path + " is not valid");
    }
    return file;
}

struct Genset {
    cgw::driver::CheckedFile file = checked(CGW_SAMPLES "/genset.toml");
    cgw::driver::Plant plant = *cgw::driver::Plant::make(file);
    cgw::emit::Plant view = plant.view();
    traffic::Subject subject = cgw::driver::traffic_subject(file, view);
};

// Eight bytes each, more urgent ones more often, half of 1 Mbit/s together.
std::vector<Message> messages(std::uint32_t count) {
    std::vector<Message> all;
    for (std::uint32_t i = 0; i < count; ++i) {
        all.push_back({.identifier = 0x80 + i,
                       .bytes = 8,
                       .name = "message",
                       .period_us = std::uint64_t{270} * count * (i + count) / (count + count / 2)});
    }
    return all;
}

void analyse(benchmark::State& state) {
    const std::vector<Message> all = messages(static_cast<std::uint32_t>(state.range(0)));
    const cgw::network::Bus bus{.bit_rate = 1'000'000};
    std::size_t bounded = 0;
    for (auto _ : state) {
        const cgw::network::Analysis analysis = cgw::network::analyse(all, bus);
        bounded = 0;
        for (const cgw::network::MessageResult& result : analysis.messages) {
            bounded += result.bounded() ? 1U : 0U;
        }
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
    state.counters["bounded"] = static_cast<double>(bounded);
}

// As candump -L writes them: PDOs, heartbeats, EMCY and SDO of the genset and of others.
std::string log_of(std::int64_t frames) {
    constexpr std::array identifiers{0x18C, 0x28C, 0x38C, 0x48C, 0x70C, 0x20C, 0x08C, 0x58C, 0x321};
    std::mt19937_64 random(1);  // the same log each time
    std::string text;
    for (std::int64_t i = 0; i < frames; ++i) {
        fmt::format_to(std::back_inserter(text), "({}.{:06}) can0 {:03X}#{:016X}\n", 1'700'000'000 + i / 2000,
                       i % 2000 * 500, identifiers[random() % identifiers.size()], random());
    }
    return text;
}

// The second argument: 0 only the audit, 1.. each format.
void decode(benchmark::State& state) {
    static const Genset genset;
    const std::string text = log_of(state.range(0));
    const std::size_t which = static_cast<std::size_t>(state.range(1));
    const traffic::Format* format = which == 0 ? nullptr : &traffic::formats()[which - 1];
    state.SetLabel(format == nullptr ? "audit" : std::string(format->name));
    using Kind = cgw::media::LogReader::Kind;
    for (auto _ : state) {
        traffic::Decoder decoder(genset.subject);
        traffic::Audit audit(genset.subject, decoder.owners());
        cgw::media::LogReader reader;
        reader.feed(text);
        reader.finish();
        for (const auto* item = &reader.next(); item->kind != Kind::end; item = &reader.next()) {
            audit.take({item->number, item->logged.time_us, item->has_time, item->logged.frame});
            if (format != nullptr) {
                benchmark::DoNotOptimize(format->frame({item->logged, decoder.decode(item->logged.frame),
                                                        item->number, item->has_time, audit.first_us()}));
            }
        }
        audit.finish(reader.has_lines());
        benchmark::DoNotOptimize(audit.findings("run.log"));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

}  // namespace

BENCHMARK(analyse)->Arg(20)->Arg(200)->Arg(1'900)->Unit(benchmark::kMillisecond);
BENCHMARK(decode)->ArgsProduct({{1'000, 100'000, 1'000'000}, {0, 1, 2, 3}})->Unit(benchmark::kMillisecond);
