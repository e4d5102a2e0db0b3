// Writes what tests/partner/agreement_test.py compares: partner_program FILE DIRECTORY [SEED]. With a seed
// the names and texts of the plant are hostile ones.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>

#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "driver/scenario_file.hpp"
#include "emit/partner_half.hpp"
#include "partner/c_program.hpp"
#include "partner/frames.hpp"
#include "partner/hostile.hpp"

namespace cgw::test {
namespace {

constexpr unsigned random_frames = 40;
constexpr unsigned encoded_frames = 200;

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

int run(const std::string& file_name, const std::filesystem::path& directory, std::uint32_t seed) {
    const driver::CheckedFile file = driver::check_file(file_name);
    if (!file.valid()) {
        return 1;
    }
    const auto plant = driver::Plant::make(file);
    const auto image = driver::image_bytes(file);
    const partner::Half honest = emit::partner_half(plant->view());
    const partner::Half half = seed == 0 ? honest : hostile(honest, seed);
    const std::vector<PdoFrame> frames = record(half, *image, random_frames);
    const Encoding encoded = encodings(half, encoded_frames);
    write(directory / "partner.h", partner::c_header(half));
    write(directory / "partner.csv", partner::points(half));
    write(directory / "partner.py", partner::python_canopen(half));
    write(directory / "partner.st", partner::structured_text(half));
    write(directory / "partner.stx", partner::stx(half));
    write(directory / "main.c", c_program(half, "partner.h"));
    write(directory / "frames.txt", frame_lines(frames));
    write(directory / "decoded.txt", decoded_lines(frames));
    write(directory / "encode.txt", encoded.lines);
    write(directory / "encoded.txt", encoded.expected);
    return 0;
}

}  // namespace
}  // namespace cgw::test

int main(int count, char** arguments) {
    if (count < 3) {
        return 2;
    }
    std::uint32_t seed = 0;
    if (count > 3) {
        const std::string_view text = arguments[3];
        std::from_chars(text.data(), text.data() + text.size(), seed);
    }
    return cgw::test::run(arguments[1], arguments[2], seed);
}
