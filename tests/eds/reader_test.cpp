// The reader: what it makes of each kind of section, what it tells, and where.
#include "eds/reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>

#include "dictionary/node.hpp"
#include "eds/random_text.hpp"
#include "eds/writer.hpp"
#include "profile/gateway.hpp"
#include "support/golden.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::eds {
namespace {

using object::Access;
using object::DataType;
using object::ObjectCode;

struct Result {
    explicit Result(std::string text) : document(std::move(text)), sheet(read(document, "a.eds", findings)) {
        findings.sort();
    }

    // "line:column name" of each finding.
    std::string told() const {
        std::string text;
        for (const diagnostic::Diagnostic& finding : findings.all()) {
            text += fmt::format("{}:{} {}\n", finding.where.range.start.line,
                                finding.where.range.start.column, finding.rule->name);
        }
        return text;
    }
    const dictionary::Variable& variable(std::uint16_t index, std::uint8_t sub = 0) const {
        static const dictionary::Variable none;
        const dictionary::Variable* const found = sheet.dictionary.find(index, sub);
        EXPECT_NE(found, nullptr) << fmt::format("{:04X}:{}", index, sub);
        return found != nullptr ? *found : none;
    }

    diagnostic::Findings findings;
    Document document;
    Sheet sheet;
};

std::string var(std::string_view data_type, std::string_view rest) {
    return fmt::format("[2000]\nParameterName=Value\nObjectType=7\nDataType={}\nAccessType=rw\n{}\n",
                       data_type, rest);
}

// What reads back of a file that cgw wrote: `run_time` is not in any file.
dictionary::Dictionary as_in_a_file(dictionary::Dictionary dictionary) {
    for (dictionary::Object& object : dictionary.objects) {
        for (dictionary::Variable& variable : object.variables) {
            variable.run_time = false;
            if (object.code == ObjectCode::var) {
                variable.name = object.name;
            }
        }
    }
    return dictionary;
}

void expect_round_trip(const dictionary::Dictionary& dictionary) {
    const Result sheet(write(dictionary));
    EXPECT_EQ(sheet.told(), "");
    EXPECT_TRUE(sheet.sheet.dictionary == as_in_a_file(dictionary)) << write(sheet.sheet.dictionary);
    EXPECT_FALSE(sheet.sheet.commissioning);

    dictionary::Commissioning node;
    node.last_eds = "a.eds";
    node.node_id = 5;
    node.node_name = "Genset";
    node.bit_rate_kbit = 250;
    node.serial_number = 0x1234;
    const dictionary::Dictionary resolved = as_in_a_file(dictionary::of_node(dictionary, node.node_id));
    const Result file(write(resolved, node));
    EXPECT_EQ(file.told(), "");
    EXPECT_EQ(file.sheet.commissioning, node);
    EXPECT_TRUE(file.sheet.dictionary == resolved) << write(file.sheet.dictionary, node);
}

}  // namespace

TEST(EdsReader, reads_back_what_cgw_writes) {
    profile::GatewayDocument document;
    document.tool_version = "0.1.0";
    expect_round_trip(profile::gateway_dictionary(test::manual_configuration(), document));
    expect_round_trip(profile::gateway_dictionary(test::empty_configuration(), document));
    expect_round_trip(profile::generic_gateway_dictionary(document));
}

TEST(EdsReader, writes_the_golden_files_again_from_what_it_reads) {
    std::size_t files = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(CGW_TEST_DATA "/golden")) {
        const std::string extension = file.path().extension().string();
        if (extension == ".eds" || extension == ".dcf") {
            ++files;
            const Result result(test::read_text(file.path()));
            EXPECT_EQ(result.told(), "") << file.path();
            EXPECT_EQ(result.sheet.commissioning.has_value(), extension == ".dcf");
            const auto& node = result.sheet.commissioning;
            const std::string again =
                node ? write(result.sheet.dictionary, *node) : write(result.sheet.dictionary);
            EXPECT_EQ(again, result.document.text()) << file.path();
        }
    }
    EXPECT_GE(files, 3U);
}

