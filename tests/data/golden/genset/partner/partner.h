/* What the partner of gateway node 12 on the CANopen bus reads and sends. For C99 and C++.
   Written by cgw 0.1.0; do not edit.
   title:            Genset 2, starboard
   configuration id: d4dc49f089f420e1

   A PDO is a struct of its bytes as they stand on the bus, low byte first: the same on every processor.
   Of a signal X of TPDO4 there are:
     gw12_tpdo4_raw_X      the number on the bus
     gw12_tpdo4_value_X    the physical value, raw * FACTOR + OFFSET, in double
     GW12_TPDO4_BIT_X   the place of a single bit, for gw12_tpdo4_bit
   and of a signal of RPDO2 also:
     gw12_rpdo2_setraw_X   the number
     gw12_rpdo2_set_X      the physical value; 0, and nothing is written, beyond MIN and MAX
     gw12_rpdo1_turn_X     a switch function on or off, low-active ones as well
   Begin with gw12_rpdo1 x = GW12_RPDO1_REST: a struct of zeros turns low-active functions on.
   A raw value beyond RAWMIN and RAWMAX has no meaning. The compiler must not fuse multiplication and
   addition (ISO modes do not) where the last bit of a value matters. */
#ifndef CGW_GW12_PARTNER_H
#define CGW_GW12_PARTNER_H

#include <stdint.h>

#define GW12_CONFIGURATION_ID "d4dc49f089f420e1"
#define GW12_NODE_ID 12u
#define GW12_PARTNER_NODE_ID 1u    /* 0: none */
#define GW12_BIT_RATE 250000u
#define GW12_HEARTBEAT_COB_ID 0x70Cu
#define GW12_HEARTBEAT_US 800000u            /* time between two; 0: the gateway sends none */
#define GW12_PARTNER_HEARTBEAT_US 2000000u    /* longest time between two of the partner's; 0: any */
#define GW12_SDO_REQUEST_COB_ID 0x60Cu
#define GW12_SDO_ANSWER_COB_ID 0x58Cu

static inline int32_t gw12_word(const uint8_t *at)
{
    return (int32_t)at[0] + (int32_t)at[1] * 256;
}
static inline int32_t gw12_word_signed(const uint8_t *at)
{
    int32_t word = gw12_word(at);
    return word < 32768 ? word : word - 65536;
}
static inline void gw12_putword(uint8_t *at, int32_t raw)
{
    at[0] = (uint8_t)((uint32_t)raw & 255u);
    at[1] = (uint8_t)((uint32_t)raw >> 8 & 255u);
}
static inline int gw12_putvalue(uint8_t *at, double value, double factor, double offset, double lowest,
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
    gw12_putword(at, raw);
    return 1;
}

/* TPDO1 (1800h, 1A00h), from the gateway: 8 bytes, sent when a bit changes */
#define GW12_TPDO1_COB_ID 0x18Cu
#define GW12_TPDO1_LENGTH 8u
#define GW12_TPDO1_CYCLE_US 0u

