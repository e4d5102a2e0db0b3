/* What the partner of gateway node 1 on the CANopen bus reads and sends. For C99 and C++.
   Written by cgw 0.1.0; do not edit.
   title:            none
   configuration id: 99f7512666157afd

   A PDO is a struct of its bytes as they stand on the bus, low byte first: the same on every processor.
   Of a signal X of TPDO4 there are:
     gw1_tpdo4_raw_X      the number on the bus
     gw1_tpdo4_value_X    the physical value, raw * FACTOR + OFFSET, in double
     GW1_TPDO4_BIT_X   the place of a single bit, for gw1_tpdo4_bit
   and of a signal of RPDO2 also:
     gw1_rpdo2_setraw_X   the number
     gw1_rpdo2_set_X      the physical value; 0, and nothing is written, beyond MIN and MAX
     gw1_rpdo1_turn_X     a switch function on or off, low-active ones as well
   Begin with gw1_rpdo1 x = GW1_RPDO1_REST: a struct of zeros turns low-active functions on.
   A raw value beyond RAWMIN and RAWMAX has no meaning. The compiler must not fuse multiplication and
   addition (ISO modes do not) where the last bit of a value matters. */
#ifndef CGW_GW1_PARTNER_H
#define CGW_GW1_PARTNER_H

#include <stdint.h>

#define GW1_CONFIGURATION_ID "99f7512666157afd"
#define GW1_NODE_ID 1u
#define GW1_PARTNER_NODE_ID 0u    /* 0: none */
#define GW1_BIT_RATE 125000u
#define GW1_HEARTBEAT_COB_ID 0x701u
#define GW1_HEARTBEAT_US 800000u            /* time between two; 0: the gateway sends none */
#define GW1_PARTNER_HEARTBEAT_US 0u    /* longest time between two of the partner's; 0: any */
#define GW1_SDO_REQUEST_COB_ID 0x601u
#define GW1_SDO_ANSWER_COB_ID 0x581u

static inline int32_t gw1_word(const uint8_t *at)
{
    return (int32_t)at[0] + (int32_t)at[1] * 256;
}
static inline int32_t gw1_word_signed(const uint8_t *at)
{
    int32_t word = gw1_word(at);
    return word < 32768 ? word : word - 65536;
}
static inline void gw1_putword(uint8_t *at, int32_t raw)
{
    at[0] = (uint8_t)((uint32_t)raw & 255u);
    at[1] = (uint8_t)((uint32_t)raw >> 8 & 255u);
}
static inline int gw1_putvalue(uint8_t *at, double value, double factor, double offset, double lowest,
                               double highest, int is_signed)
{
    double slack = factor < 0 ? factor / -2 : factor / 2;
    double steps;
    int32_t raw;
    if (!(value >= lowest - slack && value <= highest + slack)) {
        return 0;
    }
    value = value < lowest ? lowest : value > highest ? highest : value;
    steps = (value - offset) / factor;
    if (!(steps > -65536.0 && steps < 65536.0)) {
        return 0;
    }
    raw = (int32_t)steps;
    raw += steps - raw >= 0.5 ? 1 : steps - raw <= -0.5 ? -1 : 0;
    if (raw < (is_signed ? -32768 : 0) || raw > (is_signed ? 32767 : 65535)) {
        return 0;
    }
    gw1_putword(at, raw);
    return 1;
}

#endif
