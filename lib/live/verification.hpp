// Puts the questions of a plan to a device, one at a time, and notes where its answers differ. A state
// machine over frames and time, like everything in the core: it waits for nothing and disturbs nobody. No NMT
// command is sent.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "canopen/sdo_client.hpp"
#include "live/plan.hpp"

namespace cgw::live {

using canopen::Time;

enum class DifferenceKind : std::uint8_t {
    value,       // another value
    length,      // as many bytes as another type has
    missing,     // no such object or sub-index
    unexpected,  // an object or sub-index that should not be there
    writable,    // a write was accepted
    refused,     // refused with another abort code than the expected one, or refused at all
    silent,      // this object is never answered, others are
    garbled,     // an answer that is none to the question
};

struct Difference {
    DifferenceKind kind = DifferenceKind::value;
    std::size_t question = 0;            // position in the plan
    std::optional<std::uint32_t> value;  // the device's
    std::uint8_t length = 0;             // bytes of it
    object::AbortCode abort = object::AbortCode::none;
};

enum class Ending : std::uint8_t {
    none,          // not over yet
    complete,      // every question was put
    other_device,  // not the kind of device that the file is about
    silent,        // no answer to several questions in a row
    unsendable,    // the bus takes no frames
    interrupted,
};

// What was heard on the bus meanwhile.
struct Heard {
    std::uint64_t frames = 0;
    std::optional<canopen::NmtState> state;  // last heartbeat of the device; initialising: its boot-up
    std::bitset<facts::maximum_node_id + 1> others;  // nodes with heartbeat or boot-up
    bool other_client = false;                       // somebody else asks the device by SDO
};

struct Result {
    Ending ending = Ending::none;
    std::size_t asked = 0;  // answered or given up
    std::size_t answers = 0;
    std::vector<Difference> differences;
    std::vector<std::optional<std::uint32_t>> values;  // by question: what was read
    Heard heard;

    bool same() const { return ending == Ending::complete && differences.empty(); }
};

// Times in microseconds.
struct Pace {
    Time timeout = 1'000'000;  // of an answer
    unsigned attempts = 2;     // of a question
    unsigned silences = 3;     // questions in a row without an answer: the device is silent
    Time pause = 5'000;        // between an answer and the next question, so that others have the bus
    Time unsendable = 5'000'000;
};

class Verification {
  public:
    Verification(std::vector<Question> plan, std::uint8_t node_id, frame::FramePort& port, Pace pace = {});

    void receive(const frame::Frame& frame, Time now);
    // Returns the next deadline; while pending() is true, call again as soon as the port has room.
    Time poll(Time now);
    bool pending() const { return client_.pending(); }
    void interrupt() { end(Ending::interrupted); }

    bool over() const { return result_.ending != Ending::none; }
    const std::vector<Question>& plan() const { return plan_; }
    const Result& result() const { return result_; }

  private:
    void ask(Time now);
    void conclude(Time now);
    void judge(const Question& question);
    void judge_read(const Question& question);
    void differ(DifferenceKind kind);
    void expect_abort(object::AbortCode expected, DifferenceKind accepted);
    void end(Ending ending);

    std::vector<Question> plan_;
    std::uint8_t node_id_;
    frame::FramePort* port_;
    Pace pace_;
    canopen::SdoClient client_;
    Result result_;
    bool busy_ = false;
    unsigned attempt_ = 0;
    unsigned silences_ = 0;
    Time next_ask_ = 0;
    Time unsendable_at_ = canopen::never;  // when the port has refused long enough
};

}  // namespace cgw::live
