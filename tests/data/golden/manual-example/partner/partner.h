/* What the partner of gateway node 1 on the CANopen bus reads and sends. For C99 and C++.
   Written by cgw 0.1.0; do not edit.
   title:            Manual DG 04005-e, chapter 7
   configuration id: fc3c3f77f44acea1

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

#define GW1_CONFIGURATION_ID "fc3c3f77f44acea1"
#define GW1_NODE_ID 1u
#define GW1_PARTNER_NODE_ID 127u    /* 0: none */
#define GW1_BIT_RATE 125000u
#define GW1_HEARTBEAT_COB_ID 0x701u
#define GW1_HEARTBEAT_US 992000u            /* time between two; 0: the gateway sends none */
#define GW1_PARTNER_HEARTBEAT_US 96000u    /* longest time between two of the partner's; 0: any */
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

/* TPDO1 (1800h, 1A00h), from the gateway: 8 bytes, sent when a bit changes */
#define GW1_TPDO1_COB_ID 0x181u
#define GW1_TPDO1_LENGTH 8u
#define GW1_TPDO1_CYCLE_US 0u

typedef struct { uint8_t bytes[8]; } gw1_tpdo1;
typedef char gw1_tpdo1_is_packed[sizeof(gw1_tpdo1) == 8u ? 1 : -1];
static inline int gw1_tpdo1_take(gw1_tpdo1 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_TPDO1_COB_ID || length < GW1_TPDO1_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_TPDO1_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of TPDO1, counted from the lowest of byte 0. */
enum {
    /* 3000, 2000h:1; governor ConfigurationError; 1: the error is present */
    GW1_TPDO1_BIT_ConfigurationError = 0,
    /* 3001, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3001 = 1,
    /* 3002, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3002 = 2,
    /* 3003, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3003 = 3,
    /* 3004, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3004 = 4,
    /* 3005, 2000h:1; governor ErrSetpointExtern; 1: the error is present */
    GW1_TPDO1_BIT_ErrSetpointExtern = 5,
    /* 3006, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3006 = 6,
    /* 3007, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3007 = 7,
    /* 3008, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3008 = 8,
    /* 3009, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3009 = 9,
    /* 3010, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3010 = 10,
    /* 3011, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3011 = 11,
    /* 3012, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3012 = 12,
    /* 3013, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3013 = 13,
    /* 3014, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3014 = 14,
    /* 3015, 2000h:1; 1: the error is present */
    GW1_TPDO1_BIT_Error_3015 = 15,
    /* 3016, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3016 = 16,
    /* 3017, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3017 = 17,
    /* 3018, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3018 = 18,
    /* 3019, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3019 = 19,
    /* 3020, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3020 = 20,
    /* 3021, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3021 = 21,
    /* 3022, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3022 = 22,
    /* 3023, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3023 = 23,
    /* 3024, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3024 = 24,
    /* 3025, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3025 = 25,
    /* 3026, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3026 = 26,
    /* 3027, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3027 = 27,
    /* 3028, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3028 = 28,
    /* 3029, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3029 = 29,
    /* 3030, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3030 = 30,
    /* 3031, 2000h:2; 1: the error is present */
    GW1_TPDO1_BIT_Error_3031 = 31,
    /* 3032, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3032 = 32,
    /* 3033, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3033 = 33,
    /* 3034, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3034 = 34,
    /* 3035, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3035 = 35,
    /* 3036, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3036 = 36,
    /* 3037, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3037 = 37,
    /* 3038, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3038 = 38,
    /* 3039, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3039 = 39,
    /* 3040, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3040 = 40,
    /* 3041, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3041 = 41,
    /* 3042, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3042 = 42,
    /* 3043, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3043 = 43,
    /* 3044, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3044 = 44,
    /* 3045, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3045 = 45,
    /* 3046, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3046 = 46,
    /* 3047, 2000h:3; 1: the error is present */
    GW1_TPDO1_BIT_Error_3047 = 47,
    /* 3048, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3048 = 48,
    /* 3049, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3049 = 49,
    /* 3050, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3050 = 50,
    /* 3051, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3051 = 51,
    /* 3052, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3052 = 52,
    /* 3053, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3053 = 53,
    /* 3054, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3054 = 54,
    /* 3055, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3055 = 55,
    /* 3056, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3056 = 56,
    /* 3057, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3057 = 57,
    /* 3058, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3058 = 58,
    /* 3059, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3059 = 59,
    /* 3060, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3060 = 60,
    /* 3061, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3061 = 61,
    /* 3062, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3062 = 62,
    /* 3063, 2000h:4; 1: the error is present */
    GW1_TPDO1_BIT_Error_3063 = 63
};
static inline int gw1_tpdo1_bit(const gw1_tpdo1 *pdo, unsigned bit)
{
    return bit / 8u < GW1_TPDO1_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}

/* TPDO2 (1801h, 1A01h), from the gateway: 4 bytes, sent when a bit changes */
#define GW1_TPDO2_COB_ID 0x281u
#define GW1_TPDO2_LENGTH 4u
#define GW1_TPDO2_CYCLE_US 0u

typedef struct { uint8_t bytes[4]; } gw1_tpdo2;
typedef char gw1_tpdo2_is_packed[sizeof(gw1_tpdo2) == 4u ? 1 : -1];
static inline int gw1_tpdo2_take(gw1_tpdo2 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_TPDO2_COB_ID || length < GW1_TPDO2_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_TPDO2_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of TPDO2, counted from the lowest of byte 0. */
enum {
    /* 3064, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3064 = 0,
    /* 3065, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3065 = 1,
    /* 3066, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3066 = 2,
    /* 3067, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3067 = 3,
    /* 3068, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3068 = 4,
    /* 3069, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3069 = 5,
    /* 3070, 2000h:5; governor ErrCanBus; gateway ErrCanBus1; 1: the error is present */
    GW1_TPDO2_BIT_ErrCanBus = 6,
    /* 3071, 2000h:5; governor ErrCanComm; gateway ErrCanComm1; 1: the error is present */
    GW1_TPDO2_BIT_ErrCanComm = 7,
    /* 3072, 2000h:5; governor ErrCanBus2; gateway ErrCanBus2; 1: the error is present */
    GW1_TPDO2_BIT_ErrCanBus2 = 8,
    /* 3073, 2000h:5; governor ErrCanComm2; gateway ErrCanComm2; 1: the error is present */
    GW1_TPDO2_BIT_ErrCanComm2 = 9,
    /* 3074, 2000h:5; governor ErrCanOpen; gateway ErrCanOpen; 1: the error is present */
    GW1_TPDO2_BIT_ErrCanOpen = 10,
    /* 3075, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3075 = 11,
    /* 3076, 2000h:5; gateway ErrParamStore; 1: the error is present */
    GW1_TPDO2_BIT_ErrParamStore = 12,
    /* 3077, 2000h:5; gateway ErrProgramTest; 1: the error is present */
    GW1_TPDO2_BIT_ErrProgramTest = 13,
    /* 3078, 2000h:5; gateway ErrRAMTest; 1: the error is present */
    GW1_TPDO2_BIT_ErrRAMTest = 14,
    /* 3079, 2000h:5; 1: the error is present */
    GW1_TPDO2_BIT_Error_3079 = 15,
    /* 3080, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3080 = 16,
    /* 3081, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3081 = 17,
    /* 3082, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3082 = 18,
    /* 3083, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3083 = 19,
    /* 3084, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3084 = 20,
    /* 3085, 2000h:6; gateway ErrVoltage; 1: the error is present */
    GW1_TPDO2_BIT_ErrVoltage = 21,
    /* 3086, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3086 = 22,
    /* 3087, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3087 = 23,
    /* 3088, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3088 = 24,
    /* 3089, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3089 = 25,
    /* 3090, 2000h:6; gateway ErrData; 1: the error is present */
    GW1_TPDO2_BIT_ErrData = 26,
    /* 3091, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3091 = 27,
    /* 3092, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3092 = 28,
    /* 3093, 2000h:6; gateway ErrStack; 1: the error is present */
    GW1_TPDO2_BIT_ErrStack = 29,
    /* 3094, 2000h:6; gateway ErrIntern; 1: the error is present */
    GW1_TPDO2_BIT_ErrIntern = 30,
    /* 3095, 2000h:6; 1: the error is present */
    GW1_TPDO2_BIT_Error_3095 = 31
};
static inline int gw1_tpdo2_bit(const gw1_tpdo2 *pdo, unsigned bit)
{
    return bit / 8u < GW1_TPDO2_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}

/* TPDO4 (1803h, 1A03h), from the gateway: 8 bytes, sent every 15.625 ms */
#define GW1_TPDO4_COB_ID 0x481u
#define GW1_TPDO4_LENGTH 8u
#define GW1_TPDO4_CYCLE_US 15625u

typedef struct { uint8_t bytes[8]; } gw1_tpdo4;
typedef char gw1_tpdo4_is_packed[sizeof(gw1_tpdo4) == 8u ? 1 : -1];
static inline int gw1_tpdo4_take(gw1_tpdo4 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_TPDO4_COB_ID || length < GW1_TPDO4_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_TPDO4_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Speed: 2000 Speed, 2001h:1; 0..65535 is 0..4000 1/min */
#define GW1_TPDO4_BYTE_Speed 0u
#define GW1_TPDO4_RAWMIN_Speed 0
#define GW1_TPDO4_RAWMAX_Speed 65535
#define GW1_TPDO4_UNIT_Speed "1/min"
#define GW1_TPDO4_FACTOR_Speed 0.061036087586785685
#define GW1_TPDO4_OFFSET_Speed 0.0
#define GW1_TPDO4_MIN_Speed 0.0
#define GW1_TPDO4_MAX_Speed 4000.0
static inline int32_t gw1_tpdo4_raw_Speed(const gw1_tpdo4 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO4_BYTE_Speed);
}
static inline double gw1_tpdo4_value_Speed(const gw1_tpdo4 *pdo)
{
    return (double)gw1_tpdo4_raw_Speed(pdo) * GW1_TPDO4_FACTOR_Speed + GW1_TPDO4_OFFSET_Speed;
}

/* SpeedSetp: 2031 SpeedSetp, 2001h:2; 0..65535 is 0..4000 1/min */
#define GW1_TPDO4_BYTE_SpeedSetp 2u
#define GW1_TPDO4_RAWMIN_SpeedSetp 0
#define GW1_TPDO4_RAWMAX_SpeedSetp 65535
#define GW1_TPDO4_UNIT_SpeedSetp "1/min"
#define GW1_TPDO4_FACTOR_SpeedSetp 0.061036087586785685
#define GW1_TPDO4_OFFSET_SpeedSetp 0.0
#define GW1_TPDO4_MIN_SpeedSetp 0.0
#define GW1_TPDO4_MAX_SpeedSetp 4000.0
static inline int32_t gw1_tpdo4_raw_SpeedSetp(const gw1_tpdo4 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO4_BYTE_SpeedSetp);
}
static inline double gw1_tpdo4_value_SpeedSetp(const gw1_tpdo4 *pdo)
{
    return (double)gw1_tpdo4_raw_SpeedSetp(pdo) * GW1_TPDO4_FACTOR_SpeedSetp + GW1_TPDO4_OFFSET_SpeedSetp;
}

/* ActPos: 2300 ActPos, 2001h:3; 0..65535 is 0..100 % */
#define GW1_TPDO4_BYTE_ActPos 4u
#define GW1_TPDO4_RAWMIN_ActPos 0
#define GW1_TPDO4_RAWMAX_ActPos 65535
#define GW1_TPDO4_UNIT_ActPos "%"
#define GW1_TPDO4_FACTOR_ActPos 0.0015259021896696422
#define GW1_TPDO4_OFFSET_ActPos 0.0
#define GW1_TPDO4_MIN_ActPos 0.0
#define GW1_TPDO4_MAX_ActPos 100.0
static inline int32_t gw1_tpdo4_raw_ActPos(const gw1_tpdo4 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO4_BYTE_ActPos);
}
static inline double gw1_tpdo4_value_ActPos(const gw1_tpdo4 *pdo)
{
    return (double)gw1_tpdo4_raw_ActPos(pdo) * GW1_TPDO4_FACTOR_ActPos + GW1_TPDO4_OFFSET_ActPos;
}

