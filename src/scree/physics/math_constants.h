// The numbers in math.h that depend on the precision.
#ifndef SCREE_PHYSICS_MATH_CONSTANTS_H
#define SCREE_PHYSICS_MATH_CONSTANTS_H

#include "scree/physics/device.h"

#ifdef SCREE_FLOAT
#define SC_MANTISSA 23                           // stored bits of the mantissa
#define SC_ONE_BITS ((sc_bits)0x3f800000)        // of 1
#define SC_ROOT_HALF_BITS ((sc_bits)0x3f3504f3)  // of sqrt(1/2)
#define SC_INFINITY_BITS ((sc_bits)0x7f800000)
#define SC_NAN_BITS ((sc_bits)0x7fc00000)
#define SC_INTEGER_BITS ((sc_bits)0x4b000000)  // of 2^23: or-ing a small integer in adds it
#define SC_INTEGER R(8388608.0)
#define SC_BIAS R(127.0)
#define SC_SHIFTER R(12582912.0)  // 1.5 * 2^23: adding it rounds to an integer
#define SC_SPLITTER R(4097.0)     // 2^12 + 1: splits a number in two halves with exact products
#define SC_SMALLEST_NORMAL R(1.17549435082228751e-38)
#define SC_LIFT R(16777216.0)  // 2^24
#define SC_LIFT_EXPONENT R(24.0)
#define SC_EXP_TOP R(88.7228317)
#define SC_EXP_BOTTOM R(-104.0)
#define SC_LN2_HIGH R(0.693115234375)
#define SC_LN2_LOW R(3.194618494530941723e-5)
#define SC_TWO_THIRDS R(0.66666668653488159)
#define SC_TWO_THIRDS_LOW R(-1.9868214925130208e-8)
// pi/2 in parts of 12, 12, 12 bits and the rest
#define SC_PI_2_A R(1.5703125)
#define SC_PI_2_B R(0.0004837512969970703125)
#define SC_PI_2_C R(7.549533620476722717e-8)
#define SC_PI_2_D R(2.563344151594518788e-12)
#else
#define SC_MANTISSA 52
#define SC_ONE_BITS ((sc_bits)0x3ff0000000000000)
#define SC_ROOT_HALF_BITS ((sc_bits)0x3fe6a09e667f3bcd)
#define SC_INFINITY_BITS ((sc_bits)0x7ff0000000000000)
#define SC_NAN_BITS ((sc_bits)0x7ff8000000000000)
#define SC_INTEGER_BITS ((sc_bits)0x4330000000000000)
#define SC_INTEGER R(4503599627370496.0)
#define SC_BIAS R(1023.0)
#define SC_SHIFTER R(6755399441055744.0)
#define SC_SPLITTER R(134217729.0)
#define SC_SMALLEST_NORMAL R(2.2250738585072014e-308)
#define SC_LIFT R(18014398509481984.0)
#define SC_LIFT_EXPONENT R(54.0)
#define SC_EXP_TOP R(709.78271289338397)
#define SC_EXP_BOTTOM R(-745.5)
#define SC_LN2_HIGH R(0.6931471803691238165)
#define SC_LN2_LOW R(1.908214929270587816e-10)
#define SC_TWO_THIRDS R(0.66666666666666663)
#define SC_TWO_THIRDS_LOW R(3.7007434154171885e-17)
// pi/2 in parts of 33, 33, 33 bits and the rest
#define SC_PI_2_A R(1.57079632673412561416626)
#define SC_PI_2_B R(6.077100506303965976595549e-11)
#define SC_PI_2_C R(2.022266248711166455795996e-21)
#define SC_PI_2_D R(8.478427660368899643958701e-32)
#endif

#endif
