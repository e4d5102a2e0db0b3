// The targets in the tests:
//   cgw_fuzz TARGET CORPUS                  every input of the corpus, once
//   cgw_fuzz TARGET CORPUS SECONDS INPUT    changed inputs of the corpus for so long; the file INPUT is the
//   one that
//                                           is being tried, so that it is there when it ends the program
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "base/bytes.hpp"
#include "base/files.hpp"
#include "fuzz/targets.hpp"

namespace cgw::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t largest_input = std::size_t{1024} * 1024;
constexpr std::size_t largest_changed_input = 8192;  // with sanitizers larger ones take their time
constexpr std::chrono::seconds longest_run{30};      // of one input, on a busy machine and with sanitizers

struct File {
    std::string path;
    base::Bytes bytes;
};

std::vector<File> files_in(const std::string& directory) {
    std::vector<File> files;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        const std::string path = entry.path().string();
        const auto text = base::read_file(path, largest_input);
        if (!text) {
            std::fprintf(stderr, "%s\n", text.error().message.c_str());
            std::exit(2);
        }
        files.push_back({path, base::to_bytes(*text)});
    }
    std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.path < b.path; });
    return files;
}

// From a copy that ends where the input ends, so that AddressSanitizer sees what is read behind it.
bool try_input(const Target& target, const base::Bytes& bytes) {
    const base::Bytes input(bytes.begin(), bytes.end());
    const auto began = Clock::now();
    target.run(input);
    const bool in_time = Clock::now() - began <= longest_run;
    if (!in_time) {
        std::fprintf(stderr, "took longer than %d s\n", static_cast<int>(longest_run.count()));
    }
    return in_time;
}

bool replay(const Target& target, const std::vector<File>& files) {
    return std::all_of(files.begin(), files.end(), [&](const File& file) {
        std::fprintf(stderr, "%s\n",
                     file.path.c_str());  // the last one named is the one that ended the program
        return try_input(target, file.bytes);
    });
}

base::Bytes changed(const Target& target, const File& file, std::mt19937& random) {
    base::Bytes bytes = file.bytes;
    bytes.resize(std::min(bytes.size(), largest_changed_input));
    for (unsigned changes = 1 + random() % 4; changes != 0; --changes) {
        const std::size_t size = bytes.size();
        bytes.resize(largest_changed_input);
        bytes.resize(
            target.mutate(bytes.data(), size, largest_changed_input, static_cast<unsigned>(random())));
    }
    return bytes;
}

bool try_changed(const Target& target, const std::vector<File>& files, std::chrono::seconds time,
                 const std::string& path) {
    std::mt19937 random(std::random_device{}());
    unsigned tried = 0;
    for (const auto end = Clock::now() + time; Clock::now() < end; ++tried) {
        const base::Bytes input = changed(target, files[random() % files.size()], random);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
        if (!try_input(target, input)) {
            return false;
        }
    }
    std::filesystem::remove(path);
    std::printf("%u inputs\n", tried);
    return tried > 0;
}

}  // namespace
}  // namespace cgw::fuzz

int main(int argc, char** argv) {
    using namespace cgw::fuzz;
    const Target* const target = find_target(argc > 1 ? argv[1] : "");
    if (target == nullptr || (argc != 3 && argc != 5)) {
        std::fputs("usage: cgw_fuzz TARGET CORPUS [SECONDS INPUT]\n", stderr);
        return 2;
    }
    const std::vector<File> files = files_in(argv[2]);
    if (files.empty()) {
        std::fprintf(stderr, "%s is empty\n", argv[2]);
        return 2;
    }
    const bool fine = argc == 3
                          ? replay(*target, files)
                          : try_changed(*target, files, std::chrono::seconds(std::atoi(argv[3])), argv[4]);
    return fine ? 0 : 1;
}
