// SDO transfers overheard: expedited and segmented ones with their values, block transfers by name. Both
// directions of each of the 127 servers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "traffic/subject.hpp"

namespace cgw::traffic {

class SdoListener {
  public:
    // Bytes of a segmented transfer that are kept to be shown; all are counted.
    static constexpr std::size_t most_kept = 64;

    // Refers to the subject, which outlives it.
    explicit SdoListener(const Subject& subject) : subject_(&subject) {}

    // What the next frame of a server (1..127) says: "node 12 read 1018h:1 Vendor-ID = 0x00000161".
    std::string listen(std::uint8_t node, bool request, std::span<const std::uint8_t> data);

  private:
    enum class Mode : std::uint8_t { none, download, upload, block_download, block_upload };

    struct Transfer {
        Mode mode = Mode::none;
        std::uint16_t index = 0;
        std::uint8_t sub_index = 0;
        std::array<std::uint8_t, most_kept> kept{};
        std::size_t count = 0;  // bytes transferred, kept or not
    };

    std::string request_text(std::uint8_t node, std::span<const std::uint8_t> data);
    std::string answer_text(std::uint8_t node, std::span<const std::uint8_t> data);
    std::string block_text(std::uint8_t node, bool request, std::span<const std::uint8_t> data);
    std::string segment_text(std::uint8_t node, bool upload, std::span<const std::uint8_t> data);
    std::string object_text(std::uint8_t node, std::uint16_t index, std::uint8_t sub_index) const;
    std::string value_text(std::uint8_t node, const Transfer& transfer) const;
    void begin(std::uint8_t node, Mode mode, std::span<const std::uint8_t> data);
    // The value of an expedited transfer; nothing where the length is not possible.
    void keep_expedited(Transfer& transfer, std::span<const std::uint8_t> data) const;

    const Subject* subject_;
    std::array<Transfer, 128> transfers_{};
};

}  // namespace cgw::traffic
