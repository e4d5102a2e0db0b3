// The table of losses is true: what it says is lost is lost, all else comes back.
#include "convert/losses.hpp"

#include <gtest/gtest.h>

#include <set>

#include "convert/formats.hpp"
#include "dictionary/node.hpp"
#include "eds/reader.hpp"
#include "support/golden.hpp"
#include "support/random_dictionary.hpp"
#include "xdd/reader.hpp"

namespace cgw::convert {
namespace {

constexpr std::uint32_t rounds = 150;
constexpr std::array all_media{Medium::eds, Medium::dcf, Medium::xdd, Medium::xdc};  // to be read back

const Format& format_of(Medium medium) {
    for (const Format& format : formats()) {
        if (format.medium == medium) {
            return format;
        }
    }
    throw std::logic_error("no format writes this medium");
}

Description read_back(const base::Bytes& bytes, Medium medium) {
    const std::string text(bytes.begin(), bytes.end());
    diagnostic::Findings findings;
    Description description;
    if (medium == Medium::eds || medium == Medium::dcf) {
        eds::Sheet sheet = eds::read(eds::Document(text), "a", findings);
        description = {std::move(sheet.dictionary), std::move(sheet.commissioning)};
    } else {
        xdd::Sheet sheet = xdd::read(text, "a", findings);
        description = {std::move(sheet.dictionary), std::move(sheet.commissioning)};
    }
    EXPECT_TRUE(findings.all().empty()) << findings.all().front().message << '\n' << text;
    return description;
}

// Texts that are not for every format, and what a random dictionary does not have.
Description rough(std::uint32_t seed) {
    test::RandomDictionary random(seed);
    Description description{random.dictionary(), random.commissioning()};
    dictionary::Dictionary& dictionary = description.dictionary;
    if (random.below(2) == 0) {
        dictionary.file.eds_version = "404";
    }
    if (random.below(2) == 0) {
        dictionary.file.creation_date = "5-Mar-2020";
        dictionary.file.modification_time = "9:05AM";
    }
    if (random.below(2) == 0) {
        dictionary.device.product_name = "Gr\xC3\xB6\xC3\x9F\x65; 5 \xC2\xB0\x43";
        dictionary.file.description = std::string(300, 'x');
    }
    if (random.below(2) == 0) {
        dictionary.device.vendor_name = "Gr\xF6\xDF\x65";
        dictionary.comments.push_back("a\x01z");
    }
    if (random.below(3) == 0) {
        dictionary.device.compact_pdo = 0x1F;
        dictionary.device.receive_pdos = dictionary.device.transmit_pdos = 0;
    }
    for (dictionary::Object& object : dictionary.objects) {
        for (dictionary::Variable& variable : object.variables) {
            if (variable.type == object::DataType::visible_string && !variable.no_default) {
                constexpr std::array<std::string_view, 3> strings{" two\r\nlines\x02 ", "   ", ""};
                variable.default_value.bytes = strings.at(random.below(3));
            }
        }
    }
    return description;
}

// As convert() makes a node of a kind of device, but for what it says of the node.
Description convert_to_node(Description sheet, std::uint8_t node_id) {
    sheet.dictionary = dictionary::of_node(std::move(sheet.dictionary), node_id);
    sheet.node.emplace().node_id = node_id;
    return sheet;
}

}  // namespace

TEST(Losses, are_all_that_a_round_trip_changes) {
    for (const Medium medium : all_media) {
        for (std::uint32_t seed = 0; seed < rounds; ++seed) {
            Description description = rough(seed);
            const auto product = convert(description, {.format = format_of(medium)});
            ASSERT_TRUE(product);
            lose(description, medium);
            ASSERT_TRUE(read_back(product->bytes, medium) == description)
                << format_of(medium).name << ", seed " << seed << '\n'
                << std::string(product->bytes.begin(), product->bytes.end());
        }
    }
}

TEST(Losses, of_each_row_do_happen_and_only_once) {
    for (std::size_t number = 0; number < media; ++number) {
        const auto medium = static_cast<Medium>(number);
        std::set<const LossRow*> seen;
        for (std::uint32_t seed = 0; seed < rounds; ++seed) {
            Description description = rough(seed);
            for (const Loss& loss : lose(description, medium)) {
                EXPECT_GT(loss.count, 0U);
                seen.insert(loss.row);
            }
            EXPECT_TRUE(lose(description, medium).empty()) << "seed " << seed;
        }
        for (const LossRow& row : loss_rows()) {
            EXPECT_EQ(seen.contains(&row), row.is_lost_in(medium))
                << row.text << " in " << format_of(medium).name;
        }
    }
}

TEST(Losses, from_eds_to_xdd_and_back_are_those_of_both) {
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        Description sheet{dictionary::without_node(test::RandomDictionary(seed).dictionary()), std::nullopt};
        const Description xml =
            read_back(convert(sheet, {.format = format_of(Medium::xdd)})->bytes, Medium::xdd);
        const Description again =
            read_back(convert(xml, {.format = format_of(Medium::eds)})->bytes, Medium::eds);
        lose(sheet, Medium::xdd);
        ASSERT_TRUE(again == sheet) << "seed " << seed;
    }
}

// Every form to every other form, written and read on the way.
TEST(Losses, of_two_forms_in_turn_are_those_of_both) {
    for (const Medium from : all_media) {
        for (const Medium to : all_media) {
            for (std::uint32_t seed = 0; seed < rounds / 5; ++seed) {
                Description first = rough(seed);
                lose(first, from);
                const Description read = read_back(format_of(from).write(first), from);
                ASSERT_TRUE(read == first) << format_of(from).name << ", seed " << seed;
                std::optional<std::uint8_t> node_id;
                if (format_of(to).about == Format::About::node && !read.node) {
                    node_id = static_cast<std::uint8_t>(1 + seed % 127);
                    first = convert_to_node(std::move(first), *node_id);
                }
                const auto product = convert(read, {.format = format_of(to), .node_id = node_id});
                ASSERT_TRUE(product) << product.error().why;
                lose(first, to);
                const Description again = read_back(product->bytes, to);
                ASSERT_TRUE(again.dictionary == first.dictionary)
                    << format_of(from).name << " to " << format_of(to).name << ", seed " << seed << '\n'
                    << std::string(product->bytes.begin(), product->bytes.end());
            }
        }
    }
}

TEST(Losses, of_a_node_leave_every_formula_resolved) {
    std::size_t formulas = 0;
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        const Description sheet{dictionary::without_node(test::RandomDictionary(seed).dictionary()),
                                std::nullopt};
        const auto node_id = static_cast<std::uint8_t>(1 + seed % 127);
        const Description node = read_back(
            convert(sheet, {.format = format_of(Medium::dcf), .node_id = node_id})->bytes, Medium::dcf);
        for (const dictionary::Object& object : sheet.dictionary.objects) {
            for (const dictionary::Variable& variable : object.variables) {
                if (!variable.default_value.node_id_relative) {
                    continue;
                }
                ++formulas;
                const dictionary::Variable* const made =
                    node.dictionary.find(object.index, variable.sub_index);
                ASSERT_NE(made, nullptr);
                EXPECT_FALSE(made->default_value.node_id_relative);
                EXPECT_EQ(made->default_value.number, variable.default_value.number + node_id);
            }
        }
    }
    EXPECT_GT(formulas, 100U);
}

TEST(Losses, stand_in_the_documentation) {
    EXPECT_NE(test::read_text(std::filesystem::path(CGW_DOCS) / "conversions.md").find(losses_markdown()),
              std::string::npos)
        << losses_markdown();
}

}  // namespace cgw::convert
