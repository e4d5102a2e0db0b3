// Both readers must say the same of every image, and what is accepted can be read, told and run.
#include <algorithm>

#include "base/utf8.hpp"
#include "canopen/protocol.hpp"
#include "canopen/sdo.hpp"
#include "device/gateway.hpp"
#include "fuzz/fuzz.hpp"
#include "image/area.hpp"
#include "image/c/cgw_image.h"
#include "image/c_reader.h"
#include "inspect/annotation.hpp"
#include "support/image_values.hpp"
#include "support/recording_port.hpp"

namespace cgw::fuzz {
namespace {

using image::Status;

void append(void* to, std::uint64_t value) {
    static_cast<test::Numbers*>(to)->push_back(value);
}

// Up to code 9 both say the same. Above it, C knows only values and texts that lie outside.
void demand_agreement(Input input, Status cpp, test::Numbers& c_values) {
    const auto c = static_cast<Status>(c_reader_dump(input.data(), input.size(), append, &c_values));
    if (cpp <= Status::section_missing) {
        demand(c == cpp, "both readers give the same code");
    } else {
        demand(c == Status::ok || c == Status::bad_object_table || c == Status::bad_label,
               "the C reader does not refuse for other reasons");
    }
}

// Of whatever area, both take the same bytes for the image.
void demand_agreement_about_areas(Input input) {
    demand(c_reader_in(input.data(), input.size()) == image::image_in(input).size(),
           "both readers see as much of an area as the image");
}

void demand_refusal_fits(Input input, Status status) {
    const image::Refusal refusal = image::examine(input);
    demand(refusal.status == status, "examine() and open() agree");
    const bool of_a_section = status >= Status::section_missing;
    demand((refusal.section != image::SectionId{}) == of_a_section,
           "a refusal names a section where there is one");
}

// Everything can be found by its number, in both readers.
void demand_lookups(const image::Image& image) {
    cgw_image c_image;
    cgw_image_open(&c_image, image.bytes().data(), image.bytes().size());
    for (std::size_t i = 0; i < image.objects().size(); ++i) {
        const object::ObjectEntry entry = image.objects().entry(i);
        const auto found = image.objects().find(entry.index, entry.sub_index);
        cgw_image_object of_c;
        demand(found.found == object::Found::yes && found.entry == entry, "an object is found");
        demand(cgw_image_find_object(&c_image, entry.index, entry.sub_index, &of_c) == 1 &&
                   of_c.offset == entry.offset,
               "an object is found in C");
    }
    for (std::size_t i = 0; i < image.signal_count(); ++i) {
        image::Signal signal;
        cgw_image_signal of_c;
        const std::uint16_t number = image.signal(i).number;
        demand(image.find_signal(number, signal) && signal.number == number, "a signal is found");
        demand(cgw_image_find_signal(&c_image, number, &of_c) == 1 && of_c.number == number,
               "a signal is found in C");
    }
    for (std::size_t i = 0; i < image.label_count(); ++i) {
        image::Label label;
        cgw_image_label of_c;
        const std::uint16_t number = image.label(i).number;
        demand(image.find_label(number, label) && label.number == number, "a label is found");
        demand(cgw_image_find_label(&c_image, number, &of_c) == 1 && of_c.number == number,
               "a label is found in C");
    }
}

void demand_told(Input input, Status status) {
    const inspect::Annotation annotation = inspect::annotate(input);
    demand(annotation.status == status, "annotate() and open() agree");
    std::size_t next = 0;
    bool marked = false;
    for (const inspect::Group& group : annotation.groups) {
        marked = marked || !group.wrong.empty();
        for (const inspect::Item& item : group.items) {
            demand(item.offset == next && item.size > 0, "every byte stands in exactly one item");
            next = item.offset + item.size;
            marked = marked || !item.wrong.empty();
        }
    }
    demand(next == input.size(), "every byte stands in an item");
    if (annotation.model_fits) {
        demand(marked == (status != Status::ok), "what is refused is marked, and nothing else");
    }
    if (!sometimes(input, 16)) {
        return;
    }
    const std::string text = inspect::annotation_text(annotation, input, "image.bin");
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        demand(end != std::string::npos, "the last line is whole");
        const std::string line = text.substr(at, end - at);
        demand(base::width_of(line) <= 80 && !base::has_control(line), "a line fits a terminal");
        at = end + 1;
    }
    inspect::annotation_json(annotation, input, "image.bin");
}

struct QuietLink final : device::GovernorLink {
    void status_changed(const device::GatewayStatus&) override {}
    void process_data(std::uint8_t, const device::PdoWords&) override {}
};

// A gateway takes the image, goes into Operational, sends, and answers for every object.
void demand_runs(const image::Image& image) {
    test::RecordingPort port;
    QuietLink link;
    device::Gateway gateway(port, link);
    canopen::Time now = 0;
    if (gateway.open(image, now) != device::OpenStatus::ok) {
        return;
    }
    gateway.command(device::GovernorCommand::init, now);
    gateway.command(device::GovernorCommand::pre_operational, now);
    const std::uint8_t node = image.can2().own_node;
    gateway.receive(test::make_frame(0, {1, node}), now);
    for (int cycle = 0; cycle < 20; ++cycle) {
        now += 100'000;
        gateway.main_cycle(device::GovernorData{}, now);
        gateway.poll(now);
        for (std::size_t row = 0; row < image::pdo::count; ++row) {
            const image::Pdo pdo = image.pdo(row);
            if (pdo.active && pdo.receive) {
                gateway.receive(test::make_frame(pdo.cob_id, {1, 2, 3, 4, 5, 6, 7, 8}), now);
            }
        }
    }
    for (std::size_t i = 0; i < image.objects().size(); ++i) {
        const object::ObjectEntry entry = image.objects().entry(i);
        port.take();
        gateway.receive(canopen::sdo::make_frame(0x600U + node, 0x40, {entry.index, entry.sub_index}, 0),
                        now);
        demand(port.sent.size() == 1 && port.sent[0].id == 0x580U + node, "every object answers");
    }
}

}  // namespace

void image(Input input) {
    image::Image image;
    const Status status = image::Image::open(input, image);
    test::Numbers c_values;
    demand_agreement(input, status, c_values);
    demand_agreement_about_areas(input);
    demand_refusal_fits(input, status);
    if (sometimes(input, 2)) {
        demand_told(input, status);
    }
    if (status == Status::ok) {
        demand(c_values == test::values_of(image), "both readers read the same values");
        if (sometimes(input, 7)) {
            demand_lookups(image);
        }
        if (sometimes(input, 3)) {
            demand_runs(image);
        }
    }
}

}  // namespace cgw::fuzz
