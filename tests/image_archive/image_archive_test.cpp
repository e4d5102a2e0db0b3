// Images that earlier releases wrote: what this format's major promises about them (docs/image-format.md,
// Compatibility).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/sha256.hpp"
#include "canopen/nmt.hpp"
#include "canopen/sdo.hpp"
#include "device/gateway.hpp"
#include "driver/decompile.hpp"
#include "driver/plant.hpp"
#include "image/c_reader.h"
#include "support/image_bytes.hpp"
#include "support/recording_port.hpp"

namespace cgw::test {
namespace {

namespace fs = std::filesystem;
namespace header = image::header;
using image::Status;

base::Bytes bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Version {
    unsigned major = 0;
    unsigned minor = 0;
};

Version version_of(const fs::path& directory) {
    Version version;
    char dot = 0;
    std::istringstream(directory.filename().string()) >> version.major >> dot >> version.minor;
    return version;
}

std::vector<fs::path> directories() {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(CGW_IMAGE_ARCHIVE)) {
        if (entry.is_directory()) {
            found.push_back(entry.path());
        }
    }
    return found;
}

// Archived images of this major.
std::vector<fs::path> images() {
    std::vector<fs::path> found;
    for (const fs::path& directory : directories()) {
        for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
            if (entry.path().extension() == ".bin" && version_of(directory).major == image::format_major) {
                found.push_back(entry.path());
            }
        }
    }
    EXPECT_FALSE(found.empty());
    return found;
}

bool has_labels(const fs::path& image) {
    return image.stem().extension() != ".no-labels";
}

// The parameter file that an archived image was made from.
fs::path source_of(const fs::path& image) {
    return image.parent_path() /
           (image.filename().string().substr(0, image.filename().string().find('.')) + ".toml");
}

Status status_in_c(const base::Bytes& bytes) {
    const auto ignore = [](void*, std::uint64_t) {};
    return static_cast<Status>(c_reader_dump(bytes.data(), bytes.size(), ignore, nullptr));
}

class Silent final : public device::GovernorLink {
  public:
    void status_changed(const device::GatewayStatus&) override {}
    void process_data(std::uint8_t, const device::PdoWords&) override {}
};

TEST(ImageArchive, holds_the_version_that_is_written_today) {
    const fs::path today =
        fs::path(CGW_IMAGE_ARCHIVE) / fmt::format("{}.{}", image::format_major, image::format_minor);
    EXPECT_TRUE(fs::is_directory(today)) << "see README.md beside it";
}

TEST(ImageArchive, is_as_it_was_released) {
    for (const fs::path& directory : directories()) {
        std::ifstream sums(directory / "SHA256SUMS");
        std::size_t listed = 1;  // SHA256SUMS itself
        for (std::string sum, name; sums >> sum >> name; ++listed) {
            EXPECT_EQ(base::to_hex(base::sha256(bytes_of(directory / name))), sum) << directory / name;
        }
        const auto files = std::distance(fs::directory_iterator(directory), fs::directory_iterator());
        EXPECT_EQ(static_cast<std::size_t>(files), listed) << directory;
    }
}

TEST(ImageArchive, is_accepted_by_both_readers) {
    for (const fs::path& path : images()) {
        const base::Bytes bytes = bytes_of(path);
        image::Image image;
        ASSERT_EQ(image::Image::open(bytes, image), Status::ok) << path;
        EXPECT_EQ(image.format_minor(), version_of(path.parent_path()).minor) << path;
        EXPECT_EQ(status_in_c(bytes), Status::ok) << path;
        EXPECT_EQ(c_reader_finds(bytes.data(), bytes.size()), 1) << path;
    }
}

TEST(ImageArchive, is_refused_by_both_readers_as_another_major) {
    for (const fs::path& path : images()) {
        for (const unsigned major : {0U, image::format_major - 1U, image::format_major + 1U, 0xFFFFU}) {
            const base::Bytes other = changed(bytes_of(path), header::format_major, 2, major);
            EXPECT_EQ(open(other), Status::unsupported_major) << path << " as major " << major;
            EXPECT_EQ(status_in_c(other), Status::unsupported_major) << path << " as major " << major;
        }
    }
}

TEST(ImageArchive, of_other_majors_is_refused) {
    for (const fs::path& directory : directories()) {
        if (version_of(directory).major == image::format_major) {
            continue;
        }
        for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
            if (entry.path().extension() == ".bin") {
                EXPECT_EQ(open(bytes_of(entry.path())), Status::unsupported_major) << entry.path();
            }
        }
    }
}

TEST(ImageArchive, carries_the_id_that_its_parameter_file_has_today) {
    for (const fs::path& path : images()) {
        const base::Bytes bytes = bytes_of(path);
        image::Image image;
        ASSERT_EQ(image::Image::open(bytes, image), Status::ok) << path;
        const driver::CheckedFile file = driver::check_file(source_of(path).string());
        ASSERT_TRUE(file.valid()) << source_of(path);
        const auto plant = driver::Plant::make(file);
        const std::array<std::uint8_t, 32> id = plant.value().view().configuration_id;
        EXPECT_EQ(base::to_hex(image.configuration_id()), base::to_hex(id)) << path;
    }
}

// What today's cgw compiles of the file that comes back is the same device.
TEST(ImageArchive, comes_back_as_a_parameter_file_that_works_alike) {
    for (const fs::path& path : images()) {
        const base::Bytes bytes = bytes_of(path);
        image::Image image;
        ASSERT_EQ(image::Image::open(bytes, image), Status::ok) << path;
        const driver::DecompiledImage made = driver::decompile(image, "archived.toml");
        EXPECT_TRUE(made.works_alike()) << path << "\n" << made.text;
        EXPECT_EQ(made.exact, has_labels(path)) << path;
    }
}

TEST(ImageArchive, runs_a_gateway) {
    for (const fs::path& path : images()) {
        const base::Bytes bytes = bytes_of(path);
        image::Image image;
        ASSERT_EQ(image::Image::open(bytes, image), Status::ok) << path;
        const std::uint8_t node = image.can2().own_node;
        RecordingPort port;
        Silent link;
        device::Gateway gateway(port, link);
        ASSERT_EQ(gateway.open(image, 0), device::OpenStatus::ok) << path;
        gateway.command(device::GovernorCommand::init, 0);
        gateway.command(device::GovernorCommand::pre_operational, 0);
        const std::vector<frame::Frame> boot_up = port.take();
        ASSERT_EQ(boot_up.size(), 1U) << path;
        EXPECT_EQ(boot_up[0].id, 0x700U + node) << path;

        gateway.receive(canopen::sdo::make_frame(0x600U + node, 0x40, {0x1018, 2}, 0), 0);
        const std::vector<frame::Frame> answer = port.take();
        ASSERT_EQ(answer.size(), 1U) << path;
        EXPECT_EQ(canopen::sdo::payload(answer[0]), image.identity().product) << path;
    }
}

}  // namespace
}  // namespace cgw::test