/* ActPosSetpoint: 2330 ActPosSetpoint, 2001h:4; scaling not known */
#define GW1_TPDO4_BYTE_ActPosSetpoint 6u
#define GW1_TPDO4_RAWMIN_ActPosSetpoint 0
#define GW1_TPDO4_RAWMAX_ActPosSetpoint 65535
static inline int32_t gw1_tpdo4_raw_ActPosSetpoint(const gw1_tpdo4 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO4_BYTE_ActPosSetpoint);
}

/* TPDO16 (180Fh, 1A0Fh), from the gateway: 6 bytes, sent every 93.75 ms */
#define GW1_TPDO16_COB_ID 0x57Fu
#define GW1_TPDO16_LENGTH 6u
#define GW1_TPDO16_CYCLE_US 93750u

typedef struct { uint8_t bytes[6]; } gw1_tpdo16;
typedef char gw1_tpdo16_is_packed[sizeof(gw1_tpdo16) == 6u ? 1 : -1];
static inline int gw1_tpdo16_take(gw1_tpdo16 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_TPDO16_COB_ID || length < GW1_TPDO16_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_TPDO16_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* OilPressure: 2905 OilPressure, 2001h:5; scaling not known */
#define GW1_TPDO16_BYTE_OilPressure 0u
#define GW1_TPDO16_RAWMIN_OilPressure 0
#define GW1_TPDO16_RAWMAX_OilPressure 65535
static inline int32_t gw1_tpdo16_raw_OilPressure(const gw1_tpdo16 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO16_BYTE_OilPressure);
}

