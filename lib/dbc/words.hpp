// Inside the dbc room: words of the format that reader and printer share.
#pragma once

#include <array>
#include <string_view>

namespace cgw::dbc {

inline constexpr std::string_view nobody = "Vector__XXX";  // stands for a node that is not known

inline constexpr std::string_view cycle_time_attribute = "GenMsgCycleTime";
inline constexpr std::string_view send_type_attribute = "GenMsgSendType";
inline constexpr std::string_view frame_format_attribute = "VFrameFormat";

// Values of the attribute GenMsgSendType, in the order of SendType.
inline constexpr std::array<std::string_view, 3> send_types{"Cyclic", "Spontaneous", "NoMsgSendType"};

}  // namespace cgw::dbc
