// Answers for `cgw explain`: what is behind a number, a name, an object, a value, a code.
//
//   416, CanOpenMyNodeID, "416 HzmCanBaudrate"   parameters, in both devices and in the bootloader
//   3074, 12412, 3172, sensor-error              errors: cause, response, action, how they clear
//   1018h, 2003h:1, 0x2003:1                     objects of the Gateway
//   2005h=0x0102, 2000h:1=4, 2411=2, 3800=9      values: which bits are set and what follows
//   0x06010002, "0601 0002h"                     SDO abort codes
//   E0203, node-id-duplicate                     rules: why they matter, broken and kept
#pragma once

#include <span>
#include <string_view>

#include "explain/answer.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::explain {

// Names are matched ignoring case. What is not understood has a complaint and, where one is near, help.
Answer explain(std::string_view question, const parameter::Catalogue& catalogue);

// The forms of questions with an example each, for help and for the complaint about an empty question.
struct QuestionForm {
    std::string_view example;
    std::string_view meaning;
};
std::span<const QuestionForm> question_forms();

}  // namespace cgw::explain
