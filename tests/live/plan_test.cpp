#include "live_test.hpp"

#include <algorithm>
#include <set>

namespace cgw::live {
namespace {

using Kind = Question::Kind;

class Plans : public testing::Test {
  protected:
    std::vector<Question> of(Kind kind) const {
        std::vector<Question> result;
        std::copy_if(questions_.begin(), questions_.end(), std::back_inserter(result),
                     [kind](const Question& question) { return question.kind == kind; });
        return result;
    }
    bool has(Kind kind, std::uint16_t index, std::uint8_t sub_index) const {
        return std::any_of(questions_.begin(), questions_.end(), [&](const Question& question) {
            return question.kind == kind && question.index == index && question.sub_index == sub_index;
        });
    }

    test::Built built_{test::small_plant()};
    std::vector<Question> questions_ = plan(built_.dictionary(), 12, {});
};

TEST_F(Plans, ask_first_who_the_device_is) {
    ASSERT_GT(questions_.size(), 3U);
    EXPECT_EQ(questions_[0].object_text(), "1000h");
    EXPECT_EQ(questions_[1].object_text(), "1018h:1");
    EXPECT_EQ(questions_[2].object_text(), "1018h:2");
    for (std::size_t i = 0; i < questions_.size(); ++i) {
        EXPECT_EQ(questions_[i].identifies, i < 3);
    }
}

TEST_F(Plans, ask_for_every_object_once) {
    std::set<std::pair<std::uint16_t, std::uint8_t>> asked;
    for (const Kind kind : {Kind::value, Kind::type}) {
        for (const Question& question : of(kind)) {
            EXPECT_TRUE(asked.insert({question.index, question.sub_index}).second);
        }
    }
    std::size_t variables = 0;
    for (const dictionary::Object& object : built_.dictionary().objects) {
        variables += object.variables.size();
    }
    EXPECT_EQ(asked.size(), variables);
}

TEST_F(Plans, put_the_node_id_into_values) {
    for (const Question& question : of(Kind::value)) {
        if (question.index == 0x1800 && question.sub_index == 1) {
            EXPECT_EQ(question.expected, 0x18CU);
        }
    }
    EXPECT_TRUE(has(Kind::value, 0x1800, 1));
}

TEST_F(Plans, compare_by_type_what_changes_while_the_device_runs) {
    for (const canopen::sdo::Multiplexer object : std::initializer_list<canopen::sdo::Multiplexer>{
             {0x1001, 0}, {0x2000, 1}, {0x2001, 1}, {0x2003, 1}, {0x2004, 2}, {0x2005, 0}}) {
        EXPECT_TRUE(has(Kind::type, object.index, object.sub_index)) << object.index;
    }
    EXPECT_TRUE(has(Kind::value, 0x2001, 0));
}

TEST_F(Plans, expect_every_write_to_be_refused_also_of_2003h_and_2004h) {
    EXPECT_EQ(of(Kind::not_writable).size(), of(Kind::value).size() + of(Kind::type).size());
    EXPECT_TRUE(has(Kind::not_writable, 0x2003, 1));
    EXPECT_TRUE(has(Kind::not_writable, 0x2004, 2));
    for (const Question& question : of(Kind::not_writable)) {
        EXPECT_EQ(questions_[question.read_by].object_text(), question.object_text());
    }
}

TEST_F(Plans, expect_nothing_beyond_the_last_sub_index_and_no_foreign_objects) {
    EXPECT_EQ(of(Kind::no_sub_index).size(), built_.dictionary().objects.size());
    EXPECT_TRUE(has(Kind::no_sub_index, 0x1018, 5));
    EXPECT_TRUE(has(Kind::no_sub_index, 0x1000, 1));
    EXPECT_TRUE(has(Kind::no_sub_index, 0x2000, 7));  // without TPDO3
    for (const std::uint16_t index :
         std::initializer_list<std::uint16_t>{0x1005, 0x1010, 0x1014, 0x1404, 0x1810}) {
        EXPECT_TRUE(has(Kind::no_object, index, 0)) << index;
    }
}

TEST_F(Plans, can_do_without_writes) {
    const std::vector<Question> reading = plan(built_.dictionary(), 12, {.write = false});
    EXPECT_EQ(reading.size(), questions_.size() - of(Kind::not_writable).size());
}

}  // namespace
}  // namespace cgw::live