TEST(EdsReader, accepts_every_printed_form_with_a_finding) {
    const Result result(test::read_text(CGW_TEST_DATA "/eds/printed.eds"));
    std::vector<std::string_view> names;
    for (const diagnostic::Diagnostic& finding : result.findings.all()) {
        names.push_back(finding.rule->name);
    }
    EXPECT_EQ(std::count(names.begin(), names.end(), "eds-spelling"), 2);     // SimpleBoot-up…
    EXPECT_EQ(std::count(names.begin(), names.end(), "eds-number-form"), 1);  // 0x0x00001B59
    EXPECT_EQ(names.size(), 3U) << result.told();
    EXPECT_EQ(result.variable(0x1018, 2).default_value.number, 0x1B59U);
    EXPECT_TRUE(result.sheet.dictionary.device.simple_boot_up_slave);
    EXPECT_EQ(result.sheet.dictionary.file.file_name, "CANopenGateway.ed5");
}

TEST(EdsReader, knows_where_each_object_stands) {
    const Result result(var("7", "DefaultValue = $NODEID+0x180 ") + "[1018]\nParameterName=Identity\n" +
                        "ObjectType=9\n[1018sub1]\nDataType=7\nAccessType=ro\n");
    const auto object = result.sheet.sections.find_object(0x2000);
    ASSERT_TRUE(object);
    const auto line = result.document.find(result.document.sections()[*object], "defaultvalue");
    ASSERT_TRUE(line);
    EXPECT_EQ(result.document.value(*line), "$NODEID+0x180");
    EXPECT_EQ(result.document.range(result.document.value_span(*line)),
              (diagnostic::Range{{6, 16}, {6, 29}}));
    EXPECT_EQ(result.sheet.sections.find_object(0x1018), 1U);
    EXPECT_EQ(result.sheet.sections.find_sub_object(0x1018, 1), 2U);
    EXPECT_FALSE(result.sheet.sections.find_sub_object(0x1018, 2));
    EXPECT_FALSE(result.sheet.sections.find_object(0x1019));
}

TEST(EdsReader, reads_values_of_every_type) {
    struct Row {
        std::string_view type, text;
        std::uint64_t number;
    };
    for (const Row& row :
         {Row{"0x01", "1", 1}, Row{"0x02", "-1", 0xFF}, Row{"0x02", "0xFF", 0xFF},
          Row{"0x03", "-32768", 0x8000}, Row{"0x10", "-2", 0xFFFFFE}, Row{"0x16", "0xFFFFFF", 0xFFFFFF},
          Row{"0x1B", "0xFFFFFFFFFFFFFFFF", ~0ULL}, Row{"0x15", "-1", ~0ULL},
          Row{"0x08", "1.5", std::bit_cast<std::uint32_t>(1.5F)}, Row{"0x08", "0x3FC00000", 0x3FC00000},
          Row{"0x11", "-0.25", std::bit_cast<std::uint64_t>(-0.25)},
          Row{"0x0C", "0x123456789ABC", 0x123456789ABC}}) {
        const Result result(var(row.type, fmt::format("DefaultValue={}", row.text)));
        EXPECT_EQ(result.told(), "") << row.text;
        EXPECT_EQ(result.variable(0x2000).default_value.number, row.number) << row.type << ' ' << row.text;
    }
    EXPECT_EQ(Result(var("0x09", "DefaultValue= a;b=c ")).variable(0x2000).default_value.bytes, "a;b=c");
    EXPECT_EQ(Result(var("0x0A", "DefaultValue=00fF7a")).variable(0x2000).default_value.bytes,
              std::string("\0\xFFz", 3));
    EXPECT_TRUE(Result(var("7", "DefaultValue=")).variable(0x2000).no_default);
    EXPECT_FALSE(Result(var("7", "DefaultValue=0")).variable(0x2000).no_default);
}

