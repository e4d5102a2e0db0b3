#include "cli/cgw/image_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "facts/gateway.hpp"

namespace cgw::cli {
namespace {

constexpr std::size_t columns = 80;
using facts::object::unsigned16_dummy;

// Lines of at most `columns` characters.
class Page {
  public:
    void line(std::string_view text = "") {
        std::size_t bytes = 0;
        for (std::size_t shown = 0; bytes < text.size() && shown < columns; ++shown) {
            bytes += std::max<std::size_t>(base::utf8_sequence_length(text.substr(bytes)), 1);
        }
        text_ += text.substr(0, bytes);
        text_ += '\n';
    }

    void field(std::string_view name, std::string_view value) { line(fmt::format("{:<20}{}", name, value)); }

    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

std::string bit_rate(bool manual, std::uint16_t kbit) {
    return manual ? std::string("manual bit timing") : fmt::format("{} kbit/s", kbit);
}

template <std::size_t count>
std::string registers(const std::array<std::uint8_t, count>& values) {
    return fmt::format("{}", fmt::join(values, " "));
}

void show_identity(Page& page, const image::Image& image) {
    const image::Identity identity = image.identity();
    page.field("title", title_of(image));
    page.field("configuration id", base::short_id(image.configuration_id()));
    page.field("CRC-32", fmt::format("{:08x}", image.crc()));
    page.field("written by", "cgw " + tool_version_text(image));
    page.field("identity 1018h",
               fmt::format("vendor 0x{:08X}, product 0x{:08X},", identity.vendor, identity.product));
    page.field("", fmt::format("revision 0x{:08X}, serial 0x{:08X}", identity.revision, identity.serial));
}

void show_bus(Page& page, std::string_view name, const image::Bus& bus, std::string_view peer) {
    const std::string other =
        bus.peer_node == 0 ? fmt::format("no {}", peer) : fmt::format("{} node {}", peer, bus.peer_node);
    page.field(name, fmt::format("node {}, {}, {}", bus.own_node, other,
                                 bit_rate(bus.manual_timing, bus.bit_rate_kbit)));
    if (bus.manual_timing) {
        page.field("", "bit-timing registers " + registers(bus.registers));
    }
    if (bus.start_up_delay_ms != 0) {
        page.field("", fmt::format("start-up delay {} ms", bus.start_up_delay_ms));
    }
}

void show_governor(Page& page, const image::Governor& governor) {
    page.field("governor",
               fmt::format("node {}, gateway node {}, {}, main cycle {}", governor.own_node,
                           governor.gateway_node, bit_rate(governor.manual_timing, governor.bit_rate_kbit),
                           base::milliseconds_text(governor.main_cycle_us)));
    if (governor.manual_timing) {
        page.field("", "bit-timing registers " + registers(governor.registers));
    }
    page.field("", fmt::format("start-up delay {} ms", governor.start_up_delay_ms));
    page.field("", fmt::format("sends errors: {}, sends engine state: {}",
                               governor.send_errors ? "yes" : "no", governor.send_status ? "yes" : "no"));
}

void show_heartbeat(Page& page, const image::Heartbeat& heartbeat) {
    page.field("heartbeat producer", heartbeat.producer_us == 0
                                         ? std::string("off")
                                         : "every " + base::milliseconds_text(heartbeat.producer_us));
    page.field("heartbeat consumer", heartbeat.consumer_us == 0
                                         ? std::string("off")
                                         : fmt::format("node {} within {}", heartbeat.consumer_node,
                                                       base::milliseconds_text(heartbeat.consumer_us)));
}

std::string rhythm(const image::Pdo& pdo) {
    if (pdo.effective_us == 0) {
        return pdo.receive ? "not monitored" : "on change";
    }
    return fmt::format("{} {}", pdo.receive ? "within" : "every", base::milliseconds_text(pdo.effective_us));
}

// "2000 Speed", or the bare number of something without a label.
std::string numbered(const image::Image& image, std::uint16_t number) {
    const std::string name = name_of(image, number);
    return name.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, name);
}

std::string mapped_text(const image::Image& image, const image::MappedObject& mapped) {
    if (mapped.index == unsigned16_dummy) {
        return "dummy";
    }
    std::string object = base::object_text(mapped.index, mapped.sub_index);
    if (mapped.parameter == 0) {
        return object;
    }
    return fmt::format("{:<10}{}", object, numbered(image, mapped.parameter));
}

void show_pdos(Page& page, const image::Image& image) {
    page.line("active PDOs");
    std::size_t active = 0;
    for (std::size_t i = 0; i < image::pdo::count; ++i) {
        const image::Pdo pdo = image.pdo(i);
        if (!pdo.active) {
            continue;
        }
        ++active;
        page.line(fmt::format("  {:<7} {}  {} bytes, {}", pdo_name(pdo), base::identifier_text(pdo.cob_id),
                              2 * pdo.word_count, rhythm(pdo)));
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            page.line(fmt::format("    word {}  {}", word + 1, mapped_text(image, pdo.mapping[word])));
        }
    }
    if (active == 0) {
        page.line("  none");
    }
}

void show_inputs(Page& page, const image::Image& image) {
    for (std::size_t i = 0; i < image.switch_count(); ++i) {
        const image::SwitchFunction function = image.switch_function(i);
        page.field(i == 0 ? "switches" : "",
                   fmt::format("bit {:<2} {}{}", function.bit, numbered(image, function.number),
                               function.low_active ? ", low-active" : ""));
    }
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        const image::Sensor sensor = image.sensor(i);
        page.field(i == 0 ? "sensors" : "",
                   fmt::format("channel {:<2} {}", sensor.channel, numbered(image, sensor.number)));
    }
}