typedef struct { uint8_t bytes[8]; } gw12_tpdo1;
typedef char gw12_tpdo1_is_packed[sizeof(gw12_tpdo1) == 8u ? 1 : -1];
static inline int gw12_tpdo1_take(gw12_tpdo1 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_TPDO1_COB_ID || length < GW12_TPDO1_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_TPDO1_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of TPDO1, counted from the lowest of byte 0. */
enum {
    /* 3000, 2000h:1; governor ConfigurationError; 1: the error is present */
    GW12_TPDO1_BIT_ConfigurationError = 0,
    /* 3001, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3001 = 1,
    /* 3002, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3002 = 2,
    /* 3003, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3003 = 3,
    /* 3004, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3004 = 4,
    /* 3005, 2000h:1; governor ErrSetpointExtern; 1: the error is present */
    GW12_TPDO1_BIT_ErrSetpointExtern = 5,
    /* 3006, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3006 = 6,
    /* 3007, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3007 = 7,
    /* 3008, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3008 = 8,
    /* 3009, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3009 = 9,
    /* 3010, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3010 = 10,
    /* 3011, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3011 = 11,
    /* 3012, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3012 = 12,
    /* 3013, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3013 = 13,
    /* 3014, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3014 = 14,
    /* 3015, 2000h:1; 1: the error is present */
    GW12_TPDO1_BIT_Error_3015 = 15,
    /* 3016, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3016 = 16,
    /* 3017, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3017 = 17,
    /* 3018, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3018 = 18,
    /* 3019, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3019 = 19,
    /* 3020, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3020 = 20,
    /* 3021, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3021 = 21,
    /* 3022, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3022 = 22,
    /* 3023, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3023 = 23,
    /* 3024, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3024 = 24,
    /* 3025, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3025 = 25,
    /* 3026, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3026 = 26,
    /* 3027, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3027 = 27,
    /* 3028, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3028 = 28,
    /* 3029, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3029 = 29,
    /* 3030, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3030 = 30,
    /* 3031, 2000h:2; 1: the error is present */
    GW12_TPDO1_BIT_Error_3031 = 31,
    /* 3032, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3032 = 32,
    /* 3033, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3033 = 33,
    /* 3034, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3034 = 34,
    /* 3035, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3035 = 35,
    /* 3036, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3036 = 36,
    /* 3037, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3037 = 37,
    /* 3038, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3038 = 38,
    /* 3039, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3039 = 39,
    /* 3040, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3040 = 40,
    /* 3041, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3041 = 41,
    /* 3042, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3042 = 42,
    /* 3043, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3043 = 43,
    /* 3044, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3044 = 44,
    /* 3045, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3045 = 45,
    /* 3046, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3046 = 46,
    /* 3047, 2000h:3; 1: the error is present */
    GW12_TPDO1_BIT_Error_3047 = 47,
    /* 3048, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3048 = 48,
    /* 3049, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3049 = 49,
    /* 3050, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3050 = 50,
    /* 3051, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3051 = 51,
    /* 3052, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3052 = 52,
    /* 3053, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3053 = 53,
    /* 3054, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3054 = 54,
    /* 3055, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3055 = 55,
    /* 3056, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3056 = 56,
    /* 3057, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3057 = 57,
    /* 3058, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3058 = 58,
    /* 3059, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3059 = 59,
    /* 3060, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3060 = 60,
    /* 3061, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3061 = 61,
    /* 3062, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3062 = 62,
    /* 3063, 2000h:4; 1: the error is present */
    GW12_TPDO1_BIT_Error_3063 = 63
};
static inline int gw12_tpdo1_bit(const gw12_tpdo1 *pdo, unsigned bit)
{
    return bit / 8u < GW12_TPDO1_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}

/* TPDO2 (1801h, 1A01h), from the gateway: 4 bytes, sent when a bit changes */
#define GW12_TPDO2_COB_ID 0x28Cu
#define GW12_TPDO2_LENGTH 4u
#define GW12_TPDO2_CYCLE_US 0u

typedef struct { uint8_t bytes[4]; } gw12_tpdo2;
typedef char gw12_tpdo2_is_packed[sizeof(gw12_tpdo2) == 4u ? 1 : -1];
static inline int gw12_tpdo2_take(gw12_tpdo2 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_TPDO2_COB_ID || length < GW12_TPDO2_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_TPDO2_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of TPDO2, counted from the lowest of byte 0. */
enum {
    /* 3064, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3064 = 0,
    /* 3065, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3065 = 1,
    /* 3066, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3066 = 2,
    /* 3067, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3067 = 3,
    /* 3068, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3068 = 4,
    /* 3069, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3069 = 5,
    /* 3070, 2000h:5; governor ErrCanBus; gateway ErrCanBus1; 1: the error is present */
    GW12_TPDO2_BIT_ErrCanBus = 6,
    /* 3071, 2000h:5; governor ErrCanComm; gateway ErrCanComm1; 1: the error is present */
    GW12_TPDO2_BIT_ErrCanComm = 7,
    /* 3072, 2000h:5; governor ErrCanBus2; gateway ErrCanBus2; 1: the error is present */
    GW12_TPDO2_BIT_ErrCanBus2 = 8,
    /* 3073, 2000h:5; governor ErrCanComm2; gateway ErrCanComm2; 1: the error is present */
    GW12_TPDO2_BIT_ErrCanComm2 = 9,
    /* 3074, 2000h:5; governor ErrCanOpen; gateway ErrCanOpen; 1: the error is present */
    GW12_TPDO2_BIT_ErrCanOpen = 10,
    /* 3075, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3075 = 11,
    /* 3076, 2000h:5; gateway ErrParamStore; 1: the error is present */
    GW12_TPDO2_BIT_ErrParamStore = 12,
    /* 3077, 2000h:5; gateway ErrProgramTest; 1: the error is present */
    GW12_TPDO2_BIT_ErrProgramTest = 13,
    /* 3078, 2000h:5; gateway ErrRAMTest; 1: the error is present */
    GW12_TPDO2_BIT_ErrRAMTest = 14,
    /* 3079, 2000h:5; 1: the error is present */
    GW12_TPDO2_BIT_Error_3079 = 15,
    /* 3080, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3080 = 16,
    /* 3081, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3081 = 17,
    /* 3082, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3082 = 18,
    /* 3083, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3083 = 19,
    /* 3084, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3084 = 20,
    /* 3085, 2000h:6; gateway ErrVoltage; 1: the error is present */
    GW12_TPDO2_BIT_ErrVoltage = 21,
    /* 3086, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3086 = 22,
    /* 3087, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3087 = 23,
    /* 3088, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3088 = 24,
    /* 3089, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3089 = 25,
    /* 3090, 2000h:6; gateway ErrData; 1: the error is present */
    GW12_TPDO2_BIT_ErrData = 26,
    /* 3091, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3091 = 27,
    /* 3092, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3092 = 28,
    /* 3093, 2000h:6; gateway ErrStack; 1: the error is present */
    GW12_TPDO2_BIT_ErrStack = 29,
    /* 3094, 2000h:6; gateway ErrIntern; 1: the error is present */
    GW12_TPDO2_BIT_ErrIntern = 30,
    /* 3095, 2000h:6; 1: the error is present */
    GW12_TPDO2_BIT_Error_3095 = 31
};
static inline int gw12_tpdo2_bit(const gw12_tpdo2 *pdo, unsigned bit)
{
    return bit / 8u < GW12_TPDO2_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}

/* TPDO3 (1802h, 1A02h), from the gateway: 2 bytes, sent when a bit changes */
#define GW12_TPDO3_COB_ID 0x38Cu
#define GW12_TPDO3_LENGTH 2u
#define GW12_TPDO3_CYCLE_US 0u

typedef struct { uint8_t bytes[2]; } gw12_tpdo3;
typedef char gw12_tpdo3_is_packed[sizeof(gw12_tpdo3) == 2u ? 1 : -1];
static inline int gw12_tpdo3_take(gw12_tpdo3 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_TPDO3_COB_ID || length < GW12_TPDO3_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_TPDO3_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of TPDO3, counted from the lowest of byte 0. */
enum {
    /* 2000h:7 bit 1; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit1 = 0,
    /* 2000h:7 bit 2; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit2 = 1,
    /* 2000h:7 bit 3; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit3 = 2,
    /* 2000h:7 bit 4; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit4 = 3,
    /* 2000h:7 bit 5; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit5 = 4,
    /* 2000h:7 bit 6; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit6 = 5,
    /* 2000h:7 bit 7; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit7 = 6,
    /* 2000h:7 bit 8; its meaning depends on the governor and is not printed */
    GW12_TPDO3_BIT_EngineState_Bit8 = 7
};
static inline int gw12_tpdo3_bit(const gw12_tpdo3 *pdo, unsigned bit)
{
    return bit / 8u < GW12_TPDO3_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}

/* TPDO4 (1803h, 1A03h), from the gateway: 8 bytes, sent every 125 ms */
#define GW12_TPDO4_COB_ID 0x48Cu
#define GW12_TPDO4_LENGTH 8u
#define GW12_TPDO4_CYCLE_US 125000u

typedef struct { uint8_t bytes[8]; } gw12_tpdo4;
typedef char gw12_tpdo4_is_packed[sizeof(gw12_tpdo4) == 8u ? 1 : -1];
static inline int gw12_tpdo4_take(gw12_tpdo4 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_TPDO4_COB_ID || length < GW12_TPDO4_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_TPDO4_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Speed: 2000 Speed, 2001h:1; 0..65535 is 0..4000 1/min */
#define GW12_TPDO4_BYTE_Speed 0u
#define GW12_TPDO4_RAWMIN_Speed 0
#define GW12_TPDO4_RAWMAX_Speed 65535
#define GW12_TPDO4_UNIT_Speed "1/min"
#define GW12_TPDO4_FACTOR_Speed 0.061036087586785685
#define GW12_TPDO4_OFFSET_Speed 0.0
#define GW12_TPDO4_MIN_Speed 0.0
#define GW12_TPDO4_MAX_Speed 4000.0
static inline int32_t gw12_tpdo4_raw_Speed(const gw12_tpdo4 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO4_BYTE_Speed);
}
static inline double gw12_tpdo4_value_Speed(const gw12_tpdo4 *pdo)
{
    return (double)gw12_tpdo4_raw_Speed(pdo) * GW12_TPDO4_FACTOR_Speed + GW12_TPDO4_OFFSET_Speed;
}

/* SpeedSetp: 2031 SpeedSetp, 2001h:2; 0..65535 is 0..4000 1/min */
#define GW12_TPDO4_BYTE_SpeedSetp 2u
#define GW12_TPDO4_RAWMIN_SpeedSetp 0
#define GW12_TPDO4_RAWMAX_SpeedSetp 65535
#define GW12_TPDO4_UNIT_SpeedSetp "1/min"
#define GW12_TPDO4_FACTOR_SpeedSetp 0.061036087586785685
#define GW12_TPDO4_OFFSET_SpeedSetp 0.0
#define GW12_TPDO4_MIN_SpeedSetp 0.0
#define GW12_TPDO4_MAX_SpeedSetp 4000.0
static inline int32_t gw12_tpdo4_raw_SpeedSetp(const gw12_tpdo4 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO4_BYTE_SpeedSetp);
}
static inline double gw12_tpdo4_value_SpeedSetp(const gw12_tpdo4 *pdo)
{
    return (double)gw12_tpdo4_raw_SpeedSetp(pdo) * GW12_TPDO4_FACTOR_SpeedSetp + GW12_TPDO4_OFFSET_SpeedSetp;
}

/* ActPos: 2300 ActPos, 2001h:3; 0..65535 is 0..100 % */
#define GW12_TPDO4_BYTE_ActPos 4u
#define GW12_TPDO4_RAWMIN_ActPos 0
#define GW12_TPDO4_RAWMAX_ActPos 65535
#define GW12_TPDO4_UNIT_ActPos "%"
#define GW12_TPDO4_FACTOR_ActPos 0.0015259021896696422
#define GW12_TPDO4_OFFSET_ActPos 0.0
#define GW12_TPDO4_MIN_ActPos 0.0
#define GW12_TPDO4_MAX_ActPos 100.0
static inline int32_t gw12_tpdo4_raw_ActPos(const gw12_tpdo4 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO4_BYTE_ActPos);
}
static inline double gw12_tpdo4_value_ActPos(const gw12_tpdo4 *pdo)
{
    return (double)gw12_tpdo4_raw_ActPos(pdo) * GW12_TPDO4_FACTOR_ActPos + GW12_TPDO4_OFFSET_ActPos;
}

/* MeasuredPower: 2918 MeasuredPower, 2001h:4; 0..65535 is 0..1250 kW */
#define GW12_TPDO4_BYTE_MeasuredPower 6u
#define GW12_TPDO4_RAWMIN_MeasuredPower 0
#define GW12_TPDO4_RAWMAX_MeasuredPower 65535
#define GW12_TPDO4_UNIT_MeasuredPower "kW"
#define GW12_TPDO4_FACTOR_MeasuredPower 0.01907377737087053
#define GW12_TPDO4_OFFSET_MeasuredPower 0.0
#define GW12_TPDO4_MIN_MeasuredPower 0.0
#define GW12_TPDO4_MAX_MeasuredPower 1250.0
static inline int32_t gw12_tpdo4_raw_MeasuredPower(const gw12_tpdo4 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO4_BYTE_MeasuredPower);
}
static inline double gw12_tpdo4_value_MeasuredPower(const gw12_tpdo4 *pdo)
{
    return (double)gw12_tpdo4_raw_MeasuredPower(pdo) * GW12_TPDO4_FACTOR_MeasuredPower + GW12_TPDO4_OFFSET_MeasuredPower;
}

