#include "media/can_bit_rate.hpp"

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>

#include <cstring>

namespace cgw::media {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes attribute(unsigned type, const Bytes& content) {
    const nlattr header{static_cast<std::uint16_t>(sizeof(nlattr) + content.size()),
                        static_cast<std::uint16_t>(type)};
    Bytes bytes(sizeof header);
    std::memcpy(bytes.data(), &header, sizeof header);
    bytes.insert(bytes.end(), content.begin(), content.end());
    bytes.resize((bytes.size() + 3) / 4 * 4);
    return bytes;
}

Bytes joined(Bytes first, const Bytes& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Bytes message(const Bytes& attributes, std::uint16_t type = RTM_NEWLINK) {
    nlmsghdr header{};
    header.nlmsg_type = type;
    header.nlmsg_len = static_cast<std::uint32_t>(NLMSG_LENGTH(sizeof(ifinfomsg)) + attributes.size());
    Bytes bytes(NLMSG_LENGTH(sizeof(ifinfomsg)));
    std::memcpy(bytes.data(), &header, sizeof header);
    return joined(bytes, attributes);
}

Bytes link_info(const std::string& kind, std::uint32_t rate) {
    can_bittiming timing{};
    timing.bitrate = rate;
    Bytes timing_bytes(sizeof timing);
    std::memcpy(timing_bytes.data(), &timing, sizeof timing);
    const Bytes kind_bytes(kind.c_str(), kind.c_str() + kind.size() + 1);
    const Bytes data =
        joined(attribute(IFLA_CAN_RESTART_MS, {1, 0, 0, 0}), attribute(IFLA_CAN_BITTIMING, timing_bytes));
    return attribute(IFLA_LINKINFO, joined(attribute(IFLA_INFO_KIND, kind_bytes),
                                           attribute(IFLA_INFO_DATA | NLA_F_NESTED, data)));
}

const Bytes name = attribute(IFLA_IFNAME, {'c', 'a', 'n', '0', 0});

TEST(CanBitRate, is_in_the_answer_of_the_kernel) {
    EXPECT_EQ(bit_rate_in(message(joined(name, link_info("can", 250'000)))), 250'000U);
}

TEST(CanBitRate, is_unknown_of_virtual_interfaces_and_of_controllers_that_are_not_set_up) {
    EXPECT_EQ(bit_rate_in(message(joined(name, link_info("vcan", 250'000)))), std::nullopt);
    EXPECT_EQ(bit_rate_in(message(joined(name, link_info("can", 0)))), std::nullopt);
    EXPECT_EQ(bit_rate_in(message(name)), std::nullopt);
    EXPECT_EQ(bit_rate_in(message(link_info("can", 250'000), NLMSG_ERROR)), std::nullopt);
}

TEST(CanBitRate, is_unknown_when_the_answer_is_cut_off_anywhere) {
    const Bytes whole = message(joined(link_info("can", 250'000), name));
    const std::size_t end = whole.size() - name.size();
    for (std::size_t size = 0; size < end; ++size) {
        EXPECT_EQ(bit_rate_in(std::span(whole).first(size)), std::nullopt) << size;
    }
    EXPECT_EQ(bit_rate_in(std::span(whole).first(end)), 250'000U);
}

TEST(CanBitRate, is_unknown_of_interfaces_that_are_not_there_or_no_can_interfaces) {
    EXPECT_EQ(can_bit_rate("nowhere0"), std::nullopt);
    EXPECT_EQ(can_bit_rate("lo"), std::nullopt);
}

}  // namespace
}  // namespace cgw::media
