// The verifier and reader of a configuration image. No heap, no exceptions; nothing of an image is used
// before all of it was found valid.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "image/layout.hpp"
#include "object/object_table.hpp"

namespace cgw::image {

// Why an image is refused. Codes are stable: firmware shows the number.
enum class Status : std::uint8_t {
    ok = 0,
    too_small = 1,
    too_large = 2,
    bad_magic = 3,
    unsupported_major = 4,
    bad_header_size = 5,  // or reserved header bytes in use
    size_mismatch = 6,    // total_size is not the number of bytes given
    bad_crc = 7,
    bad_directory = 8,  // entries out of order, overlapping, outside, misaligned, wrong record size
    section_missing = 9,
    bad_section = 10,       // a record holds a value no configuration can have
    bad_object_table = 11,  // unsorted, unknown type, value outside the value block
    bad_mapping = 12,       // a PDO maps an object that does not exist or has another length
    bad_label = 13,
};

std::string_view to_text(Status status);  // "the CRC-32 does not match", …

// What Image::open() says, and where: for codes 9 to 13 the section that is missing or wrong, else none (0).
struct Refusal {
    Status status = Status::ok;
    SectionId section{};
};
Refusal examine(std::span<const std::uint8_t> bytes);

// The raw records of one section, for tools that show bytes; `at` needs position < count().
struct Records {
    const std::uint8_t* data = nullptr;
    std::uint32_t size = 0;         // bytes
    std::uint16_t record_size = 1;  // at least the layout's; longer in a later minor

    std::size_t count() const { return size / record_size; }
    const std::uint8_t* at(std::size_t position) const { return data + position * record_size; }
};

struct Identity {
    std::uint32_t vendor = 0, product = 0, revision = 0, serial = 0;
};

struct Bus {
    std::uint8_t own_node = 0;
    std::uint8_t peer_node = 0;
    bool manual_timing = false;
    std::uint16_t bit_rate_kbit = 0;
    std::array<std::uint8_t, 6> registers{};
    std::uint32_t start_up_delay_ms = 0;
};

struct Governor {
    std::uint8_t own_node = 0;
    std::uint8_t gateway_node = 0;
    bool manual_timing = false;
    bool send_errors = false;
    bool send_status = false;
    std::uint16_t bit_rate_kbit = 0;
    std::array<std::uint8_t, 5> registers{};
    std::uint32_t start_up_delay_ms = 0;
    std::uint32_t main_cycle_us = 0;
};

struct Heartbeat {
    std::uint32_t producer_us = 0;  // 0: off
    std::uint32_t consumer_us = 0;
    std::uint8_t consumer_node = 0;
};

struct MappedObject {
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    std::uint8_t bits = 0;
    std::uint16_t parameter = 0;  // 0: none
};

struct Pdo {
    bool receive = false;
    std::uint8_t number = 0;
    bool active = false;
    bool cob_id_from_parameter = false;
    std::uint16_t cob_id = 0;
    std::uint8_t transmission_type = 0;
    std::uint32_t effective_us = 0;
    std::uint16_t asked_ms = 0;
    std::uint16_t cycles = 0;
    std::uint8_t word_count = 0;
    std::array<MappedObject, 4> mapping{};
};

struct SwitchFunction {
    std::uint16_t number = 0;
    std::uint8_t bit = 0;
    bool low_active = false;
};

struct Sensor {
    std::uint16_t number = 0;
    std::uint8_t channel = 0;
};

struct Signal {
    std::uint16_t number = 0;
    std::uint8_t width = 0;
    bool is_signed = false;
    std::int32_t internal_minimum = 0;
    std::int32_t internal_maximum = 0;
};

struct Label {
    std::uint16_t number = 0;
    std::string_view name;
    std::string_view unit;
    bool has_scaling = false;
    double external_minimum = 0;
    double external_maximum = 0;
};

// A view of a valid image; the bytes stay where they are and must outlive it. Only an image that open()
// filled may be asked anything.
class Image {
  public:
    // Validates everything. On anything but ok, `image` is left untouched.
    static Status open(std::span<const std::uint8_t> bytes, Image& image);

    std::uint16_t format_major() const;
    std::uint16_t format_minor() const;
    std::array<std::uint16_t, 3> tool_version() const;
    std::span<const std::uint8_t> configuration_id() const;  // 32 bytes
    std::span<const std::uint8_t> bytes() const { return bytes_; }
    std::uint32_t crc() const;

    Identity identity() const;
    Bus can1() const;
    Bus can2() const;
    Governor governor() const;
    Heartbeat heartbeat() const;

    Pdo pdo(std::size_t position) const;  // position < pdo::count: TPDO1..16, RPDO1..4

    std::size_t switch_count() const;
    SwitchFunction switch_function(std::size_t position) const;
    std::size_t sensor_count() const;
    Sensor sensor(std::size_t position) const;
    std::size_t signal_count() const;
    Signal signal(std::size_t position) const;
    bool find_signal(std::uint16_t number, Signal& signal) const;

    object::ObjectTable objects() const;
    std::span<const std::uint8_t> initial_values() const;  // the value block at start

    std::size_t label_count() const;
    Label label(std::size_t position) const;
    bool find_label(std::uint16_t number, Label& label) const;

    // The text whose SHA-256 is the configuration id (parameter/settings.hpp), for tools; "" where it is not
    // there. Nothing in it is verified but that it lies inside the image.
    std::string_view model() const;

    // Empty for an optional section that is not there.
    const Records& records(SectionId id) const { return sections_[static_cast<std::size_t>(id)]; }

  private:
    friend class Verifier;

    std::span<const std::uint8_t> bytes_;
    std::array<Records, section_ids> sections_{};  // by SectionId; [0] unused
};

}  // namespace cgw::image