TEST(EdsReader, refuses_values_that_are_not_of_their_type) {
    struct Row {
        std::string_view type, text, told;
    };
    for (const Row& row :
         {Row{"0x01", "2", "eds-number-range"}, Row{"0x02", "-129", "eds-number-range"},
          Row{"0x02", "256", "eds-number-range"}, Row{"0x05", "-1", "eds-number-range"},
          Row{"0x1B", "0x1FFFFFFFFFFFFFFFF", "eds-number-range"}, Row{"0x08", "1e300", "eds-number-range"},
          Row{"0x08", "1,5", "eds-value"}, Row{"0x07", "089", "eds-value"}, Row{"0x0A", "ABC", "eds-value"},
          Row{"0x22", "1", "eds-value"}, Row{"0x0A", "zz", "eds-value"},
          Row{"0x0A", "AB CD", "eds-number-form"}}) {
        const Result result(var(row.type, fmt::format("DefaultValue={}", row.text)));
        EXPECT_EQ(result.told(), fmt::format("6:14 {}\n", row.told)) << row.text;
    }
}

TEST(EdsReader, reads_every_key_of_a_variable_whatever_its_case) {
    const Result result(
        "[2000]\nPARAMETERNAME=Speed\nobjecttype=0x7\ndatatype=0x0006\nACCESSTYPE=RWR\nDEFAULTVALUE=1\n"
        "PdoMapping=1\nlowlimit=$NODEID+0\nHIGHLIMIT=0xFF\nobjflags=3\nParametervalue=017\nDENOTATION=n\n"
        "uploadfile=u\nDownloadFile=d\nUnit=rpm\n");
    EXPECT_EQ(result.told(), "");
    const dictionary::Variable& variable = result.variable(0x2000);
    EXPECT_EQ(variable.name, "Speed");
    EXPECT_EQ(variable.access, Access::rwr);
    EXPECT_EQ(variable.type, DataType::unsigned16);
    EXPECT_TRUE(variable.pdo_mapping);
    EXPECT_EQ(variable.low_limit, (dictionary::Value{0, true}));
    EXPECT_EQ(variable.high_limit, (dictionary::Value{0xFF}));
    EXPECT_EQ(variable.flags, 3U);
    EXPECT_EQ(variable.parameter_value, (dictionary::Value{15}));
    EXPECT_EQ(variable.denotation + variable.upload_file + variable.download_file, "nud");
}

TEST(EdsReader, makes_sub_objects_of_compact_ones) {
    const Result result(
        "[2000]\nParameterName=Limit\nObjectType=8\nDataType=0x0006\nAccessType=rw\nDefaultValue=7\n"
        "CompactSubObj=3\n[2000sub2]\nParameterName=Own\nDataType=5\nAccessType=ro\n"
        "[2000Name]\nNrOfEntries=1\n1=First\n[2000Value]\nNrOfEntries=1\n3=0x10\n4=1\n"
        "[2000Denotation]\nNrOfEntries=1\n1=den\n[2000ObjectLinks]\nObjectLinks=2\n1=0x1800\n2=0x1A00\n");
    EXPECT_EQ(result.told(), "18:1 eds-entry-alone\n");
    const dictionary::Object& object = *result.sheet.dictionary.find(0x2000);
    ASSERT_EQ(object.variables.size(), 4U);
    EXPECT_EQ(object.variables[0].default_value.number, 3U);
    EXPECT_EQ(object.variables[0].type, DataType::unsigned8);
    EXPECT_EQ(object.variables[1].name, "First");
    EXPECT_EQ(object.variables[1].denotation, "den");
    EXPECT_EQ(object.variables[2].name, "Own");
    EXPECT_EQ(object.variables[3].name, "Limit3");
    EXPECT_EQ(object.variables[3].default_value.number, 7U);
    EXPECT_EQ(object.variables[3].parameter_value, (dictionary::Value{0x10}));
    EXPECT_EQ(object.object_links, (std::vector<std::uint16_t>{0x1800, 0x1A00}));
}

