// Sound images, byte by byte.
#include <gtest/gtest.h>

#include <sstream>

#include "base/utf8.hpp"
#include "inspect/annotation.hpp"
#include "inspect/sample_images.hpp"
#include "support/golden.hpp"

namespace cgw::inspect {
namespace {

const Item* find(const Annotation& annotation, std::string_view title, std::string_view name) {
    for (const Group& group : annotation.groups) {
        for (const Item& item : group.items) {
            if (group.title == title && item.name == name) {
                return &item;
            }
        }
    }
    return nullptr;
}

TEST(Annotate, tells_every_byte_of_real_images_exactly_once_and_in_order) {
    for (const base::Bytes& image : test::sample_images()) {
        const Annotation annotation = annotate(image);
        EXPECT_EQ(annotation.status, image::Status::ok);
        std::size_t next = 0;
        for (const Group& group : annotation.groups) {
            EXPECT_EQ(group.wrong, "") << group.title;
            for (const Item& item : group.items) {
                EXPECT_EQ(item.offset, next) << group.title << " " << item.name;
                EXPECT_GT(item.size, 0U) << group.title << " " << item.name;
                EXPECT_EQ(item.wrong, "") << group.title << " " << item.name;
                EXPECT_NE(item.name, "more") << group.title;
                EXPECT_NE(item.name, "unclaimed") << group.title;
                next = item.offset + item.size;
            }
        }
        EXPECT_EQ(next, image.size());
    }
}

TEST(Annotate, tells_what_values_mean) {
    const Annotation annotation = annotate(test::image_by_hand());
    const struct {
        const char* title;
        const char* name;
        const char* value;
        const char* meaning;
    } expected[] = {
        {"header", "magic", "\"CGWI\"", "the letters CGWI"},
        {"buses 2 of 2: CAN2", "own_node", "5", "the gateway's node (427)"},
        {"buses 2 of 2: CAN2", "registers[1]", "1", "jump_width (421)"},
        {"governor", "main_cycle_us", "15625", "15.625 ms"},
        {"pdos 4 of 20: TPDO4", "direction", "0", "transmit"},
        {"pdos 5 of 20: TPDO5", "cob_id", "282h", "identifier"},
        {"pdos 4 of 20: TPDO4", "mapping[1]", "0x20020110", "2002h:1, 16 bits"},
        {"pdos 4 of 20: TPDO4", "parameters[0]", "2000", "Speed"},
        {"pdos 19 of 20: RPDO3", "mapping[0]", "0x00060010", "dummy, 16 bits"},
        {"pdos 20 of 20: RPDO4", "mapping[0]", "0x00000000", "unused"},
        {"objects 1 of 37: 1000h:0", "type", "7", "UNSIGNED32"},
        {"object_values", "1018h:3", "12", "0x0000000C"},
        {"switches 1 of 2: 811 FunctIdleSpeed", "number", "811", "FunctIdleSpeed"},
        {"labels 1 of 8: title", "number", "0", "Genset 2, starboard – Größe"},
    };
    for (const auto& row : expected) {
        const Item* item = find(annotation, row.title, row.name);
        ASSERT_NE(item, nullptr) << row.title << " " << row.name;
        EXPECT_EQ(item->value, row.value) << row.title << " " << row.name;
        EXPECT_EQ(item->meaning, row.meaning) << row.title << " " << row.name;
    }
}

TEST(Annotate, prints_at_most_80_columns) {
    const base::Bytes image =
        test::image_by_hand(true, std::string(60, 'x') + " \xC3\xBC " + std::string(100, 'y'));
    std::istringstream lines(annotation_text(annotate(image), image, "plant.bin"));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(base::width_of(line), 80U) << line;
        EXPECT_FALSE(line.ends_with(' ')) << line;
    }
}

TEST(Annotate, marks_a_model_that_has_another_id) {
    const Annotation annotation = annotate(test::SamplePlant().image());
    EXPECT_EQ(annotation.status, image::Status::ok);
    EXPECT_FALSE(annotation.model_fits);
    EXPECT_TRUE(annotate(test::image_by_hand()).model_fits);
    const Group& model = annotation.groups[annotation.groups.size() - 2];
    EXPECT_EQ(model.section, "model");
    EXPECT_EQ(model.wrong, "its SHA-256 is not the configuration id");
}

TEST(Annotate, prints_text_and_json_as_before) {
    const base::Bytes image = test::image_by_hand();
    test::expect_golden("image/annotate.txt", annotation_text(annotate(image), image, "plant.bin"));
    test::expect_golden("image/annotate.json", annotation_json(annotate(image), image, "plant.bin"));
}

}  // namespace
}  // namespace cgw::inspect
