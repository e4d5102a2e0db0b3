// Messages of plants and of other nodes, and how they come together.
#include "network/sources.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "diagnostic/rules/network.hpp"
#include "network/identifier_map.hpp"
#include "network/judge.hpp"
#include "network/same_device.hpp"
#include "support/plant_builder.hpp"

namespace cgw::network {
namespace {

const Message* find(const std::vector<Message>& messages, std::uint32_t identifier) {
    const auto found = std::find_if(messages.begin(), messages.end(),
                                    [&](const Message& message) { return message.identifier == identifier; });
    return found == messages.end() ? nullptr : &*found;
}

dictionary::Object record(std::uint16_t index, const std::vector<std::uint64_t>& values) {
    dictionary::Object object;
    object.index = index;
    object.code = object::ObjectCode::record;
    for (std::size_t sub = 0; sub < values.size(); ++sub) {
        dictionary::Variable variable;
        variable.sub_index = static_cast<std::uint8_t>(sub);
        variable.type = object::DataType::unsigned32;
        variable.default_value.number = values[sub];
        object.variables.push_back(variable);
    }
    return object;
}

const diagnostic::Location whole{"node.eds", {}};

diagnostic::Location place_of(std::uint16_t index, std::uint8_t sub_index) {
    return {"node.eds", {{index, sub_index}, {index, sub_index}}};
}

Message row(std::uint32_t identifier, const std::string& name, int plant, bool is_assumed = false) {
    Message message;
    message.identifier = identifier;
    message.bytes = 8;
    message.name = name;
    message.period_us = 10'000;
    message.plant = plant;
    message.assumed = is_assumed;
    return message;
}

}  // namespace

TEST(PlantMessages, are_those_of_the_active_pdos_and_services) {
    test::PlantBuilder plant;
    plant.minimal().governor(14401, 1).governor(14402, 1).network_node(5);
    const std::vector<Message> messages = messages_of(plant.settings(), plant.resolve(), 0);
    const Message* tpdo1 = find(messages, 0x181);
    ASSERT_NE(tpdo1, nullptr);
    EXPECT_EQ(tpdo1->release, Release::event);
    EXPECT_EQ(tpdo1->period_us, 15'625U);
    EXPECT_EQ(tpdo1->bytes, 8);
    EXPECT_EQ(find(messages, 0x281)->bytes, 4);
    EXPECT_EQ(find(messages, 0x381)->bytes, 2);
    EXPECT_EQ(find(messages, 0x481), nullptr);
    EXPECT_EQ(find(messages, 0x701)->period_us, 800'000U);
    EXPECT_TRUE(find(messages, 0x581)->assumed);
    EXPECT_TRUE(find(messages, 0x705)->assumed);
    EXPECT_EQ(find(messages, 0x705)->period_us, assumed::heartbeat_us);
}

TEST(NodeMessages, follow_the_objects_of_the_node) {
    dictionary::Dictionary node;
    node.objects = {record(0x1005, {0x40000080}),
                    record(0x1006, {20'000}),
                    record(0x1014, {0x80}),
                    record(0x1015, {50}),
                    record(0x1017, {250}),
                    record(0x1400, {5, 0x200, 255, 0, 0, 100}),
                    record(0x1600, {1, 0x62000108}),
                    record(0x1800, {5, 0x180, 255, 20, 0, 50}),
                    record(0x1801, {5, 0x280, 255, 20, 0, 0}),
                    record(0x1802, {5, 0x380, 2, 0, 0, 0}),
                    record(0x1803, {5, 0x80000480, 255, 0, 0, 10}),
                    record(0x1804, {5, 0x20012345, 255, 0, 0, 10}),
                    record(0x1805, {5, 0x401, 255, 0, 0, 50}),
                    record(0x1A00, {2, 0x60000108, 0x60000210}),
                    record(0x1A01, {0}),
                    record(0x1A02, {1, 0x60000140})};
    for (dictionary::Object& object : node.objects) {
        const bool follows = object.index == 0x1014 || object.index >= 0x1400;
        if (follows && object.index < 0x1804) {
            object.variables[object.index == 0x1014 ? 0 : 1].default_value.node_id_relative =
                object.index == 0x1014 || object.variables.size() == 6;
        }
    }
    const ForeignNode found = messages_of(node, 7, whole, place_of);
    EXPECT_EQ(find(found.messages, 0x080)->period_us, 20'000U);
    EXPECT_EQ(find(found.messages, 0x080)->where, place_of(0x1006, 0));
    EXPECT_EQ(find(found.messages, 0x087)->where, place_of(0x1014, 0));
    EXPECT_EQ(find(found.messages, 0x707)->where, place_of(0x1017, 0));
    EXPECT_EQ(find(found.messages, 0x187)->where, place_of(0x1800, 1));
    EXPECT_EQ(find(found.messages, 0x207)->where, place_of(0x1400, 1));
    EXPECT_EQ(find(found.messages, 0x587)->where, whole);
    EXPECT_EQ(find(found.messages, 0x087)->period_us, 5'000U);
    EXPECT_EQ(find(found.messages, 0x707)->period_us, 250'000U);
    EXPECT_EQ(find(found.messages, 0x187)->period_us, 2'000U);  // the event timer is the longest time
    EXPECT_EQ(find(found.messages, 0x187)->release, Release::event);
    EXPECT_EQ(find(found.messages, 0x187)->deadline_us, 0U);  // nobody says when it must be there
    EXPECT_EQ(find(found.messages, 0x401)->period_us, 50'000U);
    EXPECT_TRUE(find(found.messages, 0x401)->assumed);  // nobody says how often it changes
    EXPECT_EQ(find(found.messages, 0x187)->bytes, 3);
    EXPECT_EQ(find(found.messages, 0x287)->period_us, 2'000U);
    EXPECT_EQ(find(found.messages, 0x287)->release, Release::event);
    EXPECT_EQ(find(found.messages, 0x387)->period_us, 40'000U);  // every second SYNC
    EXPECT_EQ(find(found.messages, 0x387)->bytes, 8);
    EXPECT_EQ(find(found.messages, 0x487), nullptr);
    const Message* rpdo = find(found.messages, 0x207);
    EXPECT_TRUE(rpdo->assumed && rpdo->receiver);
    EXPECT_EQ(rpdo->period_us, 50'000U);
    EXPECT_EQ(rpdo->deadline_us, 100'000U);
    ASSERT_EQ(found.left_out.size(), 1U);
    EXPECT_EQ(found.left_out[0].message, "TPDO5 of node 7: its identifier has 29 bits");
    EXPECT_EQ(found.left_out[0].where, place_of(0x1804, 1));
}

TEST(Merging, a_statement_takes_the_place_of_an_assumption) {
    Message demanded = row(0x201, "RPDO1 of node 1", 0, true);
    demanded.receiver = true;
    demanded.bytes = 6;
    demanded.monitored_us = 50'000;
    demanded.deadline_us = 50'000;
    Message stated = row(0x201, "setpoint", 0);
    stated.bytes = 4;
    const std::vector<Message> messages = merged({demanded, stated});
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[0].name, "NMT");
    EXPECT_EQ(messages[1].name, "setpoint");
    EXPECT_EQ(messages[1].deadline_us, 50'000U);
    EXPECT_EQ(messages[1].received_bytes, 6);
}

TEST(Merging, synchronous_pdos_follow_the_sync_of_whoever_sends_it) {
    Message pdo = row(0x185, "TPDO1", -1);
    pdo.sender = "node 5";
    pdo.assumed = true;
    pdo.sync_multiple = 3;
    Message sync = row(0x080, "message 080h", 0);
    sync.period_us = 5'000;
    const std::vector<Message> messages = merged({pdo, sync});
    EXPECT_EQ(find(messages, 0x185)->period_us, 15'000U);
    EXPECT_EQ(find(messages, 0x185)->deadline_us, 15'000U);
    EXPECT_FALSE(find(messages, 0x185)->assumed);
    EXPECT_TRUE(find(merged({pdo}), 0x185)->assumed);
}

TEST(Merging, a_message_of_which_only_the_time_is_assumed_has_its_sender) {
    Message one = row(0x185, "TPDO1", 0, true);
    one.sender = "node 5";
    Message other = row(0x185, "TPDO4", 1);
    other.sender = "node 12";
    EXPECT_TRUE(are_in_conflict(one, other));
    EXPECT_EQ(merged({one, other}).size(), 3U);
    other.sender.clear();  // a row says when it is sent
    EXPECT_FALSE(are_in_conflict(one, other));
    EXPECT_EQ(merged({one, other}).size(), 2U);
}

TEST(Merging, what_two_files_say_of_one_message_counts_once) {
    EXPECT_EQ(merged({row(0x300, "setpoint", 0), row(0x300, "setpoint", 1)}).size(), 2U);
    EXPECT_EQ(merged({row(0x300, "setpoint", 0), row(0x300, "setpoint", 0)}).size(), 3U);
    EXPECT_EQ(merged({row(0x300, "setpoint", 0), row(0x300, "load", 1)}).size(), 3U);
}

TEST(Merging, of_two_statements_the_more_demanding_one_counts) {
    Message slow = row(0x300, "setpoint", 0);
    slow.period_us = 800'000;
    Message fast = row(0x300, "setpoint", 1);
    fast.period_us = 200'000;
    fast.jitter_us = 2'000;
    for (const std::vector<Message>& told : {std::vector{slow, fast}, std::vector{fast, slow}}) {
        const std::vector<Message> messages = merged(told);
        ASSERT_EQ(messages.size(), 2U);
        EXPECT_EQ(messages[1].period_us, 200'000U);
        EXPECT_EQ(messages[1].jitter_us, 2'000U);
        diagnostic::Findings findings;
        judge_owners({}, told, findings);
        ASSERT_EQ(findings.all().size(), 1U);
        EXPECT_EQ(findings.all()[0].rule, &diagnostic::rules::message_told_twice);
    }
    diagnostic::Findings findings;
    judge_owners({}, std::vector{slow, row(0x301, "setpoint", 1, true)}, findings);
    EXPECT_TRUE(findings.all().empty());
}

namespace {

std::vector<Message> described(std::uint64_t heartbeat_us, int device) {
    dictionary::Dictionary node;
    node.objects = {record(0x1017, {heartbeat_us / 1000})};
    std::vector<Message> messages = messages_of(node, 1, whole, place_of).messages;
    for (Message& message : messages) {
        message.plant = device;
    }
    return messages;
}

}  // namespace

TEST(NodeIds, belong_to_one_device) {
    test::PlantBuilder plant;
    plant.minimal();
    const std::vector<Message> own = messages_of(plant.settings(), plant.resolve(), 0);
    EXPECT_EQ(difference_between(own, described(800'000, -1), 1), "");
    EXPECT_EQ(difference_between(own, described(200'000, -1), 1),
              "701h heartbeat of node 1 is every 200 ms, and the plant's every 800 ms");
    EXPECT_EQ(difference_between(own, described(0, -1), 1), "it has no 701h heartbeat of node 1");
    std::vector<Message> more = described(800'000, -1);
    more.push_back(row(0x181, "TPDO1", -1));
    EXPECT_EQ(difference_between(own, more, 1), "the plant has no 181h TPDO1");
    more = described(800'000, -1);
    more.back().bytes = 4;
    EXPECT_NE(difference_between(own, more, 1).find(" has 4 bytes, and the plant's 8"), std::string::npos);

    const std::vector<Member> members{member_of(plant.settings(), plant.resolve())};
    const auto codes = [&](std::vector<Message> messages, const std::vector<Message>& added) {
        messages.insert(messages.end(), added.begin(), added.end());
        diagnostic::Findings findings;
        judge_owners(members, messages, findings);
        std::string text;
        for (const diagnostic::Diagnostic& finding : findings.all()) {
            text += fmt::format("{} {}\n", finding.rule->code, finding.where.path);
        }
        return text;
    };
    EXPECT_EQ(codes(own, described(800'000, -1)), "");
    EXPECT_EQ(codes(own, described(200'000, -1)), "E1104 node.eds\n");
    std::vector<Message> twice = described(800'000, -1);
    const std::vector<Message> again = described(800'000, -2);
    twice.insert(twice.end(), again.begin(), again.end());
    diagnostic::Findings findings;
    judge_owners({}, twice, findings);
    ASSERT_EQ(findings.all().size(), 1U);
    EXPECT_EQ(findings.all()[0].message, "two other nodes have node id 1");
}

TEST(Judging, nodes_have_the_bit_rate_of_the_bus) {
    const auto told = [](std::vector<unsigned> offered, std::optional<std::uint32_t> set,
                         std::uint32_t bit_rate) {
        const DescribedNode node{
            .node_id = 5, .offered_kbit = offered, .set_kbit = set, .offered_where = {}, .set_where = {}};
        diagnostic::Findings findings;
        judge_bit_rates(std::vector{node}, bit_rate, findings);
        return findings.all().empty()
                   ? ""
                   : fmt::format("{}: {}", findings.all()[0].rule->code, findings.all()[0].message);
    };
    EXPECT_EQ(told({}, {}, 250'000), "");
    EXPECT_EQ(told({125, 250}, {}, 250'000), "");
    EXPECT_EQ(told({125, 500}, {}, 250'000),
              "E1114: node 5 has no 250 kbit/s, by its description: it has 125, 500");
    EXPECT_EQ(told({83}, {}, 83'333), "E1114: node 5 has no 83.333 kbit/s, by its description: it has 83");
    EXPECT_EQ(told({}, 250, 250'000), "");
    EXPECT_EQ(told({125, 250}, 125, 250'000), "E1102: node 5 is set to 125 kbit/s, and the bus has 250");
}

TEST(Judging, a_message_that_nobody_states_is_a_matter_of_the_bus) {
    test::PlantBuilder plant;
    plant.minimal();
    const std::vector<Member> members{member_of(plant.settings(), plant.resolve())};
    Bus bus;
    bus.errors_per_second = 3000;
    const Judged judged =
        judge_bus(members, {}, messages_of(plant.settings(), plant.resolve(), 0), bus, Bands{});
    ASSERT_EQ(judged.findings.all().size(), 1U);
    const diagnostic::Diagnostic& finding = judged.findings.all()[0];
    EXPECT_EQ(finding.rule, &diagnostic::rules::message_unbounded);
    EXPECT_EQ(finding.where, members[0].rate_where);
    EXPECT_NE(finding.message.find("3000 errors per second may take all the bus"), std::string::npos);
    EXPECT_EQ(finding.help, "raise the bit rate, or count with fewer errors");
}

// A SYNC that comes late makes three PDOs late together, right behind those of the SYNC before.
TEST(Judging, pdos_that_go_with_the_sync_are_as_late_as_that) {
    test::PlantBuilder plant;
    plant.minimal();
    const std::vector<Member> members{member_of(plant.settings(), plant.resolve())};
    std::vector<Message> messages = messages_of(plant.settings(), plant.resolve(), 0);
    Message sync = row(0x080, "SYNC", 0);
    sync.bytes = 0;
    sync.jitter_us = 9'000;
    messages.push_back(sync);
    for (const std::uint32_t identifier : {0x194U, 0x195U, 0x196U}) {
        Message pdo = row(identifier, "TPDO1", -1, true);
        pdo.sync_multiple = 1;
        messages.push_back(pdo);
    }
    const auto results = [&](std::uint64_t jitter_us) {
        for (Message& message : messages) {
            message.jitter_us = message.identifier == 0x080 ? jitter_us : message.jitter_us;
        }
        return judge_bus(members, {}, messages, {}, Bands{}).analysis->messages;
    };
    const auto result_of = [](const std::vector<MessageResult>& all, std::uint32_t identifier) {
        return *std::find_if(all.begin(), all.end(), [&](const MessageResult& each) {
            return each.message.identifier == identifier;
        });
    };
    for (const std::uint64_t jitter_us : {0U, 9'000U}) {
        const std::vector<MessageResult> all = results(jitter_us);
        const std::uint64_t of_sync = result_of(all, 0x080).response_us;
        EXPECT_GT(of_sync, jitter_us);
        EXPECT_EQ(result_of(all, 0x194).message.jitter_us, of_sync);
        EXPECT_GT(result_of(all, 0x194).response_us, of_sync);
    }
    // Frames of two SYNCs in a row are in its way, not of one.
    const auto behind = [&](std::uint64_t jitter_us) {
        return result_of(results(jitter_us), 0x701).response_us;
    };
    EXPECT_GT(behind(9'000), behind(0) + 3 * 500);
}

TEST(IdentifierMap, covers_all_identifiers_once) {
    const std::vector<Message> messages{row(0x301, "a", 0), row(0x301, "b", 0), row(0x680, "c", 0)};
    const std::vector<IdentifierRange> map = identifier_map(messages);
    std::uint32_t next = 0;
    for (const IdentifierRange& range : map) {
        EXPECT_EQ(range.first, next);
        next = range.last + 1U;
        EXPECT_EQ(range.use == Use::conflict, range.first == 0x301);
        EXPECT_EQ(range.use == Use::taken, range.first == 0x680 || range.first == 0);  // 000h: NMT commands
    }
    EXPECT_EQ(next, 2048U);
    EXPECT_EQ(free_identifiers(messages, 2), (std::vector<std::uint16_t>{0x681, 0x682}));
    const std::vector<std::uint16_t> many = free_identifiers(messages, 2048);
    EXPECT_EQ(many[94], 0x6DF);
    EXPECT_EQ(many[95], 0x181);
    EXPECT_EQ(std::count(many.begin(), many.end(), 0x301), 0);
    const std::string strip = identifier_strip(map);
    EXPECT_NE(strip.find("300 RPDO2  |X "), std::string::npos) << strip;
    EXPECT_NE(strip.find("680 free   |#..."), std::string::npos) << strip;
}

TEST(Bands, have_their_limits_inside) {
    EXPECT_EQ(band_of(0.30, {}), Band::comfortable);
    EXPECT_EQ(band_of(0.31, {}), Band::ok);
    EXPECT_EQ(band_of(0.50, {}), Band::ok);
    EXPECT_EQ(band_of(0.51, {}), Band::high);
    EXPECT_EQ(band_of(0.70, {}), Band::high);
    EXPECT_EQ(band_of(0.71, {}), Band::overloaded);
}

}  // namespace cgw::network
