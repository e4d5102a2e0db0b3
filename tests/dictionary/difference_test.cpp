#include "dictionary/difference.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

namespace cgw::dictionary {
namespace {

Variable variable(std::uint8_t sub_index, std::string name, object::DataType type, Value value) {
    Variable made;
    made.sub_index = sub_index;
    made.name = std::move(name);
    made.type = type;
    made.default_value = std::move(value);
    return made;
}

Dictionary device() {
    Dictionary dictionary;
    dictionary.device.vendor_name = "Vendor";
    dictionary.device.bit_rates_kbit = {125, 250};
    dictionary.supported_dummies = {5};
    const auto add = [&](std::uint16_t index, std::string name, object::ObjectCode code) -> Object& {
        Object& object = dictionary.objects.emplace_back();
        object.index = index;
        object.name = std::move(name);
        object.code = code;
        return object;
    };
    add(0x1000, "Device Type", object::ObjectCode::var).variables = {
        variable(0, "Device Type", object::DataType::unsigned32, {})};
    add(0x1800, "TPDO1", object::ObjectCode::record).variables = {
        variable(1, "COB-ID", object::DataType::unsigned32, {0x180, true})};
    add(0x1A00, "TPDO1 Mapping", object::ObjectCode::record).variables = {
        variable(0, "Number", object::DataType::unsigned8, {1}),
        variable(1, "Mapped Object 1", object::DataType::unsigned32, {0x20000010})};
    return dictionary;
}

// "object aspect: a -> b", a line each.
std::string told(const Differences& differences) {
    std::string text;
    for (const Difference& each : differences.all) {
        const std::string object = each.index ? fmt::format("{:04X}", *each.index) : "device";
        const std::string sub = each.sub_index ? fmt::format(":{}", *each.sub_index) : "";
        text += fmt::format("{}{} {}: {} -> {}\n", object, sub, each.aspect, each.a, each.b);
    }
    return text;
}

// What is told of the device and a changed copy.
std::string told_after(const std::function<void(Dictionary&)>& change) {
    const Dictionary a = device();
    Dictionary b = device();
    change(b);
    return told(differences({a}, {b}));
}

}  // namespace

TEST(Differences, none_between_equal_dictionaries) {
    EXPECT_EQ(told_after([](Dictionary&) {}), "");
}

TEST(Differences, what_only_the_file_says_of_itself_does_not_count) {
    EXPECT_EQ(told_after([](Dictionary& b) {
                  b.file.file_name = "other.eds";
                  b.file.creation_date = "01-01-2020";
                  b.comments = {"a remark"};
                  b.device.bit_rates_kbit = {250, 125};
              }),
              "");
}

TEST(Differences, of_the_device) {
    EXPECT_EQ(told_after([](Dictionary& b) {
                  b.device.vendor_name = "Other";
                  b.device.bit_rates_kbit = {125};
                  b.supported_dummies.clear();
              }),
              "device vendor-name: Vendor -> Other\n"
              "device bit-rates: 125 250 -> 125\n"
              "device dummies: UNSIGNED8 -> none\n");
}

TEST(Differences, of_objects_and_sub_objects_that_one_side_lacks) {
    EXPECT_EQ(told_after([](Dictionary& b) {
                  b.objects.erase(b.objects.begin());
                  b.objects[1].variables.pop_back();
                  b.objects.emplace_back().index = 0x2000;
              }),
              "1000 object: VAR -> missing\n"
              "1A00:1 sub-object: UNSIGNED32 -> missing\n"
              "2000 object: missing -> VAR\n");
}

TEST(Differences, of_every_aspect_of_a_variable) {
    EXPECT_EQ(told_after([](Dictionary& b) {
                  Variable& entry = b.objects[2].variables[1];
                  entry.name = "Another";
                  entry.access = object::Access::rw;
                  entry.pdo_mapping = true;
                  entry.default_value.number = 0x20010120;
                  entry.low_limit = Value{1};
                  entry.flags = 1;
              }),
              "1A00:1 name: Mapped Object 1 -> Another\n"
              "1A00:1 access: ro -> rw\n"
              "1A00:1 pdo-mapping: no -> yes\n"
              "1A00:1 default: 2000h:0, 16 bits -> 2001h:1, 32 bits\n"
              "1A00:1 low-limit: not stated -> 0x00000001\n"
              "1A00:1 flags: 0x0 -> 0x1\n");
    EXPECT_EQ(told_after([](Dictionary& b) {
                  b.objects[2].code = object::ObjectCode::array;
                  b.objects[2].variables[0].type = object::DataType::unsigned16;
                  b.objects[0].variables[0].no_default = true;
              }),
              "1000 default: 0x00000000 -> not stated\n"
              "1A00 object-type: RECORD -> ARRAY\n"
              "1A00:0 data-type: UNSIGNED8 -> UNSIGNED16\n");
}

TEST(Differences, a_formula_equals_the_number_of_the_node) {
    const Dictionary a = device();
    Dictionary b = device();
    b.objects[1].variables[0].default_value = {0x185, false};
    EXPECT_EQ(told(differences({a}, {b})), "1800:1 default: $NODEID+0x180 -> 0x00000185\n");
    EXPECT_EQ(told(differences({a}, {b}, {.node_id = 5})), "");
    EXPECT_EQ(told(differences({a}, {b, nullptr, 5})), "");
    EXPECT_EQ(told(differences({a, nullptr, 5}, {b})), "");
    EXPECT_EQ(told(differences({a}, {b}, {.node_id = 6})), "1800:1 default: 0x00000186 -> 0x00000185\n");
}

TEST(Differences, of_two_configuration_files) {
    const Dictionary a = device();
    Dictionary b = device();
    Dictionary c = device();
    b.objects[0].variables[0].parameter_value = Value{1};
    b.objects[1].variables[0].parameter_value = Value{0x185};
    c.objects[0].variables[0].parameter_value = Value{2};
    Commissioning node_b;
    node_b.node_id = 5;
    Commissioning node_c = node_b;
    node_c.bit_rate_kbit = 125;
    EXPECT_EQ(told(differences({b, &node_b, 5}, {c, &node_c, 5})),
              "device bit-rate: not stated -> 125\n"
              "1000 value: 0x00000001 -> 0x00000002\n");
    EXPECT_EQ(told(differences({a}, {b, &node_b, 5})), "1000 value: 0x00000000 -> 0x00000001\n");
}

TEST(Differences, of_connected_modules) {
    const Dictionary device_of_both = device();
    Commissioning a;
    a.connected_modules = {1, 2};
    Commissioning b;
    b.connected_modules = {2, 1};
    const auto between = [&](const Commissioning* of_a, const Commissioning* of_b) {
        return differences({device_of_both, of_a}, {device_of_both, of_b});
    };
    EXPECT_EQ(told(between(&a, &b)), "device connected-modules: 1 2 -> 2 1\n");
    b.connected_modules.clear();
    EXPECT_EQ(told(between(&a, &b)), "device connected-modules: 1 2 -> none\n");
    EXPECT_EQ(between(&a, nullptr).not_compared, std::vector<std::string_view>{"connected modules"});
    EXPECT_TRUE(between(&b, nullptr).not_compared.empty());
}

TEST(Differences, a_bare_side_is_compared_by_what_it_says) {
    const Dictionary a = device();
    Dictionary b = device();
    b.device = {};
    b.supported_dummies.clear();
    for (Object& object : b.objects) {
        object.name.clear();
        for (Variable& each : object.variables) {
            each.name.clear();
        }
    }
    b.objects[0].variables[0].default_value.number = 7;
    const Differences found = differences({a}, {.dictionary = b, .bare = true});
    EXPECT_EQ(told(found), "1000 default: 0x00000000 -> 0x00000007\n");
    EXPECT_FALSE(found.not_compared.empty());
    EXPECT_EQ(found.all[0].name, "Device Type");
}

TEST(Differences, of_modules) {
    EXPECT_EQ(told_after([](Dictionary& b) { b.modules.emplace_back().product_name = "DI 8"; }),
              "device module: missing -> DI 8\n");
}

TEST(DifferenceFormats, text_fits_eighty_columns) {
    const Dictionary a = device();
    Dictionary b = device();
    b.device.vendor_name = std::string(70, 'v');
    b.objects[2].variables[1].default_value.number = 0;
    const Differences found = differences({a}, {b});
    EXPECT_EQ(difference_formats()[0].render(found, {"a.eds", "EDS"}, {"b.dcf", "DCF"}),
              "A: a.eds (EDS)\n"
              "B: b.dcf (DCF)\n"
              "\n"
              "Device\n"
              "  vendor name\n"
              "      Vendor\n"
              "   -> " +
                  std::string(70, 'v') +
                  "\n"
                  "\n"
                  "1A00h:1 Mapped Object 1\n"
                  "  default value                2000h:0, 16 bits -> nothing\n"
                  "\n"
                  "2 differences.\n");
}

TEST(DifferenceFormats, nothing_steers_the_terminal) {
    const Dictionary a = device();
    Dictionary b = device();
    b.device.vendor_name = "x\x1b[2J";
    for (const DifferenceFormat& format : difference_formats()) {
        const std::string text = format.render(differences({a}, {b}), {"a\x1b", "EDS"}, {"b", "EDS"});
        EXPECT_EQ(text.find('\x1b'), std::string::npos) << format.name;
    }
}

TEST(Differences, of_denotations_and_files_count_between_two_configurations_only) {
    const Commissioning node;
    const Dictionary a = device();
    Dictionary b = device();
    b.objects[0].variables[0].upload_file = "up.bin";
    b.objects[0].variables[0].download_file = "down.bin";
    b.objects[1].denotation = "Speed";
    b.objects[1].variables[0].denotation = "rpm";
    EXPECT_EQ(told(differences({a, &node}, {b, &node})),
              "1000 upload-file:  -> up.bin\n1000 download-file:  -> down.bin\n1800 denotation:  -> Speed\n"
              "1800:1 denotation:  -> rpm\n");
    EXPECT_TRUE(differences({a}, {b, &node}).same());
}

// A name in Latin-1 is the same as that name in UTF-8, and can be read.
TEST(Differences, of_names_are_those_that_can_be_seen) {
    Dictionary a;
    Object& object = a.objects.emplace_back();
    object.index = 0x2000;
    object.variables.emplace_back().name =
        "5 \xB0"
        "C";
    Dictionary b = a;
    b.objects[0].variables[0].name =
        "5 \xC2\xB0"
        "C";
    EXPECT_TRUE(differences({a}, {b}).same());
    b.objects[0].variables[0].name = "5 K";
    EXPECT_EQ(told(differences({a}, {b})),
              "2000 name: 5 \xC2\xB0"
              "C -> 5 K\n");
}

// An object with one value may have links as well.
TEST(Differences, tell_links_of_objects_without_sub_objects) {
    Dictionary a;
    Object& object = a.objects.emplace_back();
    object.index = 0x6064;
    object.variables.emplace_back();
    Dictionary b = a;
    b.objects[0].object_links = {0x606C};
    const Differences found = differences({a}, {b});
    ASSERT_EQ(found.all.size(), 1U);
    EXPECT_EQ(found.all[0].aspect, "links");
    EXPECT_EQ(found.all[0].b, "606Ch");
}

}  // namespace cgw::dictionary