TEST(EdsReader, makes_pdo_parameters_that_compact_pdo_implies) {
    const Result result(
        "[DeviceInfo]\nNrOfRXPDO=2\nNrOfTXPDO=0\nCompactPDO=0x13\n"
        "[1400]\nObjectType=9\n[1400sub0]\nDataType=5\nAccessType=ro\n");
    EXPECT_EQ(result.told(), "");
    EXPECT_EQ(result.sheet.dictionary.find(0x1400)->variables.size(), 1U) << "described";
    ASSERT_NE(result.sheet.dictionary.find(0x1401), nullptr);
    EXPECT_EQ(result.variable(0x1401, 0).default_value.number, 5U);
    EXPECT_NE(result.sheet.dictionary.find(0x1401, 5), nullptr);
    EXPECT_EQ(result.sheet.dictionary.find(0x1401, 3), nullptr);
    EXPECT_NE(result.sheet.dictionary.find(0x1601, 64), nullptr);
    EXPECT_EQ(result.sheet.dictionary.find(0x1402), nullptr);
    EXPECT_EQ(result.sheet.dictionary.find(0x1800), nullptr);
}

TEST(EdsReader, reads_modules) {
    const Result result(
        "[SupportedModules]\nNrOfEntries=1\n[M1ModuleInfo]\nProductName=DI8\nProductVersion=1\n"
        "ProductRevision=2\nOrderCode=oc\n[M1Comments]\nLines=1\nLine1=text\n[M1FixedObjects]\nNrOfEntries="
        "1\n"
        "1=0x2100\n[M1Fixed2100]\nParameterName=Fixed\nDataType=5\nAccessType=ro\n[M1SubExtends]"
        "\nNrOfEntries=2\n"
        "1=0x6000\n2=0x6200\n[M1SubExt6000]\nParameterName=In\nDataType=5\nAccessType=ro\nPDOMapping="
        "1\nCount=2\n"
        "ObjExtend=1\n[M1SubExt6200]\nParameterName=Out\nDataType=5\nAccessType=rww\nCount=0;4\n"
        "[DeviceComissioning]\nNodeID=3\n[ConnectedModules]\nNrOfEntries=2\n1=1\n2=1\n");
    EXPECT_EQ(result.told(), "");
    ASSERT_EQ(result.sheet.dictionary.modules.size(), 1U);
    const dictionary::Module& module = result.sheet.dictionary.modules[0];
    EXPECT_EQ(module.product_name + module.order_code + module.comments.at(0), "DI8octext");
    EXPECT_EQ(module.product_version * 10 + module.product_revision, 12U);
    ASSERT_EQ(module.fixed_objects.size(), 1U);
    EXPECT_EQ(module.fixed_objects[0].index, 0x2100);
    ASSERT_EQ(module.extensions.size(), 2U);
    EXPECT_EQ(module.extensions[0].count, 2U);
    EXPECT_TRUE(module.extensions[0].extends_objects);
    EXPECT_EQ(module.extensions[1].shared_bits, 4U);
    EXPECT_EQ(result.sheet.commissioning->connected_modules, (std::vector<std::uint16_t>{1, 1}));
    EXPECT_EQ(result.sheet.dictionary.find(0x2100), nullptr) << "belongs to the module";
}