/* TPDO5 (1804h, 1A04h), from the gateway: 8 bytes, sent every 500 ms */
#define GW12_TPDO5_COB_ID 0x680u
#define GW12_TPDO5_LENGTH 8u
#define GW12_TPDO5_CYCLE_US 500000u

typedef struct { uint8_t bytes[8]; } gw12_tpdo5;
typedef char gw12_tpdo5_is_packed[sizeof(gw12_tpdo5) == 8u ? 1 : -1];
static inline int gw12_tpdo5_take(gw12_tpdo5 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_TPDO5_COB_ID || length < GW12_TPDO5_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_TPDO5_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* BoostPressure: 2904 BoostPressure, 2001h:5; 0..65535 is 0..4 bar */
#define GW12_TPDO5_BYTE_BoostPressure 0u
#define GW12_TPDO5_RAWMIN_BoostPressure 0
#define GW12_TPDO5_RAWMAX_BoostPressure 65535
#define GW12_TPDO5_UNIT_BoostPressure "bar"
#define GW12_TPDO5_FACTOR_BoostPressure 6.103608758678569e-05
#define GW12_TPDO5_OFFSET_BoostPressure 0.0
#define GW12_TPDO5_MIN_BoostPressure 0.0
#define GW12_TPDO5_MAX_BoostPressure 4.0
static inline int32_t gw12_tpdo5_raw_BoostPressure(const gw12_tpdo5 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO5_BYTE_BoostPressure);
}
static inline double gw12_tpdo5_value_BoostPressure(const gw12_tpdo5 *pdo)
{
    return (double)gw12_tpdo5_raw_BoostPressure(pdo) * GW12_TPDO5_FACTOR_BoostPressure + GW12_TPDO5_OFFSET_BoostPressure;
}

