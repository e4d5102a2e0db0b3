// Inside the room scenario: what the rows of the table of actions do.
#pragma once

#include <span>
#include <string>

#include "scenario/actions.hpp"

namespace cgw::scenario {

// The PLC
Outcome set_sensor(Run& run, const Step& step);
Outcome set_switch(Run& run, const Step& step);
Outcome fail_sensor(Run& run, const Step& step);
Outcome repair_sensor(Run& run, const Step& step);
Outcome silence(Run& run, const Step& step);
Outcome resume(Run& run, const Step& step);
Outcome command(Run& run, const Step& step);
Outcome upload(Run& run, const Step& step);
Outcome write(Run& run, const Step& step);

// The plant
Outcome drop(Run& run, const Step& step);
Outcome restore(Run& run, const Step& step);
Outcome reset(Run& run, const Step& step);
Outcome saturate(Run& run, const Step& step);
Outcome report_fault(Run& run, const Step& step);
Outcome mend_fault(Run& run, const Step& step);
Outcome clear_errors(Run& run, const Step& step);

// Expectations
Outcome expect_state(Run& run, const Step& step);
Outcome expect_error(Run& run, const Step& step);
Outcome expect_no_error(Run& run, const Step& step);
Outcome expect_word(Run& run, const Step& step);
Outcome expect_engine(Run& run, const Step& step);
Outcome expect_alarm(Run& run, const Step& step);
Outcome expect_no_alarm(Run& run, const Step& step);
Outcome expect_status(Run& run, const Step& step);
Outcome expect_tpdo(Run& run, const Step& step);
Outcome expect_no_tpdo(Run& run, const Step& step);
Outcome expect_heartbeat(Run& run, const Step& step);
Outcome expect_boot_ups(Run& run, const Step& step);
Outcome expect_answer(Run& run, const Step& step);
Outcome expect_abort(Run& run, const Step& step);

// Mistakes
std::string sensor_cannot_be(const image::Image& image, const Step& step);
std::string range_is_empty(const image::Image& image, const Step& step);
std::string status_not_sent(const image::Image& image, const Step& step);
std::string value_too_long(const image::Image& image, const Step& step);

// Words; what they stand for is the same position of the list in act.cpp or expect.cpp.
std::span<const Word> source_words();
std::span<const Word> command_words();
std::span<const Word> addressee_words();
std::span<const Word> bus_words();
std::span<const Word> device_words();
std::span<const Word> fault_words();
std::span<const Word> state_words();
std::span<const Word> node_state_words();
std::span<const Word> engine_words();
std::span<const Word> alarm_words();         // in the order of the table
std::span<const Word> alarm_or_any_words();  // and "any"
std::span<const Word> status_words();

}  // namespace cgw::scenario