TEST(EdsReader, tells_counts_that_are_no_numbers) {
    const auto told = [](const std::string& list, const std::string& sub_number) {
        return Result("[OptionalObjects]\nSupportedObjects=" + list +
                      "\n1=0x2000\n[2000]\nObjectType=9\nSubNumber=" + sub_number +
                      "\n[2000sub0]\nDataType=5\nAccessType=ro\n")
            .told();
    };
    EXPECT_EQ(told("1", "1"), "");
    EXPECT_EQ(told("300", "256"), "");  // whether they count right is not the reader's question
    EXPECT_EQ(told("99999999999999999999", "1"), "2:18 eds-number-range\n");
    EXPECT_EQ(told("1", "99999999999999999999"), "6:11 eds-number-range\n");
    EXPECT_EQ(told("-4", "-5"), "2:18 eds-number-range\n6:11 eds-number-range\n");
    EXPECT_EQ(told("1", "abc"), "6:11 eds-value\n");
    EXPECT_EQ(told("1", "$NODEID+1"), "6:11 eds-value\n");
}

TEST(EdsReader, tells_entries_of_lists_that_are_no_numbers) {
    for (const char* list : {"[OptionalObjects]", "[M1FixedObjects]", "[M1SubExtends]"}) {
        const Result result(std::string(list) + "\nNrOfEntries=x\n1=foo\n2=\n3=0x2000\n");
        const std::string count = std::string(list) == "[OptionalObjects]" ? "" : "2:13 eds-value\n";
        EXPECT_EQ(result.told(), count + "3:3 eds-value\n4:3 eds-value\n") << list;
    }
}

TEST(EdsReader, tells_what_it_cannot_read_and_reads_the_rest) {
    const Result result(
        "stray=1\n[2000]\nDataType=7\nnot an entry\n[2001]\nAccessType=ro\nDataType=0x99\n[2002\nDataType=5\n"
        "AccessType=ro\n[2003sub1]\nDataType=5\nAccessType=ro\n[2004]\nObjectType=4\nDataType=5\nAccessType="
        "maybe\n"
        "[2002]\n[2005]\nDataType=5\nDataType=6\nAccessType=ro\nPDOMapping=7\n");
    EXPECT_EQ(result.told(),
              "1:1 eds-line\n2:2 eds-key-absent\n4:1 eds-line\n7:10 eds-data-type\n8:1 eds-header\n"
              "11:2 eds-section-alone\n15:12 eds-object-type\n17:12 eds-access-type\n18:2 eds-section-twice\n"
              "21:1 eds-key-twice\n23:12 eds-number-range\n");
    std::vector<std::uint16_t> read;
    for (const dictionary::Object& object : result.sheet.dictionary.objects) {
        read.push_back(object.index);
    }
    EXPECT_EQ(read, (std::vector<std::uint16_t>{0x2002, 0x2005}));
    EXPECT_EQ(result.variable(0x2005).type, DataType::unsigned8);
}

TEST(EdsReader, tells_of_two_sections_for_one_sub_object_however_they_are_spelt) {
    const std::string entries = "DataType=5\nAccessType=ro\nDefaultValue=1\n";
    const Result result("[2000]\nObjectType=9\n[2000sub1]\n" + entries + "[2000Sub01]\n" + entries +
                        "[2000SUB1]\n" + entries);
    EXPECT_EQ(result.told(), "7:2 eds-section-twice\n11:2 eds-section-twice\n");
    EXPECT_EQ(result.sheet.dictionary.find(0x2000)->variables.size(), 1U);
}

TEST(EdsReader, tells_keys_that_stand_twice_in_lists_of_any_length) {
    EXPECT_EQ(Result("[DeviceInfo]\nBaudRate_125=1\nbaudrate_125=0\n").told(), "3:1 eds-key-twice\n");
    EXPECT_EQ(
        Result("[OptionalObjects]\nSupportedObjects=1\n1=0x1000\n1=0x1001\nsupportedobjects=2\n").told(),
        "4:1 eds-key-twice\n5:1 eds-key-twice\n");
    EXPECT_EQ(Result("[Comments]\nLines=1\nLine1=a\nLine1=b\n").told(), "4:1 eds-key-twice\n");
    const Result dummies("[DummyUsage]\nDummy0005=1\nDummy0005=0\n");
    EXPECT_EQ(dummies.told(), "3:1 eds-key-twice\n");
    EXPECT_EQ(dummies.sheet.dictionary.supported_dummies, std::vector<std::uint8_t>{5});
    EXPECT_EQ(Result("[OptionalObjects]\nSupportedObjects=2\n2=0x1001\n1=0x1000\n").told(), "");
    EXPECT_EQ(Result("[Vendor]\na=1\na=1\n[DeviceInfo]\n").told(), "");
}