/* OilPressure: 2905 OilPressure, 2001h:6; 0..65535 is 0..10 bar */
#define GW12_TPDO5_BYTE_OilPressure 2u
#define GW12_TPDO5_RAWMIN_OilPressure 0
#define GW12_TPDO5_RAWMAX_OilPressure 65535
#define GW12_TPDO5_UNIT_OilPressure "bar"
#define GW12_TPDO5_FACTOR_OilPressure 0.00015259021896696422
#define GW12_TPDO5_OFFSET_OilPressure 0.0
#define GW12_TPDO5_MIN_OilPressure 0.0
#define GW12_TPDO5_MAX_OilPressure 10.0
static inline int32_t gw12_tpdo5_raw_OilPressure(const gw12_tpdo5 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO5_BYTE_OilPressure);
}
static inline double gw12_tpdo5_value_OilPressure(const gw12_tpdo5 *pdo)
{
    return (double)gw12_tpdo5_raw_OilPressure(pdo) * GW12_TPDO5_FACTOR_OilPressure + GW12_TPDO5_OFFSET_OilPressure;
}

/* AmbientPressure: 2906 AmbientPressure, 2001h:7; 0..65535 is 500..1200 mbar */
#define GW12_TPDO5_BYTE_AmbientPressure 4u
#define GW12_TPDO5_RAWMIN_AmbientPressure 0
#define GW12_TPDO5_RAWMAX_AmbientPressure 65535
#define GW12_TPDO5_UNIT_AmbientPressure "mbar"
#define GW12_TPDO5_FACTOR_AmbientPressure 0.010681315327687495
#define GW12_TPDO5_OFFSET_AmbientPressure 500.0
#define GW12_TPDO5_MIN_AmbientPressure 500.0
#define GW12_TPDO5_MAX_AmbientPressure 1200.0
static inline int32_t gw12_tpdo5_raw_AmbientPressure(const gw12_tpdo5 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO5_BYTE_AmbientPressure);
}
static inline double gw12_tpdo5_value_AmbientPressure(const gw12_tpdo5 *pdo)
{
    return (double)gw12_tpdo5_raw_AmbientPressure(pdo) * GW12_TPDO5_FACTOR_AmbientPressure + GW12_TPDO5_OFFSET_AmbientPressure;
}

/* CoolantPressure: 2916 CoolantPressure, 2001h:8; 0..65535 is 0..5 bar */
#define GW12_TPDO5_BYTE_CoolantPressure 6u
#define GW12_TPDO5_RAWMIN_CoolantPressure 0
#define GW12_TPDO5_RAWMAX_CoolantPressure 65535
#define GW12_TPDO5_UNIT_CoolantPressure "bar"
#define GW12_TPDO5_FACTOR_CoolantPressure 7.629510948348211e-05
#define GW12_TPDO5_OFFSET_CoolantPressure 0.0
#define GW12_TPDO5_MIN_CoolantPressure 0.0
#define GW12_TPDO5_MAX_CoolantPressure 5.0
static inline int32_t gw12_tpdo5_raw_CoolantPressure(const gw12_tpdo5 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO5_BYTE_CoolantPressure);
}
static inline double gw12_tpdo5_value_CoolantPressure(const gw12_tpdo5 *pdo)
{
    return (double)gw12_tpdo5_raw_CoolantPressure(pdo) * GW12_TPDO5_FACTOR_CoolantPressure + GW12_TPDO5_OFFSET_CoolantPressure;
}

/* TPDO6 (1805h, 1A05h), from the gateway: 8 bytes, sent every 1000 ms */
#define GW12_TPDO6_COB_ID 0x681u
#define GW12_TPDO6_LENGTH 8u
#define GW12_TPDO6_CYCLE_US 1000000u

