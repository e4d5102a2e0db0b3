// What a running device is asked, so that its answers tell whether it holds a configuration.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"

namespace cgw::live {

struct Question {
    enum class Kind : std::uint8_t {
        value,         // the object has this value
        type,          // it exists and is as long as its type says; its value changes while the device runs
        not_writable,  // writing back the value just read is refused with 0601 0002h
        no_sub_index,  // the object ends before this sub-index: 0609 0011h
        no_object,     // 0602 0000h
    };
    Kind kind = Kind::value;
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    bool is_variable = false;    // a VAR, whose sub-index is not shown
    std::uint8_t length = 0;     // bytes of the data type
    std::uint32_t expected = 0;  // value
    bool identifies = false;     // another value means another kind of device: nothing else is asked
    std::size_t read_by = 0;     // not_writable: which question reads the value
    std::string name;            // "TPDO5 Communication Parameter, COB-ID"

    std::string object_text() const;  // "1804h:1", "1001h"
};

struct PlanOptions {
    bool write = true;  // also not_writable
};

// One question at a time and object: who the device is, all values, then what must be refused. D29: 2003h and
// 2004h, which the EDS calls writable, must not be. Identity that the file does not state (0) is read and not
// compared (D32).
std::vector<Question> plan(const dictionary::Dictionary& dictionary, std::uint8_t node_id,
                           PlanOptions options);

// D29: writable in the EDS, for receive PDOs, and yet not by SDO.
bool only_by_pdo(const dictionary::Variable& variable);

}  // namespace cgw::live