TEST(EdsReader, tells_entries_of_lists_that_are_no_index) {
    EXPECT_EQ(
        Result("[OptionalObjects]\nSupportedObjects=x\n1=xyz\n2=\n3=0x10000\n4=0x1018,0x1019\n5=0x1000\n")
            .told(),
        "2:18 eds-value\n3:3 eds-value\n4:3 eds-value\n5:3 eds-number-range\n6:3 eds-value\n");
}

TEST(EdsReader, tells_counts_that_are_no_number) {
    EXPECT_EQ(Result("[Comments]\nLines=x\n").told(), "2:7 eds-value\n");
    EXPECT_EQ(Result("[SupportedModules]\nNrOfEntries=x\n").told(), "2:13 eds-value\n");
    EXPECT_EQ(Result(var("7", "[2000ObjectLinks]\nObjectLinks=x\n")).told(), "7:13 eds-value\n");
    EXPECT_EQ(Result("[2000]\nParameterName=A\nObjectType=8\nDataType=7\nAccessType=ro\nCompactSubObj=2\n"
                     "[2000Name]\nNrOfEntries=x\n")
                  .told(),
              "8:13 eds-value\n");
}

TEST(EdsReader, tells_when_a_file_is_no_eds) {
    using namespace std::string_literals;
    EXPECT_EQ(Result("").told(), "0:0 eds-text\n");
    EXPECT_EQ(Result("\x89PNG\r\n\x1A\n"s).told(), "0:0 eds-text\n");
    EXPECT_EQ(Result("\xFF\xFE[\0F\0"s).told(), "0:0 eds-text\n");
    EXPECT_EQ(Result("[FileInfo]\nFileName=a\0b\n"s).told(), "2:11 eds-text\n");
    EXPECT_EQ(Result("[FileInfo]\nFileName=a\0b\n"s).sheet.dictionary.file.file_name, "a\0b"s);
}

TEST(EdsReader, counts_findings_beyond_the_first_hundred_of_a_kind) {
    std::string text = "[FileInfo]\n";
    for (int i = 0; i < 5000; ++i) {
        text += "no entry\n";
    }
    const Result result(text);
    ASSERT_EQ(result.findings.all().size(), most_findings + 1);
    EXPECT_EQ(result.findings.all().front().message,
              "4900 more findings of this kind are not told one by one");
}

TEST(EdsReader, stops_at_a_million_sub_objects) {
    std::string text;
    for (int index = 0x2000; index < 0x4000; ++index) {
        text += fmt::format("[{:04X}]\nObjectType=8\nDataType=5\nAccessType=ro\nCompactSubObj=254\n", index);
    }
    const Result result(text);
    std::size_t variables = 0;
    for (const dictionary::Object& object : result.sheet.dictionary.objects) {
        variables += object.variables.size();
    }
    EXPECT_LE(variables, most_variables);
    EXPECT_GT(variables, most_variables - 300);
    EXPECT_NE(result.told().find("eds-too-much"), std::string::npos);
}

TEST(EdsReader, takes_any_text) {
    const std::string printed = test::read_text(CGW_TEST_DATA "/eds/printed.eds");
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        test::RandomText random(seed);
        const Result result(seed % 2 == 0 ? random.mutated(printed) : random.text());
        for (const diagnostic::Diagnostic& finding : result.findings.all()) {
            ASSERT_LE(finding.where.range.start.line, result.document.lines().size()) << "seed " << seed;
        }
    }
}

}  // namespace cgw::eds