/* ChargeAirTemp: 2908 ChargeAirTemp, 2001h:6; 0..65535 is -100..1000 degC */
#define GW1_TPDO16_BYTE_ChargeAirTemp 2u
#define GW1_TPDO16_RAWMIN_ChargeAirTemp 0
#define GW1_TPDO16_RAWMAX_ChargeAirTemp 65535
#define GW1_TPDO16_UNIT_ChargeAirTemp "\302\260C"
#define GW1_TPDO16_FACTOR_ChargeAirTemp 0.016784924086366063
#define GW1_TPDO16_OFFSET_ChargeAirTemp (-100.0)
#define GW1_TPDO16_MIN_ChargeAirTemp (-100.0)
#define GW1_TPDO16_MAX_ChargeAirTemp 1000.0
static inline int32_t gw1_tpdo16_raw_ChargeAirTemp(const gw1_tpdo16 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO16_BYTE_ChargeAirTemp);
}
static inline double gw1_tpdo16_value_ChargeAirTemp(const gw1_tpdo16 *pdo)
{
    return (double)gw1_tpdo16_raw_ChargeAirTemp(pdo) * GW1_TPDO16_FACTOR_ChargeAirTemp + GW1_TPDO16_OFFSET_ChargeAirTemp;
}

/* CurrentLoad: 2917 CurrentLoad, 2001h:7; scaling not known */
#define GW1_TPDO16_BYTE_CurrentLoad 4u
#define GW1_TPDO16_RAWMIN_CurrentLoad 0
#define GW1_TPDO16_RAWMAX_CurrentLoad 65535
static inline int32_t gw1_tpdo16_raw_CurrentLoad(const gw1_tpdo16 *pdo)
{
    return gw1_word(pdo->bytes + GW1_TPDO16_BYTE_CurrentLoad);
}

