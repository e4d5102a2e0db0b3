#include "canopen/sdo_server.hpp"

#include "canopen/table.hpp"
#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using test::RecordingPort;

class SdoServerTest : public testing::Test {
  protected:
    SdoServerTest() { server_.open(5, {table_.objects(), table_.values}); }
    std::vector<frame::Frame> answers(const frame::Frame& request) {
        server_.receive(request);
        server_.send_pending(port_);
        return port_.take();
    }
    frame::Frame answer(const std::vector<std::uint8_t>& request) {
        const std::vector<frame::Frame> all = answers(make_frame(0x605, request));
        EXPECT_EQ(all.size(), 1U);
        return all.empty() ? frame::Frame{} : all.front();
    }

    test::Table table_ = test::sample_table();
    RecordingPort port_;
    SdoServer server_;
};

TEST_F(SdoServerTest, uploads_four_bytes) {
    EXPECT_EQ(answer({0x40, 0x00, 0x10, 0, 0, 0, 0, 0}),
              make_frame(0x585, {0x43, 0x00, 0x10, 0, 0x91, 0x01, 0, 0}));
}

TEST_F(SdoServerTest, uploads_two_bytes_with_the_rest_zero) {
    EXPECT_EQ(answer({0x40, 0x00, 0x20, 1, 9, 9, 9, 9}),
              make_frame(0x585, {0x4B, 0x00, 0x20, 1, 0xEF, 0xBE, 0, 0}));
}

TEST_F(SdoServerTest, uploads_one_byte_with_the_rest_zero) {
    EXPECT_EQ(answer({0x40, 0x01, 0x10, 0, 0, 0, 0, 0}),
              make_frame(0x585, {0x4F, 0x01, 0x10, 0, 0x11, 0, 0, 0}));
}

TEST_F(SdoServerTest, refuses_a_missing_index) {
    const std::vector<std::uint8_t> abort = {0x80, 0x02, 0x10, 7, 0x00, 0x00, 0x02, 0x06};
    EXPECT_EQ(answer({0x40, 0x02, 0x10, 7, 0, 0, 0, 0}), make_frame(0x585, abort));
    EXPECT_EQ(answer({0x2B, 0x02, 0x10, 7, 0, 0, 0, 0}), make_frame(0x585, abort));
}

TEST_F(SdoServerTest, refuses_a_missing_sub_index_also_in_a_gap_and_of_a_var) {
    EXPECT_EQ(answer({0x40, 0x18, 0x10, 2, 0, 0, 0, 0}),
              make_frame(0x585, {0x80, 0x18, 0x10, 2, 0x11, 0x00, 0x09, 0x06}));
    EXPECT_EQ(answer({0x23, 0x18, 0x10, 9, 0, 0, 0, 0}),
              make_frame(0x585, {0x80, 0x18, 0x10, 9, 0x11, 0x00, 0x09, 0x06}));
    EXPECT_EQ(answer({0x40, 0x00, 0x10, 1, 0, 0, 0, 0}),
              make_frame(0x585, {0x80, 0x00, 0x10, 1, 0x11, 0x00, 0x09, 0x06}));
}

TEST_F(SdoServerTest, refuses_every_other_command_with_the_multiplexer_of_the_request) {
    answer({0x40, 0x18, 0x10, 1, 0, 0, 0, 0});
    for (int command = 0; command < 256; ++command) {
        const bool known = command == 0x40 || command == 0x80 || (command & 0xF0) == 0x20;
        if (!known) {
            EXPECT_EQ(answer({static_cast<std::uint8_t>(command), 0x34, 0x12, 0x56, 1, 2, 3, 4}),
                      make_frame(0x585, {0x80, 0x34, 0x12, 0x56, 0x01, 0x00, 0x04, 0x05}))
                << "command " << command;
        }
    }
}

struct Write {
    std::vector<std::uint8_t> request;
    std::uint32_t abort_code;
};