void show_labels(Page& page, const image::Image& image) {
    page.line("labels");
    for (std::size_t i = 0; i < image.label_count(); ++i) {
        const image::Label label = image.label(i);
        const std::string range = label.has_scaling
                                      ? fmt::format("  {} .. {}", base::to_text(label.external_minimum),
                                                    base::to_text(label.external_maximum))
                                      : std::string();
        page.line(fmt::format("  {:>5} {}{}{}{}", label.number, label.name, range,
                              label.unit.empty() ? "" : " ", label.unit));
    }
    if (image.label_count() == 0) {
        page.line("  none");
    }
}

}  // namespace

std::string pdo_name(const image::Pdo& pdo) {
    return base::pdo_name(!pdo.receive, pdo.number);
}

std::string tool_version_text(const image::Image& image) {
    return fmt::format("{}", fmt::join(image.tool_version(), "."));
}

std::string title_of(const image::Image& image) {
    return name_of(image, 0);
}

std::string name_of(const image::Image& image, std::uint16_t number) {
    image::Label label;
    return image.find_label(number, label) ? std::string(label.name) : std::string();
}

std::string image_summary(const std::string& path, const image::Image& image) {
    return fmt::format("{}: valid, format {}.{}, {} bytes, configuration id {}, CRC {:08x}", path,
                       image.format_major(), image.format_minor(), image.bytes().size(),
                       base::short_id(image.configuration_id()), image.crc());
}

std::string image_for_people(const std::string& path, const image::Image& image) {
    Page page;
    page.field("image", path);
    page.field("format", fmt::format("{}.{}, {} bytes", image.format_major(), image.format_minor(),
                                     image.bytes().size()));
    show_identity(page, image);
    page.line();
    show_bus(page, "CAN1 (HEINZMANN)", image.can1(), "governor");
    show_bus(page, "CAN2 (CANopen)", image.can2(), "partner");
    show_governor(page, image.governor());
    show_heartbeat(page, image.heartbeat());
    page.line();
    show_pdos(page, image);
    show_inputs(page, image);
    page.line();
    page.field("objects",
               fmt::format("{}, values {} bytes", image.objects().size(), image.initial_values().size()));
    show_labels(page, image);
    return page.take();
}

}  // namespace cgw::cli