/* RPDO1 (1400h, 1600h), to the gateway: 6 bytes, not monitored */
#define GW1_RPDO1_COB_ID 0x201u
#define GW1_RPDO1_LENGTH 6u
#define GW1_RPDO1_MONITORING_US 0u

typedef struct { uint8_t bytes[6]; } gw1_rpdo1;
typedef char gw1_rpdo1_is_packed[sizeof(gw1_rpdo1) == 6u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW1_RPDO1_REST { { 0x10, 0x00, 0x00, 0x00, 0x00, 0x00 } }
static inline int gw1_rpdo1_take(gw1_rpdo1 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_RPDO1_COB_ID || length < GW1_RPDO1_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_RPDO1_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* Bits of RPDO1, counted from the lowest of byte 0. */
enum {
    /* 2003h:1 bit 1; 827 FunctSetpoint2Or1, high-active: 1 is on */
    GW1_RPDO1_BIT_FunctSetpoint2Or1 = 0,
    /* 2003h:1 bit 5; 835 FunctLoadEnable, low-active: 0 is on */
    GW1_RPDO1_BIT_FunctLoadEnable = 4,
    /* 2003h:2 bit 1, error flag of channel 1: 900 AssignIn_Setp1Ext; 1: faulty */
    GW1_RPDO1_BIT_AssignIn_Setp1Ext_Error = 32,
    /* 2003h:2 bit 2, error flag of channel 2: 901 AssignIn_Setp2Ext; 1: faulty */
    GW1_RPDO1_BIT_AssignIn_Setp2Ext_Error = 33,
    /* 2003h:2 bit 7, error flag of channel 7: 906 AssignIn_AmbPress; 1: faulty */
    GW1_RPDO1_BIT_AssignIn_AmbPress_Error = 38,
    /* 2003h:2 bit 12, error flag of channel 12: 917 AssignIn_CurrentLoad; 1: faulty */
    GW1_RPDO1_BIT_AssignIn_CurrentLoad_Error = 43
};
static inline int gw1_rpdo1_bit(const gw1_rpdo1 *pdo, unsigned bit)
{
    return bit / 8u < GW1_RPDO1_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;
}
static inline void gw1_rpdo1_putbit(gw1_rpdo1 *pdo, unsigned bit, int value)
{
    if (bit / 8u < GW1_RPDO1_LENGTH) {
        unsigned mask = 1u << (bit % 8u);
        unsigned rest = pdo->bytes[bit / 8u] & ~mask;
        pdo->bytes[bit / 8u] = (uint8_t)(value ? rest | mask : rest);
    }
}
static inline int gw1_rpdo1_ison_FunctSetpoint2Or1(const gw1_rpdo1 *pdo)
{
    return gw1_rpdo1_bit(pdo, 0u) == 1;
}
static inline void gw1_rpdo1_turn_FunctSetpoint2Or1(gw1_rpdo1 *pdo, int on)
{
    gw1_rpdo1_putbit(pdo, 0u, on ? 1 : 0);
}
static inline int gw1_rpdo1_ison_FunctLoadEnable(const gw1_rpdo1 *pdo)
{
    return gw1_rpdo1_bit(pdo, 4u) == 0;
}
static inline void gw1_rpdo1_turn_FunctLoadEnable(gw1_rpdo1 *pdo, int on)
{
    gw1_rpdo1_putbit(pdo, 4u, on ? 0 : 1);
}

/* RPDO2 (1401h, 1601h), to the gateway: 4 bytes, monitored for 93.75 ms */
#define GW1_RPDO2_COB_ID 0x301u
#define GW1_RPDO2_LENGTH 4u
#define GW1_RPDO2_MONITORING_US 93750u

typedef struct { uint8_t bytes[4]; } gw1_rpdo2;
typedef char gw1_rpdo2_is_packed[sizeof(gw1_rpdo2) == 4u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW1_RPDO2_REST { { 0x00, 0x00, 0x00, 0x00 } }
static inline int gw1_rpdo2_take(gw1_rpdo2 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_RPDO2_COB_ID || length < GW1_RPDO2_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_RPDO2_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* AssignIn_Setp1Ext: channel 1, 2004h:1: 900 AssignIn_Setp1Ext; shown by 2900 Setpoint1Extern; 0..65535 is 0..100 % */
#define GW1_RPDO2_BYTE_AssignIn_Setp1Ext 0u
#define GW1_RPDO2_RAWMIN_AssignIn_Setp1Ext 0
#define GW1_RPDO2_RAWMAX_AssignIn_Setp1Ext 65535
#define GW1_RPDO2_UNIT_AssignIn_Setp1Ext "%"
#define GW1_RPDO2_FACTOR_AssignIn_Setp1Ext 0.0015259021896696422
#define GW1_RPDO2_OFFSET_AssignIn_Setp1Ext 0.0
#define GW1_RPDO2_MIN_AssignIn_Setp1Ext 0.0
#define GW1_RPDO2_MAX_AssignIn_Setp1Ext 100.0
static inline int32_t gw1_rpdo2_raw_AssignIn_Setp1Ext(const gw1_rpdo2 *pdo)
{
    return gw1_word(pdo->bytes + GW1_RPDO2_BYTE_AssignIn_Setp1Ext);
}
static inline double gw1_rpdo2_value_AssignIn_Setp1Ext(const gw1_rpdo2 *pdo)
{
    return (double)gw1_rpdo2_raw_AssignIn_Setp1Ext(pdo) * GW1_RPDO2_FACTOR_AssignIn_Setp1Ext + GW1_RPDO2_OFFSET_AssignIn_Setp1Ext;
}
static inline void gw1_rpdo2_setraw_AssignIn_Setp1Ext(gw1_rpdo2 *pdo, int32_t raw)
{
    gw1_putword(pdo->bytes + GW1_RPDO2_BYTE_AssignIn_Setp1Ext, raw);
}
static inline int gw1_rpdo2_set_AssignIn_Setp1Ext(gw1_rpdo2 *pdo, double value)
{
    return gw1_putvalue(pdo->bytes + GW1_RPDO2_BYTE_AssignIn_Setp1Ext, value, GW1_RPDO2_FACTOR_AssignIn_Setp1Ext,
                          GW1_RPDO2_OFFSET_AssignIn_Setp1Ext, GW1_RPDO2_MIN_AssignIn_Setp1Ext, GW1_RPDO2_MAX_AssignIn_Setp1Ext, 0);
}

/* AssignIn_Setp2Ext: channel 2, 2004h:2: 901 AssignIn_Setp2Ext; shown by 2901 Setpoint2Extern; 0..65535 is 0..100 % */
#define GW1_RPDO2_BYTE_AssignIn_Setp2Ext 2u
#define GW1_RPDO2_RAWMIN_AssignIn_Setp2Ext 0
#define GW1_RPDO2_RAWMAX_AssignIn_Setp2Ext 65535
#define GW1_RPDO2_UNIT_AssignIn_Setp2Ext "%"
#define GW1_RPDO2_FACTOR_AssignIn_Setp2Ext 0.0015259021896696422
#define GW1_RPDO2_OFFSET_AssignIn_Setp2Ext 0.0
#define GW1_RPDO2_MIN_AssignIn_Setp2Ext 0.0
#define GW1_RPDO2_MAX_AssignIn_Setp2Ext 100.0
static inline int32_t gw1_rpdo2_raw_AssignIn_Setp2Ext(const gw1_rpdo2 *pdo)
{
    return gw1_word(pdo->bytes + GW1_RPDO2_BYTE_AssignIn_Setp2Ext);
}
static inline double gw1_rpdo2_value_AssignIn_Setp2Ext(const gw1_rpdo2 *pdo)
{
    return (double)gw1_rpdo2_raw_AssignIn_Setp2Ext(pdo) * GW1_RPDO2_FACTOR_AssignIn_Setp2Ext + GW1_RPDO2_OFFSET_AssignIn_Setp2Ext;
}
static inline void gw1_rpdo2_setraw_AssignIn_Setp2Ext(gw1_rpdo2 *pdo, int32_t raw)
{
    gw1_putword(pdo->bytes + GW1_RPDO2_BYTE_AssignIn_Setp2Ext, raw);
}
static inline int gw1_rpdo2_set_AssignIn_Setp2Ext(gw1_rpdo2 *pdo, double value)
{
    return gw1_putvalue(pdo->bytes + GW1_RPDO2_BYTE_AssignIn_Setp2Ext, value, GW1_RPDO2_FACTOR_AssignIn_Setp2Ext,
                          GW1_RPDO2_OFFSET_AssignIn_Setp2Ext, GW1_RPDO2_MIN_AssignIn_Setp2Ext, GW1_RPDO2_MAX_AssignIn_Setp2Ext, 0);
}

/* RPDO3 (1402h, 1602h), to the gateway: 6 bytes, monitored for 187.5 ms */
#define GW1_RPDO3_COB_ID 0x401u
#define GW1_RPDO3_LENGTH 6u
#define GW1_RPDO3_MONITORING_US 187500u

typedef struct { uint8_t bytes[6]; } gw1_rpdo3;
typedef char gw1_rpdo3_is_packed[sizeof(gw1_rpdo3) == 6u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW1_RPDO3_REST { { 0x00, 0x00, 0x00, 0x00, 0x00, 0x00 } }
static inline int gw1_rpdo3_take(gw1_rpdo3 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_RPDO3_COB_ID || length < GW1_RPDO3_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_RPDO3_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* AssignIn_AmbPress: channel 7, 2004h:7: 906 AssignIn_AmbPress; shown by 2906 AmbientPressure; scaling not known */
#define GW1_RPDO3_BYTE_AssignIn_AmbPress 4u
#define GW1_RPDO3_RAWMIN_AssignIn_AmbPress 0
#define GW1_RPDO3_RAWMAX_AssignIn_AmbPress 65535
static inline int32_t gw1_rpdo3_raw_AssignIn_AmbPress(const gw1_rpdo3 *pdo)
{
    return gw1_word(pdo->bytes + GW1_RPDO3_BYTE_AssignIn_AmbPress);
}
static inline void gw1_rpdo3_setraw_AssignIn_AmbPress(gw1_rpdo3 *pdo, int32_t raw)
{
    gw1_putword(pdo->bytes + GW1_RPDO3_BYTE_AssignIn_AmbPress, raw);
}

/* RPDO4 (1403h, 1603h), to the gateway: 8 bytes, monitored for 1000 ms */
#define GW1_RPDO4_COB_ID 0x501u
#define GW1_RPDO4_LENGTH 8u
#define GW1_RPDO4_MONITORING_US 1000000u

typedef struct { uint8_t bytes[8]; } gw1_rpdo4;
typedef char gw1_rpdo4_is_packed[sizeof(gw1_rpdo4) == 8u ? 1 : -1];
/* Every switch function off, all else 0. */
#define GW1_RPDO4_REST { { 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00 } }
static inline int gw1_rpdo4_take(gw1_rpdo4 *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)
{
    unsigned i;
    if (cob_id != GW1_RPDO4_COB_ID || length < GW1_RPDO4_LENGTH) {
        return 0;
    }
    for (i = 0; i < GW1_RPDO4_LENGTH; ++i) {
        pdo->bytes[i] = data[i];
    }
    return 1;
}

/* AssignIn_CurrentLoad: channel 12, 2004h:12: 917 AssignIn_CurrentLoad; shown by 2917 CurrentLoad; scaling not known */
#define GW1_RPDO4_BYTE_AssignIn_CurrentLoad 6u
#define GW1_RPDO4_RAWMIN_AssignIn_CurrentLoad 0
#define GW1_RPDO4_RAWMAX_AssignIn_CurrentLoad 65535
static inline int32_t gw1_rpdo4_raw_AssignIn_CurrentLoad(const gw1_rpdo4 *pdo)
{
    return gw1_word(pdo->bytes + GW1_RPDO4_BYTE_AssignIn_CurrentLoad);
}
static inline void gw1_rpdo4_setraw_AssignIn_CurrentLoad(gw1_rpdo4 *pdo, int32_t raw)
{
    gw1_putword(pdo->bytes + GW1_RPDO4_BYTE_AssignIn_CurrentLoad, raw);
}

#endif