typedef struct { uint8_t bytes[8]; } gw12_tpdo6;
typedef char gw12_tpdo6_is_packed[sizeof(gw12_tpdo6) == 8u ? 1 : -1];
static inline int gw12_tpdo6_take(gw12_tpdo6 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_TPDO6_COB_ID || length < GW12_TPDO6_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_TPDO6_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* CoolantTemp: 2907 CoolantTemp, 2001h:9; 0..65535 is -100..1000 degC */
#define GW12_TPDO6_BYTE_CoolantTemp 0u
#define GW12_TPDO6_RAWMIN_CoolantTemp 0
#define GW12_TPDO6_RAWMAX_CoolantTemp 65535
#define GW12_TPDO6_UNIT_CoolantTemp "\302\260C"
#define GW12_TPDO6_FACTOR_CoolantTemp 0.016784924086366063
#define GW12_TPDO6_OFFSET_CoolantTemp (-100.0)
#define GW12_TPDO6_MIN_CoolantTemp (-100.0)
#define GW12_TPDO6_MAX_CoolantTemp 1000.0
static inline int32_t gw12_tpdo6_raw_CoolantTemp(const gw12_tpdo6 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO6_BYTE_CoolantTemp);
}
static inline double gw12_tpdo6_value_CoolantTemp(const gw12_tpdo6 *pdo)
{
    return (double)gw12_tpdo6_raw_CoolantTemp(pdo) * GW12_TPDO6_FACTOR_CoolantTemp + GW12_TPDO6_OFFSET_CoolantTemp;
}

/* ChargeAirTemp: 2908 ChargeAirTemp, 2001h:10; 0..65535 is -100..1000 degC */
#define GW12_TPDO6_BYTE_ChargeAirTemp 2u
#define GW12_TPDO6_RAWMIN_ChargeAirTemp 0
#define GW12_TPDO6_RAWMAX_ChargeAirTemp 65535
#define GW12_TPDO6_UNIT_ChargeAirTemp "\302\260C"
#define GW12_TPDO6_FACTOR_ChargeAirTemp 0.016784924086366063
#define GW12_TPDO6_OFFSET_ChargeAirTemp (-100.0)
#define GW12_TPDO6_MIN_ChargeAirTemp (-100.0)
#define GW12_TPDO6_MAX_ChargeAirTemp 1000.0
static inline int32_t gw12_tpdo6_raw_ChargeAirTemp(const gw12_tpdo6 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO6_BYTE_ChargeAirTemp);
}
static inline double gw12_tpdo6_value_ChargeAirTemp(const gw12_tpdo6 *pdo)
{
    return (double)gw12_tpdo6_raw_ChargeAirTemp(pdo) * GW12_TPDO6_FACTOR_ChargeAirTemp + GW12_TPDO6_OFFSET_ChargeAirTemp;
}

/* OilTemp: 2909 OilTemp, 2001h:11; 0..65535 is -100..1000 degC */
#define GW12_TPDO6_BYTE_OilTemp 4u
#define GW12_TPDO6_RAWMIN_OilTemp 0
#define GW12_TPDO6_RAWMAX_OilTemp 65535
#define GW12_TPDO6_UNIT_OilTemp "\302\260C"
#define GW12_TPDO6_FACTOR_OilTemp 0.016784924086366063
#define GW12_TPDO6_OFFSET_OilTemp (-100.0)
#define GW12_TPDO6_MIN_OilTemp (-100.0)
#define GW12_TPDO6_MAX_OilTemp 1000.0
static inline int32_t gw12_tpdo6_raw_OilTemp(const gw12_tpdo6 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO6_BYTE_OilTemp);
}
static inline double gw12_tpdo6_value_OilTemp(const gw12_tpdo6 *pdo)
{
    return (double)gw12_tpdo6_raw_OilTemp(pdo) * GW12_TPDO6_FACTOR_OilTemp + GW12_TPDO6_OFFSET_OilTemp;
}

/* ExhaustTemp: 2911 ExhaustTemp, 2001h:12; 0..65535 is -100..1000 degC */
#define GW12_TPDO6_BYTE_ExhaustTemp 6u
#define GW12_TPDO6_RAWMIN_ExhaustTemp 0
#define GW12_TPDO6_RAWMAX_ExhaustTemp 65535
#define GW12_TPDO6_UNIT_ExhaustTemp "\302\260C"
#define GW12_TPDO6_FACTOR_ExhaustTemp 0.016784924086366063
#define GW12_TPDO6_OFFSET_ExhaustTemp (-100.0)
#define GW12_TPDO6_MIN_ExhaustTemp (-100.0)
#define GW12_TPDO6_MAX_ExhaustTemp 1000.0
static inline int32_t gw12_tpdo6_raw_ExhaustTemp(const gw12_tpdo6 *pdo)
{
    return gw12_word(pdo->bytes + GW12_TPDO6_BYTE_ExhaustTemp);
}
static inline double gw12_tpdo6_value_ExhaustTemp(const gw12_tpdo6 *pdo)
{
    return (double)gw12_tpdo6_raw_ExhaustTemp(pdo) * GW12_TPDO6_FACTOR_ExhaustTemp + GW12_TPDO6_OFFSET_ExhaustTemp;
}

/* RPDO1 (1400h, 1600h), to the gateway: 6 bytes, monitored for 500 ms */
#define GW12_RPDO1_COB_ID 0x20Cu
#define GW12_RPDO1_LENGTH 6u
#define GW12_RPDO1_MONITORING_US 500000u