TEST_F(SdoServerTest, checks_a_write_in_the_order_length_then_access) {
    const std::vector<Write> writes = {
        {{0x2B, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06010002},  // right length
        {{0x2F, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06070013},  // one byte for two
        {{0x27, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06070012},  // three bytes for two
        {{0x23, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06070012},  // four bytes for two
        {{0x22, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06010002},  // no length stated
        {{0x2E, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06010002},  // n without s means nothing
        {{0x20, 0x17, 0x10, 0, 9, 0, 0, 0}, 0x06010002},  // not expedited, no length stated
        {{0x21, 0x17, 0x10, 0, 2, 0, 0, 0}, 0x06010002},  // not expedited, length 2 in the data
        {{0x21, 0x17, 0x10, 0, 1, 0, 0, 0}, 0x06070013}, {{0x21, 0x17, 0x10, 0, 0, 1, 0, 0}, 0x06070012},
        {{0x2B, 0x03, 0x20, 1, 1, 0, 0, 0}, 0x06010002},  // rww, yet read-only by SDO (D29)
    };
    const std::vector<std::uint8_t> before = table_.values;
    for (const Write& write : writes) {
        const frame::Frame reply = answer(write.request);
        EXPECT_EQ(reply.data[0], 0x80);
        EXPECT_EQ(sdo::multiplexer(reply), sdo::multiplexer(make_frame(0, write.request)));
        EXPECT_EQ(sdo::payload(reply), write.abort_code) << "command " << int{write.request[0]};
    }
    EXPECT_EQ(table_.values, before);
}

TEST_F(SdoServerTest, accepts_a_write_to_a_writable_object) {
    EXPECT_EQ(answer({0x2B, 0x10, 0x20, 0, 0x34, 0x12, 0, 0}),
              make_frame(0x585, {0x60, 0x10, 0x20, 0, 0, 0, 0, 0}));
    EXPECT_EQ(table_.value(0x2010, 0), 0x1234U);
    EXPECT_EQ(table_.value(0x2011, 0), 5U);
}

TEST_F(SdoServerTest, refuses_a_segmented_write_to_a_writable_object) {
    EXPECT_EQ(sdo::payload(answer({0x21, 0x10, 0x20, 0, 2, 0, 0, 0})), 0x05040001U);
    EXPECT_EQ(table_.value(0x2010, 0), 5U);
}

TEST_F(SdoServerTest, refuses_to_read_a_write_only_object) {
    EXPECT_EQ(sdo::payload(answer({0x40, 0x11, 0x20, 0, 0, 0, 0, 0})), 0x06010001U);
}

TEST_F(SdoServerTest, ignores_short_remote_and_extended_requests) {
    EXPECT_TRUE(answers(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0})).empty());
    EXPECT_TRUE(answers(make_frame(0x605, {})).empty());
    frame::Frame frame = make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0});
    frame.remote = true;
    EXPECT_TRUE(answers(frame).empty());
    frame.remote = false;
    frame.extended = true;
    EXPECT_TRUE(answers(frame).empty());
}

TEST_F(SdoServerTest, never_answers_an_abort) {
    EXPECT_TRUE(answers(make_frame(0x605, {0x80, 0x00, 0x10, 0, 0, 0, 4, 5})).empty());
}

TEST_F(SdoServerTest, cancels_the_waiting_answer_on_an_abort) {
    server_.receive(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(server_.pending());
    server_.receive(make_frame(0x605, {0x80, 0x00, 0x10, 0, 0, 0, 4, 5}));
    EXPECT_FALSE(server_.pending());
    EXPECT_TRUE(server_.send_pending(port_));
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(SdoServerTest, keeps_answers_for_a_port_that_says_not_now) {
    port_.room = 0;
    server_.receive(make_frame(0x605, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0}));
    server_.receive(make_frame(0x605, {0x40, 0x18, 0x10, 3, 0, 0, 0, 0}));
    EXPECT_FALSE(server_.send_pending(port_));
    port_.room = 1;
    EXPECT_FALSE(server_.send_pending(port_));
    EXPECT_TRUE(server_.pending());
    port_.room = 1;
    EXPECT_TRUE(server_.send_pending(port_));
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x585, {0x43, 0x18, 0x10, 1, 0x61, 0x01, 0, 0}),
                                         make_frame(0x585, {0x43, 0x18, 0x10, 3, 7, 0, 0, 0})}));
}

TEST_F(SdoServerTest, lets_no_answer_overtake_one_that_waits) {
    port_.room = 0;
    server_.receive(make_frame(0x605, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0}), &port_);
    EXPECT_TRUE(server_.pending());
    port_.room = RecordingPort::unlimited;
    server_.receive(make_frame(0x605, {0x40, 0x18, 0x10, 3, 0, 0, 0, 0}), &port_);
    EXPECT_FALSE(server_.pending());
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x585, {0x43, 0x18, 0x10, 1, 0x61, 0x01, 0, 0}),
                                         make_frame(0x585, {0x43, 0x18, 0x10, 3, 7, 0, 0, 0})}));
}

TEST_F(SdoServerTest, aborts_with_the_multiplexer_of_the_request_after_any_other) {
    port_.room = 0;
    server_.receive(make_frame(0x605, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0}), &port_);
    server_.receive(make_frame(0x605, {0x40, 0x34, 0x12, 5, 0, 0, 0, 0}), &port_);
    server_.receive(make_frame(0x605, {0x60, 0x78, 0x56, 9, 0, 0, 0, 0}), &port_);
    port_.room = RecordingPort::unlimited;
    server_.send_pending(port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x585, {0x43, 0x18, 0x10, 1, 0x61, 0x01, 0, 0}),
                                         make_frame(0x585, {0x80, 0x34, 0x12, 5, 0x00, 0x00, 0x02, 0x06}),
                                         make_frame(0x585, {0x80, 0x78, 0x56, 9, 0x01, 0x00, 0x04, 0x05})}));
}

TEST_F(SdoServerTest, answers_an_abandoned_request_only_under_its_own_multiplexer) {
    port_.room = 0;
    server_.receive(make_frame(0x605, {0x40, 0x17, 0x10, 0, 0, 0, 0, 0}));
    server_.send_pending(port_);
    server_.receive(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
    port_.room = RecordingPort::unlimited;
    server_.send_pending(port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x585, {0x4B, 0x17, 0x10, 0, 0xE8, 0x03, 0, 0}),
                                         make_frame(0x585, {0x43, 0x00, 0x10, 0, 0x91, 0x01, 0, 0})}));
}

TEST_F(SdoServerTest, counts_what_it_must_drop_when_nobody_takes_the_answers) {
    port_.room = 0;
    for (std::size_t i = 0; i <= SdoServer::capacity; ++i) {
        server_.receive(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
    }
    EXPECT_EQ(server_.counters().overflows, 1U);
    port_.room = RecordingPort::unlimited;
    EXPECT_TRUE(server_.send_pending(port_));
    EXPECT_EQ(port_.sent.size(), SdoServer::capacity);
}

TEST_F(SdoServerTest, counts_answers_and_aborts) {
    answer({0x40, 0x00, 0x10, 0, 0, 0, 0, 0});
    answer({0x40, 0x99, 0x10, 0, 0, 0, 0, 0});
    EXPECT_EQ(server_.counters().answers, 1U);
    EXPECT_EQ(server_.counters().aborts, 1U);
}

}  // namespace
}  // namespace cgw::canopen
