#include "eds/writer.hpp"
#include "eds/document.hpp"

#include <gtest/gtest.h>

namespace cgw::eds {
namespace {

using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;
using object::Access;
using object::DataType;

Variable variable(DataType type, std::uint32_t value, Access access = Access::ro) {
    Variable result;
    result.name = "Some Value";
    result.type = type;
    result.access = access;
    result.default_value.number = value;
    return result;
}

Dictionary with_object(std::uint16_t index, const Variable& value) {
    Dictionary dictionary;
    Object& object = dictionary.objects.emplace_back();
    object.index = index;
    object.name = "Some Object";
    object.variables = {value};
    return dictionary;
}

std::string entry(const Document& document, std::string_view section, std::string_view key) {
    return std::string(document.value(section, key).value_or("(missing)"));
}

std::string default_text(const Variable& value) {
    return entry(Document(write(with_object(0x2000, value))), "2000", "DefaultValue");
}

}  // namespace

TEST(EdsWriter, writes_numbers_in_the_width_of_their_type) {
    EXPECT_EQ(default_text(variable(DataType::boolean, 1)), "0x01");
    EXPECT_EQ(default_text(variable(DataType::unsigned8, 4)), "0x04");
    EXPECT_EQ(default_text(variable(DataType::unsigned16, 0xAB)), "0x00AB");
    EXPECT_EQ(default_text(variable(DataType::unsigned32, 0x80000003)), "0x80000003");
    EXPECT_EQ(default_text(variable(DataType::integer8, static_cast<std::uint32_t>(-1))), "-1");
    EXPECT_EQ(default_text(variable(DataType::integer16, static_cast<std::uint32_t>(-2))), "-2");
    EXPECT_EQ(default_text(variable(DataType::integer32, static_cast<std::uint32_t>(-2))), "-2");
}

TEST(EdsWriter, puts_the_node_number_first) {
    Variable value = variable(DataType::unsigned32, 0x80000180);
    value.default_value.node_id_relative = true;
    EXPECT_EQ(default_text(value), "$NODEID+0x80000180");
}

TEST(EdsWriter, writes_access_types_in_lower_case) {
    const std::vector<std::pair<Access, std::string>> expected{
        {Access::ro, "ro"},   {Access::wo, "wo"},   {Access::rw, "rw"},
        {Access::rwr, "rwr"}, {Access::rww, "rww"}, {Access::constant, "const"}};
    for (const auto& [access, text] : expected) {
        const Dictionary dictionary = with_object(0x2000, variable(DataType::unsigned8, 0, access));
        EXPECT_EQ(entry(Document(write(dictionary)), "2000", "AccessType"), text);
    }
}

TEST(EdsWriter, writes_limits_only_where_the_dictionary_has_them) {
    Variable value = variable(DataType::unsigned8, 6);
    EXPECT_EQ(entry(Document(write(with_object(0x2000, value))), "2000", "LowLimit"), "(missing)");
    value.low_limit = dictionary::Value{};
    value.high_limit = dictionary::Value{52, false};
    const Document document(write(with_object(0x2000, value)));
    EXPECT_EQ(entry(document, "2000", "LowLimit"), "0x00");
    EXPECT_EQ(entry(document, "2000", "HighLimit"), "0x34");
}

TEST(EdsWriter, lists_objects_by_range) {
    Dictionary dictionary;
    for (const std::uint16_t index :
         std::vector<std::uint16_t>{0x1000, 0x1001, 0x1018, 0x1FFF, 0x2000, 0x5FFF, 0x6000, 0x9FFF}) {
        Object& object = dictionary.objects.emplace_back();
        object.index = index;
        object.variables = {variable(DataType::unsigned8, 0)};
    }
    const Document document(write(dictionary));
    EXPECT_EQ(entry(document, "MandatoryObjects", "SupportedObjects"), "3");
    EXPECT_EQ(entry(document, "MandatoryObjects", "3"), "0x1018");
    EXPECT_EQ(entry(document, "OptionalObjects", "SupportedObjects"), "3");
    EXPECT_EQ(entry(document, "OptionalObjects", "1"), "0x1FFF");
    EXPECT_EQ(entry(document, "OptionalObjects", "3"), "0x9FFF");
    EXPECT_EQ(entry(document, "ManufacturerObjects", "SupportedObjects"), "2");
    EXPECT_EQ(entry(document, "ManufacturerObjects", "2"), "0x5FFF");
}

TEST(EdsWriter, names_sub_objects_in_hexadecimal_without_leading_zero) {
    Dictionary dictionary = with_object(0x2A0B, variable(DataType::unsigned8, 0x10));
    Object& object = dictionary.objects.front();
    object.code = object::ObjectCode::array;
    object.variables.push_back(variable(DataType::unsigned16, 0));
    object.variables.back().sub_index = 0x10;
    const Document document(write(dictionary));
    EXPECT_EQ(entry(document, "2A0B", "SubNumber"), "2");
    EXPECT_EQ(entry(document, "2A0B", "ObjectType"), "0x8");
    EXPECT_EQ(entry(document, "2A0B", "DataType"), "(missing)");
    EXPECT_EQ(entry(document, "2A0Bsub10", "DataType"), "0x0006");
    EXPECT_EQ(entry(document, "2A0Bsub0", "ParameterName"), "Some Value");
}

TEST(EdsWriter, brings_texts_to_one_ascii_line) {
    Dictionary dictionary;
    dictionary.file.description = "  Größe; fünf\r\n[1000] ";
    EXPECT_EQ(entry(Document(write(dictionary)), "FileInfo", "Description"), "Groesse, fuenf  [1000]");
    dictionary.file.description = "   ";
    EXPECT_EQ(entry(Document(write(dictionary)), "FileInfo", "Description"), "");
}

TEST(EdsWriter, cuts_texts_at_their_limits) {
    const std::string endless(400, 'x');
    Dictionary dictionary = with_object(0x2000, variable(DataType::unsigned8, 0));
    dictionary.file.description = dictionary.file.created_by = dictionary.file.modified_by = endless;
    dictionary.objects.front().name = endless;
    dictionary.comments = {endless};
    const Document document(write(dictionary));
    EXPECT_EQ(entry(document, "FileInfo", "Description").size(), 243U);
    EXPECT_EQ(entry(document, "FileInfo", "CreatedBy").size(), 245U);
    EXPECT_EQ(entry(document, "FileInfo", "ModifiedBy").size(), 244U);
    EXPECT_EQ(entry(document, "2000", "ParameterName").size(), 241U);
    EXPECT_EQ(entry(document, "Comments", "Line1").size(), 249U);
    EXPECT_EQ(entry(document, "Comments", "Lines"), "1");
}

TEST(EdsWriter, states_supported_dummies_and_bit_rates) {
    Dictionary dictionary;
    dictionary.supported_dummies = {6};
    dictionary.device.bit_rates_kbit = {125, 1000};
    const Document document(write(dictionary));
    EXPECT_EQ(entry(document, "DummyUsage", "Dummy0005"), "0");
    EXPECT_EQ(entry(document, "DummyUsage", "Dummy0006"), "1");
    EXPECT_EQ(entry(document, "DummyUsage", "Dummy0007"), "0");
    EXPECT_EQ(entry(document, "DeviceInfo", "BaudRate_125"), "1");
    EXPECT_EQ(entry(document, "DeviceInfo", "BaudRate_250"), "0");
    EXPECT_EQ(entry(document, "DeviceInfo", "BaudRate_1000"), "1");
}

TEST(EdsWriter, writes_the_keys_of_a_variable_in_the_standards_order) {
    const Dictionary dictionary = with_object(0x1000, variable(DataType::unsigned32, 0));
    EXPECT_NE(write(dictionary)
                  .find("[1000]\r\n"
                        "ParameterName=Some Object\r\n"
                        "ObjectType=0x7\r\n"
                        "DataType=0x0007\r\n"
                        "AccessType=ro\r\n"
                        "DefaultValue=0x00000000\r\n"
                        "PDOMapping=0\r\n"),
              std::string::npos);
}

}  // namespace cgw::eds
