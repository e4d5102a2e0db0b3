// The table of fields against itself, and its ranges against the verifier.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "inspect/fields.hpp"
#include "inspect/sample_images.hpp"
#include "support/image_bytes.hpp"

namespace cgw::inspect {
namespace {

TEST(InspectFields, leave_no_byte_of_a_record_untold) {
    for (const Record& record : all_records()) {
        std::size_t next = 0;
        for (const Field& field : record.fields) {
            EXPECT_EQ(field.offset, next) << record.name << " " << field.name;
            next = field.offset + field.size();
        }
        EXPECT_EQ(record.fields.empty() ? 1 : next, record.size) << record.name;
    }
}

TEST(InspectFields, have_names_that_differ_within_a_record) {
    for (const Record& record : all_records()) {
        std::set<std::string_view> names;
        for (const Field& field : record.fields) {
            EXPECT_TRUE(names.insert(field.name).second) << record.name << " " << field.name;
        }
    }
}

TEST(InspectFields, say_something_about_each) {
    for (const Record& record : all_records()) {
        for (const Field& field : record.fields) {
            const bool named = field.name == "sub_index" || !full_text(field).empty();
            EXPECT_TRUE(named) << record.name << " " << field.name;
            const bool elements_fit = field.elements.empty() || field.elements.size() == field.count;
            EXPECT_TRUE(elements_fit) << record.name << " " << field.name;
        }
    }
}

TEST(InspectFields, know_every_section_that_the_layout_has) {
    for (std::uint16_t id = 1; id < image::section_ids; ++id) {
        ASSERT_NE(find_record(id), nullptr) << id;
        EXPECT_EQ(static_cast<std::uint16_t>(find_record(id)->section), id);
    }
    EXPECT_EQ(find_record(0), nullptr);
    EXPECT_EQ(find_record(image::section_ids), nullptr);
}

// A value that the table says no image has, put into the first record.
std::vector<std::uint32_t> values_outside(const Field& field) {
    const std::uint32_t largest = 0xFFFF'FFFFU >> (8 * (4 - std::min<std::size_t>(size_of(field.type), 4)));
    std::vector<std::uint32_t> values;
    if (field.shown == Shown::reserved) {
        return {1, largest};
    }
    if (field.range && field.range->minimum > 0) {
        values.push_back(field.range->minimum - 1);
    }
    if (field.range && field.range->maximum < largest) {
        values.insert(values.end(), {field.range->maximum + 1, largest});
    }
    if (!field.bits.empty()) {
        return {0x06, 0x0F, 0x40, 0x80};
    }
    for (const NamedValue& value : field.values) {
        const bool next_is_named = &value != &field.values.back() && (&value)[1].value == value.value + 1;
        if (!next_is_named) {
            values.push_back(value.value + 1);
        }
    }
    return values;
}

TEST(InspectFields, have_the_ranges_that_the_verifier_keeps) {
    const base::Bytes image = test::image_of_sample("genset.toml");
    ASSERT_EQ(test::open(image), image::Status::ok);
    std::size_t tried = 0;
    for (const Record& record : all_records()) {
        if (!record.is_section() || record.fields.empty()) {
            continue;
        }
        ASSERT_GT(test::size_of(image, record.section), 0U) << record.name;
        for (const Field& field : record.fields) {
            for (const std::uint32_t value : values_outside(field)) {
                const std::size_t at = test::offset_of(image, record.section) + field.offset;
                const base::Bytes changed = test::changed(image, at, size_of(field.type), value);
                EXPECT_NE(test::open(changed), image::Status::ok)
                    << record.name << " " << field.name << " " << value;
                ++tried;
            }
        }
    }
    EXPECT_GT(tried, 60U);
}

}  // namespace
}  // namespace cgw::inspect