typedef struct { uint8_t bytes[6]; } gw12_rpdo1;
typedef char gw12_rpdo1_is_packed[sizeof(gw12_rpdo1) == 6u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW12_RPDO1_REST { { 0x04, 0x00, 0x00, 0x00, 0x00, 0x00 } }
static inline int gw12_rpdo1_take(gw12_rpdo1 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_RPDO1_COB_ID || length < GW12_RPDO1_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_RPDO1_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of RPDO1, counted from the lowest of byte 0. */
enum {
    /* 2003h:1 bit 1; 811 FunctIdleSpeed, high-active: 1 is on */
    GW12_RPDO1_BIT_FunctIdleSpeed = 0,
    /* 2003h:1 bit 2; 827 FunctSetpoint2Or1, high-active: 1 is on */
    GW12_RPDO1_BIT_FunctSetpoint2Or1 = 1,
    /* 2003h:1 bit 3; 835 FunctLoadEnable, low-active: 0 is on */
    GW12_RPDO1_BIT_FunctLoadEnable = 2,
    /* 2003h:2 bit 1, error flag of channel 1: 900 AssignIn_Setp1Ext; 1: faulty */
    GW12_RPDO1_BIT_AssignIn_Setp1Ext_Error = 32,
    /* 2003h:2 bit 2, error flag of channel 2: 902; 1: faulty */
    GW12_RPDO1_BIT_Sensor_902_Error = 33,
    /* 2003h:2 bit 3, error flag of channel 3: 903; 1: faulty */
    GW12_RPDO1_BIT_Sensor_903_Error = 34,
    /* 2003h:2 bit 5, error flag of channel 5: 906 AssignIn_AmbPress; 1: faulty */
    GW12_RPDO1_BIT_AssignIn_AmbPress_Error = 36,
    /* 2003h:2 bit 6, error flag of channel 6: 910; 1: faulty */
    GW12_RPDO1_BIT_Sensor_910_Error = 37,
    /* 2003h:2 bit 9, error flag of channel 9: 917 AssignIn_CurrentLoad; 1: faulty */
    GW12_RPDO1_BIT_AssignIn_CurrentLoad_Error = 40
};
static inline int gw12_rpdo1_bit(const gw12_rpdo1 *pdo, unsigned bit)
{
    return bit / 8u < GW12_RPDO1_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}
static inline void gw12_rpdo1_putbit(gw12_rpdo1 *pdo, unsigned bit, int value)
{
    if (bit / 8u < GW12_RPDO1_LENGTH) {
        unsigned mask = 1u << (bit % 8u);
        unsigned rest = pdo->bytes[bit / 8u] & ~mask;
        pdo->bytes[bit / 8u] = (uint8_t)(value ? rest | mask : rest);
    }
}
static inline int gw12_rpdo1_ison_FunctIdleSpeed(const gw12_rpdo1 *pdo)
{
    return gw12_rpdo1_bit(pdo, 0u) == 1;
}
static inline void gw12_rpdo1_turn_FunctIdleSpeed(gw12_rpdo1 *pdo, int on)
{
    gw12_rpdo1_putbit(pdo, 0u, on ? 1 : 0);
}
static inline int gw12_rpdo1_ison_FunctSetpoint2Or1(const gw12_rpdo1 *pdo)
{
    return gw12_rpdo1_bit(pdo, 1u) == 1;
}
static inline void gw12_rpdo1_turn_FunctSetpoint2Or1(gw12_rpdo1 *pdo, int on)
{
    gw12_rpdo1_putbit(pdo, 1u, on ? 1 : 0);
}
static inline int gw12_rpdo1_ison_FunctLoadEnable(const gw12_rpdo1 *pdo)
{
    return gw12_rpdo1_bit(pdo, 2u) == 0;
}
static inline void gw12_rpdo1_turn_FunctLoadEnable(gw12_rpdo1 *pdo, int on)
{
    gw12_rpdo1_putbit(pdo, 2u, on ? 0 : 1);
}

/* RPDO2 (1401h, 1601h), to the gateway: 6 bytes, monitored for 500 ms */
#define GW12_RPDO2_COB_ID 0x30Cu
#define GW12_RPDO2_LENGTH 6u
#define GW12_RPDO2_MONITORING_US 500000u

typedef struct { uint8_t bytes[6]; } gw12_rpdo2;
typedef char gw12_rpdo2_is_packed[sizeof(gw12_rpdo2) == 6u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW12_RPDO2_REST { { 0x00, 0x00, 0x00, 0x00, 0x00, 0x00 } }
static inline int gw12_rpdo2_take(gw12_rpdo2 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_RPDO2_COB_ID || length < GW12_RPDO2_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_RPDO2_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* AssignIn_Setp1Ext: channel 1, 2004h:1: 900 AssignIn_Setp1Ext; shown by 2900 Setpoint1Extern; 0..65535 is 0..100 % */
#define GW12_RPDO2_BYTE_AssignIn_Setp1Ext 0u
#define GW12_RPDO2_RAWMIN_AssignIn_Setp1Ext 0
#define GW12_RPDO2_RAWMAX_AssignIn_Setp1Ext 65535
#define GW12_RPDO2_UNIT_AssignIn_Setp1Ext "%"
#define GW12_RPDO2_FACTOR_AssignIn_Setp1Ext 0.0015259021896696422
#define GW12_RPDO2_OFFSET_AssignIn_Setp1Ext 0.0
#define GW12_RPDO2_MIN_AssignIn_Setp1Ext 0.0
#define GW12_RPDO2_MAX_AssignIn_Setp1Ext 100.0
static inline int32_t gw12_rpdo2_raw_AssignIn_Setp1Ext(const gw12_rpdo2 *pdo)
{
    return gw12_word(pdo->bytes + GW12_RPDO2_BYTE_AssignIn_Setp1Ext);
}
static inline double gw12_rpdo2_value_AssignIn_Setp1Ext(const gw12_rpdo2 *pdo)
{
    return (double)gw12_rpdo2_raw_AssignIn_Setp1Ext(pdo) * GW12_RPDO2_FACTOR_AssignIn_Setp1Ext + GW12_RPDO2_OFFSET_AssignIn_Setp1Ext;
}
static inline void gw12_rpdo2_setraw_AssignIn_Setp1Ext(gw12_rpdo2 *pdo, int32_t raw)
{
    gw12_putword(pdo->bytes + GW12_RPDO2_BYTE_AssignIn_Setp1Ext, raw);
}
static inline int gw12_rpdo2_set_AssignIn_Setp1Ext(gw12_rpdo2 *pdo, double value)
{
    return gw12_putvalue(pdo->bytes + GW12_RPDO2_BYTE_AssignIn_Setp1Ext, value, GW12_RPDO2_FACTOR_AssignIn_Setp1Ext,
                          GW12_RPDO2_OFFSET_AssignIn_Setp1Ext, GW12_RPDO2_MIN_AssignIn_Setp1Ext, GW12_RPDO2_MAX_AssignIn_Setp1Ext, 0);
}

/* Sensor_902: channel 2, 2004h:2: 902; shown by 2902 LoadControlInput; 0..65535 is 0..100 % */
#define GW12_RPDO2_BYTE_Sensor_902 2u
#define GW12_RPDO2_RAWMIN_Sensor_902 0
#define GW12_RPDO2_RAWMAX_Sensor_902 65535
#define GW12_RPDO2_UNIT_Sensor_902 "%"
#define GW12_RPDO2_FACTOR_Sensor_902 0.0015259021896696422
#define GW12_RPDO2_OFFSET_Sensor_902 0.0
#define GW12_RPDO2_MIN_Sensor_902 0.0
#define GW12_RPDO2_MAX_Sensor_902 100.0
static inline int32_t gw12_rpdo2_raw_Sensor_902(const gw12_rpdo2 *pdo)
{
    return gw12_word(pdo->bytes + GW12_RPDO2_BYTE_Sensor_902);
}
static inline double gw12_rpdo2_value_Sensor_902(const gw12_rpdo2 *pdo)
{
    return (double)gw12_rpdo2_raw_Sensor_902(pdo) * GW12_RPDO2_FACTOR_Sensor_902 + GW12_RPDO2_OFFSET_Sensor_902;
}
static inline void gw12_rpdo2_setraw_Sensor_902(gw12_rpdo2 *pdo, int32_t raw)
{
    gw12_putword(pdo->bytes + GW12_RPDO2_BYTE_Sensor_902, raw);
}
static inline int gw12_rpdo2_set_Sensor_902(gw12_rpdo2 *pdo, double value)
{
    return gw12_putvalue(pdo->bytes + GW12_RPDO2_BYTE_Sensor_902, value, GW12_RPDO2_FACTOR_Sensor_902,
                          GW12_RPDO2_OFFSET_Sensor_902, GW12_RPDO2_MIN_Sensor_902, GW12_RPDO2_MAX_Sensor_902, 0);
}

/* Sensor_903: channel 3, 2004h:3: 903; shown by 2903 SyncInput; 0..65535 is 0..100 % */
#define GW12_RPDO2_BYTE_Sensor_903 4u
#define GW12_RPDO2_RAWMIN_Sensor_903 0
#define GW12_RPDO2_RAWMAX_Sensor_903 65535
#define GW12_RPDO2_UNIT_Sensor_903 "%"
#define GW12_RPDO2_FACTOR_Sensor_903 0.0015259021896696422
#define GW12_RPDO2_OFFSET_Sensor_903 0.0
#define GW12_RPDO2_MIN_Sensor_903 0.0
#define GW12_RPDO2_MAX_Sensor_903 100.0
static inline int32_t gw12_rpdo2_raw_Sensor_903(const gw12_rpdo2 *pdo)
{
    return gw12_word(pdo->bytes + GW12_RPDO2_BYTE_Sensor_903);
}
static inline double gw12_rpdo2_value_Sensor_903(const gw12_rpdo2 *pdo)
{
    return (double)gw12_rpdo2_raw_Sensor_903(pdo) * GW12_RPDO2_FACTOR_Sensor_903 + GW12_RPDO2_OFFSET_Sensor_903;
}
static inline void gw12_rpdo2_setraw_Sensor_903(gw12_rpdo2 *pdo, int32_t raw)
{
    gw12_putword(pdo->bytes + GW12_RPDO2_BYTE_Sensor_903, raw);
}
static inline int gw12_rpdo2_set_Sensor_903(gw12_rpdo2 *pdo, double value)
{
    return gw12_putvalue(pdo->bytes + GW12_RPDO2_BYTE_Sensor_903, value, GW12_RPDO2_FACTOR_Sensor_903,
                          GW12_RPDO2_OFFSET_Sensor_903, GW12_RPDO2_MIN_Sensor_903, GW12_RPDO2_MAX_Sensor_903, 0);
}

/* RPDO3 (1402h, 1602h), to the gateway: 4 bytes, monitored for 1000 ms */
#define GW12_RPDO3_COB_ID 0x40Cu
#define GW12_RPDO3_LENGTH 4u
#define GW12_RPDO3_MONITORING_US 1000000u

typedef struct { uint8_t bytes[4]; } gw12_rpdo3;
typedef char gw12_rpdo3_is_packed[sizeof(gw12_rpdo3) == 4u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW12_RPDO3_REST { { 0x00, 0x00, 0x00, 0x00 } }
static inline int gw12_rpdo3_take(gw12_rpdo3 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_RPDO3_COB_ID || length < GW12_RPDO3_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_RPDO3_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* AssignIn_AmbPress: channel 5, 2004h:5: 906 AssignIn_AmbPress; shown by 2906 AmbientPressure; 0..65535 is 500..1200 mbar */
#define GW12_RPDO3_BYTE_AssignIn_AmbPress 0u
#define GW12_RPDO3_RAWMIN_AssignIn_AmbPress 0
#define GW12_RPDO3_RAWMAX_AssignIn_AmbPress 65535
#define GW12_RPDO3_UNIT_AssignIn_AmbPress "mbar"
#define GW12_RPDO3_FACTOR_AssignIn_AmbPress 0.010681315327687495
#define GW12_RPDO3_OFFSET_AssignIn_AmbPress 500.0
#define GW12_RPDO3_MIN_AssignIn_AmbPress 500.0
#define GW12_RPDO3_MAX_AssignIn_AmbPress 1200.0
static inline int32_t gw12_rpdo3_raw_AssignIn_AmbPress(const gw12_rpdo3 *pdo)
{
    return gw12_word(pdo->bytes + GW12_RPDO3_BYTE_AssignIn_AmbPress);
}
static inline double gw12_rpdo3_value_AssignIn_AmbPress(const gw12_rpdo3 *pdo)
{
    return (double)gw12_rpdo3_raw_AssignIn_AmbPress(pdo) * GW12_RPDO3_FACTOR_AssignIn_AmbPress + GW12_RPDO3_OFFSET_AssignIn_AmbPress;
}
static inline void gw12_rpdo3_setraw_AssignIn_AmbPress(gw12_rpdo3 *pdo, int32_t raw)
{
    gw12_putword(pdo->bytes + GW12_RPDO3_BYTE_AssignIn_AmbPress, raw);
}
static inline int gw12_rpdo3_set_AssignIn_AmbPress(gw12_rpdo3 *pdo, double value)
{
    return gw12_putvalue(pdo->bytes + GW12_RPDO3_BYTE_AssignIn_AmbPress, value, GW12_RPDO3_FACTOR_AssignIn_AmbPress,
                          GW12_RPDO3_OFFSET_AssignIn_AmbPress, GW12_RPDO3_MIN_AssignIn_AmbPress, GW12_RPDO3_MAX_AssignIn_AmbPress, 0);
}

/* Sensor_910: channel 6, 2004h:6: 910; shown by 2910 FuelTemp; 0..65535 is -100..1000 degC */
#define GW12_RPDO3_BYTE_Sensor_910 2u
#define GW12_RPDO3_RAWMIN_Sensor_910 0
#define GW12_RPDO3_RAWMAX_Sensor_910 65535
#define GW12_RPDO3_UNIT_Sensor_910 "\302\260C"
#define GW12_RPDO3_FACTOR_Sensor_910 0.016784924086366063
#define GW12_RPDO3_OFFSET_Sensor_910 (-100.0)
#define GW12_RPDO3_MIN_Sensor_910 (-100.0)
#define GW12_RPDO3_MAX_Sensor_910 1000.0
static inline int32_t gw12_rpdo3_raw_Sensor_910(const gw12_rpdo3 *pdo)
{
    return gw12_word(pdo->bytes + GW12_RPDO3_BYTE_Sensor_910);
}
static inline double gw12_rpdo3_value_Sensor_910(const gw12_rpdo3 *pdo)
{
    return (double)gw12_rpdo3_raw_Sensor_910(pdo) * GW12_RPDO3_FACTOR_Sensor_910 + GW12_RPDO3_OFFSET_Sensor_910;
}
static inline void gw12_rpdo3_setraw_Sensor_910(gw12_rpdo3 *pdo, int32_t raw)
{
    gw12_putword(pdo->bytes + GW12_RPDO3_BYTE_Sensor_910, raw);
}
static inline int gw12_rpdo3_set_Sensor_910(gw12_rpdo3 *pdo, double value)
{
    return gw12_putvalue(pdo->bytes + GW12_RPDO3_BYTE_Sensor_910, value, GW12_RPDO3_FACTOR_Sensor_910,
                          GW12_RPDO3_OFFSET_Sensor_910, GW12_RPDO3_MIN_Sensor_910, GW12_RPDO3_MAX_Sensor_910, 0);
}

/* RPDO4 (1403h, 1603h), to the gateway: 2 bytes, monitored for 1000 ms */
#define GW12_RPDO4_COB_ID 0x50Cu
#define GW12_RPDO4_LENGTH 2u
#define GW12_RPDO4_MONITORING_US 1000000u

typedef struct { uint8_t bytes[2]; } gw12_rpdo4;
typedef char gw12_rpdo4_is_packed[sizeof(gw12_rpdo4) == 2u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW12_RPDO4_REST { { 0x00, 0x00 } }
static inline int gw12_rpdo4_take(gw12_rpdo4 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW12_RPDO4_COB_ID || length < GW12_RPDO4_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW12_RPDO4_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* AssignIn_CurrentLoad: channel 9, 2004h:9: 917 AssignIn_CurrentLoad; shown by 2917 CurrentLoad; scaling not known */
#define GW12_RPDO4_BYTE_AssignIn_CurrentLoad 0u
#define GW12_RPDO4_RAWMIN_AssignIn_CurrentLoad 0
#define GW12_RPDO4_RAWMAX_AssignIn_CurrentLoad 65535
static inline int32_t gw12_rpdo4_raw_AssignIn_CurrentLoad(const gw12_rpdo4 *pdo)
{
    return gw12_word(pdo->bytes + GW12_RPDO4_BYTE_AssignIn_CurrentLoad);
}
static inline void gw12_rpdo4_setraw_AssignIn_CurrentLoad(gw12_rpdo4 *pdo, int32_t raw)
{
    gw12_putword(pdo->bytes + GW12_RPDO4_BYTE_AssignIn_CurrentLoad, raw);
}

#endif
