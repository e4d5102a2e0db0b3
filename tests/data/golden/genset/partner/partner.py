#!/usr/bin/env python3
"""What the partner of gateway node 12 on the CANopen bus reads and sends.

Written by cgw 0.1.0; do not edit.
title:            Genset 2, starboard
configuration id: d4dc49f089f420e1

decode() and encode() need no library. With the library canopen (and python-can) there are subscribe(),
send_periodic(), send_heartbeat() and start(). On its own the file decodes frames and listens to a bus:
    python3 FILE decode 181#0000000000000000
    python3 FILE listen can0 socketcan
"""
import collections
import sys

CONFIGURATION_ID = "d4dc49f089f420e1"
NODE_ID = 12
PARTNER_NODE_ID = 1  # 0: none
BIT_RATE = 250000  # bit/s; None: set by hand and not known here
HEARTBEAT_US = 800000  # time between two of the gateway; 0: it sends none
PARTNER_HEARTBEAT_US = 2000000  # longest time between two of the partner's; 0: any

# `read`: the gateway sends it. `time_us`: then the time between two frames, 0 on change; else the longest time
# between two of the partner's, 0 any. `rest`: every switch function off, all else 0.
Pdo = collections.namedtuple("Pdo", "name cob_id length read time_us rest signals")
# Physical value = raw * factor + offset, None where the scaling is not known. `on`: what a bit is when the switch
# is on. Bit 0 is the lowest of byte 0; numbers stand low byte first.
Signal = collections.namedtuple(
    "Signal", "name first_bit bits signed factor offset minimum maximum unit on scaled meaning")

PDOS = (
    Pdo("TPDO1", 0x18C, 8, True, 0, bytes.fromhex("0000000000000000"), (
        Signal("ConfigurationError", 0, 1, False, None, None, None, None, "", None, False,
               "3000, 2000h:1; governor ConfigurationError; 1: the error is present"),
        Signal("Error_3001", 1, 1, False, None, None, None, None, "", None, False,
               "3001, 2000h:1; 1: the error is present"),
        Signal("Error_3002", 2, 1, False, None, None, None, None, "", None, False,
               "3002, 2000h:1; 1: the error is present"),
        Signal("Error_3003", 3, 1, False, None, None, None, None, "", None, False,
               "3003, 2000h:1; 1: the error is present"),
        Signal("Error_3004", 4, 1, False, None, None, None, None, "", None, False,
               "3004, 2000h:1; 1: the error is present"),
        Signal("ErrSetpointExtern", 5, 1, False, None, None, None, None, "", None, False,
               "3005, 2000h:1; governor ErrSetpointExtern; 1: the error is present"),
        Signal("Error_3006", 6, 1, False, None, None, None, None, "", None, False,
               "3006, 2000h:1; 1: the error is present"),
        Signal("Error_3007", 7, 1, False, None, None, None, None, "", None, False,
               "3007, 2000h:1; 1: the error is present"),
        Signal("Error_3008", 8, 1, False, None, None, None, None, "", None, False,
               "3008, 2000h:1; 1: the error is present"),
        Signal("Error_3009", 9, 1, False, None, None, None, None, "", None, False,
               "3009, 2000h:1; 1: the error is present"),
        Signal("Error_3010", 10, 1, False, None, None, None, None, "", None, False,
               "3010, 2000h:1; 1: the error is present"),
        Signal("Error_3011", 11, 1, False, None, None, None, None, "", None, False,
               "3011, 2000h:1; 1: the error is present"),
        Signal("Error_3012", 12, 1, False, None, None, None, None, "", None, False,
               "3012, 2000h:1; 1: the error is present"),
        Signal("Error_3013", 13, 1, False, None, None, None, None, "", None, False,
               "3013, 2000h:1; 1: the error is present"),
        Signal("Error_3014", 14, 1, False, None, None, None, None, "", None, False,
               "3014, 2000h:1; 1: the error is present"),
        Signal("Error_3015", 15, 1, False, None, None, None, None, "", None, False,
               "3015, 2000h:1; 1: the error is present"),
        Signal("Error_3016", 16, 1, False, None, None, None, None, "", None, False,
               "3016, 2000h:2; 1: the error is present"),
        Signal("Error_3017", 17, 1, False, None, None, None, None, "", None, False,
               "3017, 2000h:2; 1: the error is present"),
        Signal("Error_3018", 18, 1, False, None, None, None, None, "", None, False,
               "3018, 2000h:2; 1: the error is present"),
        Signal("Error_3019", 19, 1, False, None, None, None, None, "", None, False,
               "3019, 2000h:2; 1: the error is present"),
        Signal("Error_3020", 20, 1, False, None, None, None, None, "", None, False,
               "3020, 2000h:2; 1: the error is present"),
        Signal("Error_3021", 21, 1, False, None, None, None, None, "", None, False,
               "3021, 2000h:2; 1: the error is present"),
        Signal("Error_3022", 22, 1, False, None, None, None, None, "", None, False,
               "3022, 2000h:2; 1: the error is present"),
        Signal("Error_3023", 23, 1, False, None, None, None, None, "", None, False,
               "3023, 2000h:2; 1: the error is present"),
        Signal("Error_3024", 24, 1, False, None, None, None, None, "", None, False,
               "3024, 2000h:2; 1: the error is present"),
        Signal("Error_3025", 25, 1, False, None, None, None, None, "", None, False,
               "3025, 2000h:2; 1: the error is present"),
        Signal("Error_3026", 26, 1, False, None, None, None, None, "", None, False,
               "3026, 2000h:2; 1: the error is present"),
        Signal("Error_3027", 27, 1, False, None, None, None, None, "", None, False,
               "3027, 2000h:2; 1: the error is present"),
        Signal("Error_3028", 28, 1, False, None, None, None, None, "", None, False,
               "3028, 2000h:2; 1: the error is present"),
        Signal("Error_3029", 29, 1, False, None, None, None, None, "", None, False,
               "3029, 2000h:2; 1: the error is present"),
        Signal("Error_3030", 30, 1, False, None, None, None, None, "", None, False,
               "3030, 2000h:2; 1: the error is present"),
        Signal("Error_3031", 31, 1, False, None, None, None, None, "", None, False,
               "3031, 2000h:2; 1: the error is present"),
        Signal("Error_3032", 32, 1, False, None, None, None, None, "", None, False,
               "3032, 2000h:3; 1: the error is present"),
        Signal("Error_3033", 33, 1, False, None, None, None, None, "", None, False,
               "3033, 2000h:3; 1: the error is present"),
        Signal("Error_3034", 34, 1, False, None, None, None, None, "", None, False,
               "3034, 2000h:3; 1: the error is present"),
        Signal("Error_3035", 35, 1, False, None, None, None, None, "", None, False,
               "3035, 2000h:3; 1: the error is present"),
        Signal("Error_3036", 36, 1, False, None, None, None, None, "", None, False,
               "3036, 2000h:3; 1: the error is present"),
        Signal("Error_3037", 37, 1, False, None, None, None, None, "", None, False,
               "3037, 2000h:3; 1: the error is present"),
        Signal("Error_3038", 38, 1, False, None, None, None, None, "", None, False,
               "3038, 2000h:3; 1: the error is present"),
        Signal("Error_3039", 39, 1, False, None, None, None, None, "", None, False,
               "3039, 2000h:3; 1: the error is present"),
        Signal("Error_3040", 40, 1, False, None, None, None, None, "", None, False,
               "3040, 2000h:3; 1: the error is present"),
        Signal("Error_3041", 41, 1, False, None, None, None, None, "", None, False,
               "3041, 2000h:3; 1: the error is present"),
        Signal("Error_3042", 42, 1, False, None, None, None, None, "", None, False,
               "3042, 2000h:3; 1: the error is present"),
        Signal("Error_3043", 43, 1, False, None, None, None, None, "", None, False,
               "3043, 2000h:3; 1: the error is present"),
        Signal("Error_3044", 44, 1, False, None, None, None, None, "", None, False,
               "3044, 2000h:3; 1: the error is present"),
        Signal("Error_3045", 45, 1, False, None, None, None, None, "", None, False,
               "3045, 2000h:3; 1: the error is present"),
        Signal("Error_3046", 46, 1, False, None, None, None, None, "", None, False,
               "3046, 2000h:3; 1: the error is present"),
        Signal("Error_3047", 47, 1, False, None, None, None, None, "", None, False,
               "3047, 2000h:3; 1: the error is present"),
        Signal("Error_3048", 48, 1, False, None, None, None, None, "", None, False,
               "3048, 2000h:4; 1: the error is present"),
        Signal("Error_3049", 49, 1, False, None, None, None, None, "", None, False,
               "3049, 2000h:4; 1: the error is present"),
        Signal("Error_3050", 50, 1, False, None, None, None, None, "", None, False,
               "3050, 2000h:4; 1: the error is present"),
        Signal("Error_3051", 51, 1, False, None, None, None, None, "", None, False,
               "3051, 2000h:4; 1: the error is present"),
        Signal("Error_3052", 52, 1, False, None, None, None, None, "", None, False,
               "3052, 2000h:4; 1: the error is present"),
        Signal("Error_3053", 53, 1, False, None, None, None, None, "", None, False,
               "3053, 2000h:4; 1: the error is present"),
        Signal("Error_3054", 54, 1, False, None, None, None, None, "", None, False,
               "3054, 2000h:4; 1: the error is present"),
        Signal("Error_3055", 55, 1, False, None, None, None, None, "", None, False,
               "3055, 2000h:4; 1: the error is present"),
        Signal("Error_3056", 56, 1, False, None, None, None, None, "", None, False,
               "3056, 2000h:4; 1: the error is present"),
        Signal("Error_3057", 57, 1, False, None, None, None, None, "", None, False,
               "3057, 2000h:4; 1: the error is present"),
        Signal("Error_3058", 58, 1, False, None, None, None, None, "", None, False,
               "3058, 2000h:4; 1: the error is present"),
        Signal("Error_3059", 59, 1, False, None, None, None, None, "", None, False,
               "3059, 2000h:4; 1: the error is present"),
        Signal("Error_3060", 60, 1, False, None, None, None, None, "", None, False,
               "3060, 2000h:4; 1: the error is present"),
        Signal("Error_3061", 61, 1, False, None, None, None, None, "", None, False,
               "3061, 2000h:4; 1: the error is present"),
        Signal("Error_3062", 62, 1, False, None, None, None, None, "", None, False,
               "3062, 2000h:4; 1: the error is present"),
        Signal("Error_3063", 63, 1, False, None, None, None, None, "", None, False,
               "3063, 2000h:4; 1: the error is present"),
    )),
    Pdo("TPDO2", 0x28C, 4, True, 0, bytes.fromhex("00000000"), (
        Signal("Error_3064", 0, 1, False, None, None, None, None, "", None, False,
               "3064, 2000h:5; 1: the error is present"),
        Signal("Error_3065", 1, 1, False, None, None, None, None, "", None, False,
               "3065, 2000h:5; 1: the error is present"),
        Signal("Error_3066", 2, 1, False, None, None, None, None, "", None, False,
               "3066, 2000h:5; 1: the error is present"),
        Signal("Error_3067", 3, 1, False, None, None, None, None, "", None, False,
               "3067, 2000h:5; 1: the error is present"),
        Signal("Error_3068", 4, 1, False, None, None, None, None, "", None, False,
               "3068, 2000h:5; 1: the error is present"),
        Signal("Error_3069", 5, 1, False, None, None, None, None, "", None, False,
               "3069, 2000h:5; 1: the error is present"),
        Signal("ErrCanBus", 6, 1, False, None, None, None, None, "", None, False,
               "3070, 2000h:5; governor ErrCanBus; gateway ErrCanBus1; 1: the error is present"),
        Signal("ErrCanComm", 7, 1, False, None, None, None, None, "", None, False,
               "3071, 2000h:5; governor ErrCanComm; gateway ErrCanComm1; 1: the error is present"),
        Signal("ErrCanBus2", 8, 1, False, None, None, None, None, "", None, False,
               "3072, 2000h:5; governor ErrCanBus2; gateway ErrCanBus2; 1: the error is present"),
        Signal("ErrCanComm2", 9, 1, False, None, None, None, None, "", None, False,
               "3073, 2000h:5; governor ErrCanComm2; gateway ErrCanComm2; 1: the error is present"),
        Signal("ErrCanOpen", 10, 1, False, None, None, None, None, "", None, False,
               "3074, 2000h:5; governor ErrCanOpen; gateway ErrCanOpen; 1: the error is present"),
        Signal("Error_3075", 11, 1, False, None, None, None, None, "", None, False,
               "3075, 2000h:5; 1: the error is present"),
        Signal("ErrParamStore", 12, 1, False, None, None, None, None, "", None, False,
               "3076, 2000h:5; gateway ErrParamStore; 1: the error is present"),
        Signal("ErrProgramTest", 13, 1, False, None, None, None, None, "", None, False,
               "3077, 2000h:5; gateway ErrProgramTest; 1: the error is present"),
        Signal("ErrRAMTest", 14, 1, False, None, None, None, None, "", None, False,
               "3078, 2000h:5; gateway ErrRAMTest; 1: the error is present"),
        Signal("Error_3079", 15, 1, False, None, None, None, None, "", None, False,
               "3079, 2000h:5; 1: the error is present"),
        Signal("Error_3080", 16, 1, False, None, None, None, None, "", None, False,
               "3080, 2000h:6; 1: the error is present"),
        Signal("Error_3081", 17, 1, False, None, None, None, None, "", None, False,
               "3081, 2000h:6; 1: the error is present"),
        Signal("Error_3082", 18, 1, False, None, None, None, None, "", None, False,
               "3082, 2000h:6; 1: the error is present"),
        Signal("Error_3083", 19, 1, False, None, None, None, None, "", None, False,
               "3083, 2000h:6; 1: the error is present"),
        Signal("Error_3084", 20, 1, False, None, None, None, None, "", None, False,
               "3084, 2000h:6; 1: the error is present"),
        Signal("ErrVoltage", 21, 1, False, None, None, None, None, "", None, False,
               "3085, 2000h:6; gateway ErrVoltage; 1: the error is present"),
        Signal("Error_3086", 22, 1, False, None, None, None, None, "", None, False,
               "3086, 2000h:6; 1: the error is present"),
        Signal("Error_3087", 23, 1, False, None, None, None, None, "", None, False,
               "3087, 2000h:6; 1: the error is present"),
        Signal("Error_3088", 24, 1, False, None, None, None, None, "", None, False,
               "3088, 2000h:6; 1: the error is present"),
        Signal("Error_3089", 25, 1, False, None, None, None, None, "", None, False,
               "3089, 2000h:6; 1: the error is present"),
        Signal("ErrData", 26, 1, False, None, None, None, None, "", None, False,
               "3090, 2000h:6; gateway ErrData; 1: the error is present"),
        Signal("Error_3091", 27, 1, False, None, None, None, None, "", None, False,
               "3091, 2000h:6; 1: the error is present"),
        Signal("Error_3092", 28, 1, False, None, None, None, None, "", None, False,
               "3092, 2000h:6; 1: the error is present"),
        Signal("ErrStack", 29, 1, False, None, None, None, None, "", None, False,
               "3093, 2000h:6; gateway ErrStack; 1: the error is present"),
        Signal("ErrIntern", 30, 1, False, None, None, None, None, "", None, False,
               "3094, 2000h:6; gateway ErrIntern; 1: the error is present"),
        Signal("Error_3095", 31, 1, False, None, None, None, None, "", None, False,
               "3095, 2000h:6; 1: the error is present"),
    )),
    Pdo("TPDO3", 0x38C, 2, True, 0, bytes.fromhex("0000"), (
        Signal("EngineState_Bit1", 0, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 1; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit2", 1, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 2; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit3", 2, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 3; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit4", 3, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 4; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit5", 4, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 5; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit6", 5, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 6; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit7", 6, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 7; its meaning depends on the governor and is not printed"),
        Signal("EngineState_Bit8", 7, 1, False, None, None, None, None, "", None, False,
               "2000h:7 bit 8; its meaning depends on the governor and is not printed"),
    )),
    Pdo("TPDO4", 0x48C, 8, True, 125000, bytes.fromhex("0000000000000000"), (
        Signal("Speed", 0, 16, False, 0.061036087586785685, 0.0, 0.0, 4000.0, "1/min", None, True,
               "2000 Speed, 2001h:1"),
        Signal("SpeedSetp", 16, 16, False, 0.061036087586785685, 0.0, 0.0, 4000.0, "1/min", None, True,
               "2031 SpeedSetp, 2001h:2"),
        Signal("ActPos", 32, 16, False, 0.0015259021896696422, 0.0, 0.0, 100.0, "%", None, True,
               "2300 ActPos, 2001h:3"),
        Signal("MeasuredPower", 48, 16, False, 0.01907377737087053, 0.0, 0.0, 1250.0, "kW", None, True,
               "2918 MeasuredPower, 2001h:4"),
    )),
    Pdo("TPDO5", 0x680, 8, True, 500000, bytes.fromhex("0000000000000000"), (
        Signal("BoostPressure", 0, 16, False, 6.103608758678569e-05, 0.0, 0.0, 4.0, "bar", None, True,
               "2904 BoostPressure, 2001h:5"),
        Signal("OilPressure", 16, 16, False, 0.00015259021896696422, 0.0, 0.0, 10.0, "bar", None, True,
               "2905 OilPressure, 2001h:6"),
        Signal("AmbientPressure", 32, 16, False, 0.010681315327687495, 500.0, 500.0, 1200.0, "mbar", None, True,
               "2906 AmbientPressure, 2001h:7"),
        Signal("CoolantPressure", 48, 16, False, 7.629510948348211e-05, 0.0, 0.0, 5.0, "bar", None, True,
               "2916 CoolantPressure, 2001h:8"),
    )),
    Pdo("TPDO6", 0x681, 8, True, 1000000, bytes.fromhex("0000000000000000"), (
        Signal("CoolantTemp", 0, 16, False, 0.016784924086366063, -100.0, -100.0, 1000.0, "\U000000b0C", None, True,
               "2907 CoolantTemp, 2001h:9"),
        Signal("ChargeAirTemp", 16, 16, False, 0.016784924086366063, -100.0, -100.0, 1000.0, "\U000000b0C", None, True,
               "2908 ChargeAirTemp, 2001h:10"),
        Signal("OilTemp", 32, 16, False, 0.016784924086366063, -100.0, -100.0, 1000.0, "\U000000b0C", None, True,
               "2909 OilTemp, 2001h:11"),
        Signal("ExhaustTemp", 48, 16, False, 0.016784924086366063, -100.0, -100.0, 1000.0, "\U000000b0C", None, True,
               "2911 ExhaustTemp, 2001h:12"),
    )),
    Pdo("RPDO1", 0x20C, 6, False, 500000, bytes.fromhex("040000000000"), (
        Signal("FunctIdleSpeed", 0, 1, False, None, None, None, None, "", 1, False,
               "2003h:1 bit 1; 811 FunctIdleSpeed, high-active: 1 is on"),
        Signal("FunctSetpoint2Or1", 1, 1, False, None, None, None, None, "", 1, False,
               "2003h:1 bit 2; 827 FunctSetpoint2Or1, high-active: 1 is on"),
        Signal("FunctLoadEnable", 2, 1, False, None, None, None, None, "", 0, False,
               "2003h:1 bit 3; 835 FunctLoadEnable, low-active: 0 is on"),
        Signal("AssignIn_Setp1Ext_Error", 32, 1, False, None, None, None, None, "", None, False,
               "2003h:2 bit 1, error flag of channel 1: 900 AssignIn_Setp1Ext; 1: faulty"),
        Signal("Sensor_902_Error", 33, 1, False, None, None, None, None, "", None, False,
               "2003h:2 bit 2, error flag of channel 2: 902; 1: faulty"),
        Signal("Sensor_903_Error", 34, 1, False, None, None, None, None, "", None, False,
               "2003h:2 bit 3, error flag of channel 3: 903; 1: faulty"),
        Signal("AssignIn_AmbPress_Error", 36, 1, False, None, None, None, None, "", None, False,
               "2003h:2 bit 5, error flag of channel 5: 906 AssignIn_AmbPress; 1: faulty"),
        Signal("Sensor_910_Error", 37, 1, False, None, None, None, None, "", None, False,
               "2003h:2 bit 6, error flag of channel 6: 910; 1: faulty"),
        Signal("AssignIn_CurrentLoad_Error", 40, 1, False, None, None, None, None, "", None, False,
               "2003h:2 bit 9, error flag of channel 9: 917 AssignIn_CurrentLoad; 1: faulty"),
    )),
    Pdo("RPDO2", 0x30C, 6, False, 500000, bytes.fromhex("000000000000"), (
        Signal("AssignIn_Setp1Ext", 0, 16, False, 0.0015259021896696422, 0.0, 0.0, 100.0, "%", None, True,
               "channel 1, 2004h:1: 900 AssignIn_Setp1Ext; shown by 2900 Setpoint1Extern"),
        Signal("Sensor_902", 16, 16, False, 0.0015259021896696422, 0.0, 0.0, 100.0, "%", None, True,
               "channel 2, 2004h:2: 902; shown by 2902 LoadControlInput"),
        Signal("Sensor_903", 32, 16, False, 0.0015259021896696422, 0.0, 0.0, 100.0, "%", None, True,
               "channel 3, 2004h:3: 903; shown by 2903 SyncInput"),
    )),
    Pdo("RPDO3", 0x40C, 4, False, 1000000, bytes.fromhex("00000000"), (
        Signal("AssignIn_AmbPress", 0, 16, False, 0.010681315327687495, 500.0, 500.0, 1200.0, "mbar", None, True,
               "channel 5, 2004h:5: 906 AssignIn_AmbPress; shown by 2906 AmbientPressure"),
        Signal("Sensor_910", 16, 16, False, 0.016784924086366063, -100.0, -100.0, 1000.0, "\U000000b0C", None, True,
               "channel 6, 2004h:6: 910; shown by 2910 FuelTemp"),
    )),
    Pdo("RPDO4", 0x50C, 2, False, 1000000, bytes.fromhex("0000"), (
        Signal("AssignIn_CurrentLoad", 0, 16, False, None, None, None, None, "", None, False,
               "channel 9, 2004h:9: 917 AssignIn_CurrentLoad; shown by 2917 CurrentLoad"),
    )),
)


def find_pdo(name):
    for pdo in PDOS:
        if pdo.name == name:
            return pdo
    raise KeyError("no PDO of this gateway: {!r}".format(name))


def raw_value(signal, data):
    """The number on the bus, with its sign. `data` holds the whole frame."""
    raw = int.from_bytes(bytes(data), "little") >> signal.first_bit & ((1 << signal.bits) - 1)
    return raw - (1 << signal.bits) if signal.signed and raw >> (signal.bits - 1) else raw


def value_of(signal, raw):
    """Physical value; the number itself where no scaling is known; True for a bit that is 1 or a switch that is on."""
    if signal.bits == 1:
        return raw == (1 if signal.on is None else signal.on)
    return raw if signal.factor is None else raw * signal.factor + signal.offset


def raw_of(signal, value):
    """The nearest number; ValueError beyond the signal's range."""
    if signal.bits == 1:
        on = 1 if signal.on is None else signal.on
        return on if value else 1 - on
    if signal.factor is None:
        raw = int(value)
        lowest = -(1 << 15) if signal.signed else 0
        if raw != value or not lowest <= raw < lowest + (1 << 16):
            raise ValueError("{} is no number of 16 bits for {}".format(value, signal.name))
        return raw
    slack = abs(signal.factor) / 2
    if not signal.minimum - slack <= value <= signal.maximum + slack:
        raise ValueError("{} of {} is not in {}..{}".format(value, signal.name, signal.minimum, signal.maximum))
    steps = (min(max(value, signal.minimum), signal.maximum) - signal.offset) / signal.factor
    raw = int(steps)
    raw += (steps - raw >= 0.5) - (steps - raw <= -0.5)
    lowest = -(1 << 15) if signal.signed else 0
    if not lowest <= raw < lowest + (1 << 16):
        raise ValueError("{} of {} has no number of 16 bits".format(value, signal.name))
    return raw


def decode(cob_id, data):
    """(name of the PDO, {signal: value}); None for a frame that is none of the PDOs, or shorter than it."""
    for pdo in PDOS:
        if pdo.cob_id == cob_id and len(data) >= pdo.length:
            return pdo.name, {signal.name: value_of(signal, raw_value(signal, data)) for signal in pdo.signals}
    return None


def encode(name, values, data=None):
    """The bytes of a receive PDO. What `values` leaves out stays as in `data`, else as in the PDO's rest."""
    pdo = find_pdo(name)
    if pdo.read:
        raise ValueError("{} is sent by the gateway alone".format(name))
    signals = {signal.name: signal for signal in pdo.signals}
    word = int.from_bytes(bytes(data or pdo.rest), "little")
    for key, value in values.items():
        if key not in signals:
            raise KeyError("{} carries no {!r}".format(name, key))
        mask = (1 << signals[key].bits) - 1
        word &= ~(mask << signals[key].first_bit)
        word |= (raw_of(signals[key], value) & mask) << signals[key].first_bit
    return word.to_bytes(pdo.length, "little")


# With the library canopen: `network` is a connected canopen.Network.

def subscribe(network, on_pdo):
    """Calls on_pdo(name of the PDO, {signal: value}, time) for every transmit PDO."""
    def take(cob_id, data, timestamp):
        decoded = decode(cob_id, data)
        if decoded is not None:
            on_pdo(decoded[0], decoded[1], timestamp)

    for pdo in PDOS:
        if pdo.read:
            network.subscribe(pdo.cob_id, take)


def send_periodic(network, name, values, period=None):
    """Sends a receive PDO again and again, four times in its monitoring time unless `period` (s) is given. What it
    returns has update(encode(...)) and stop()."""
    pdo = find_pdo(name)
    if period is None:
        if pdo.time_us == 0:
            raise ValueError("{} is not monitored: say a period".format(name))
        period = pdo.time_us / 4e6
    return network.send_periodic(pdo.cob_id, encode(name, values), period)


def send_heartbeat(network):
    """The heartbeat of the partner, four times in the time within which the gateway wants it; None if it wants none."""
    if PARTNER_NODE_ID == 0 or PARTNER_HEARTBEAT_US == 0:
        return None
    return network.send_periodic(0x700 + PARTNER_NODE_ID, b"\x05", PARTNER_HEARTBEAT_US / 4e6)


def start(network):
    """NMT: the gateway becomes Operational. It sends and takes PDOs only then."""
    network.send_message(0, bytes([1, NODE_ID]))


def text_of(signal, value):
    if signal.bits == 1:
        return "{:d}".format(value) if signal.on is None else "on" if value else "off"
    return "{!r}{}".format(value, " " + signal.unit if signal.unit else "" if signal.scaled else " raw")


def print_pdo(name, values, _time=None):
    for signal in find_pdo(name).signals:
        print(name, signal.name, text_of(signal, values[signal.name]))


def parse_frame(text):
    identifier, _, data = text.partition("#")
    return int(identifier, 16), bytes.fromhex(data)


def listen(channel, interface):
    import canopen
    import time

    network = canopen.Network()
    network.connect(channel=channel, interface=interface)
    subscribe(network, print_pdo)
    try:
        while True:
            time.sleep(1)
    except KeyboardInterrupt:
        pass
    finally:
        network.disconnect()
    return 0


def main(arguments):
    if len(arguments) == 3 and arguments[0] == "listen":
        return listen(arguments[1], arguments[2])
    if len(arguments) < 2 or arguments[0] != "decode":
        print("usage: decode FRAME... | listen CHANNEL INTERFACE\n"
              "FRAME is COB-ID#DATA, both hexadecimal; listen needs the library canopen", file=sys.stderr)
        return 2
    known = True
    for text in arguments[1:]:
        try:
            decoded = decode(*parse_frame(text))
        except ValueError:
            print("{!a} is no frame: COB-ID#DATA, both hexadecimal".format(text), file=sys.stderr)
            return 2
        if decoded is None:
            print("{} is no PDO of this gateway, or too short".format(text), file=sys.stderr)
            known = False
        else:
            print_pdo(*decoded)
    return 0 if known else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
