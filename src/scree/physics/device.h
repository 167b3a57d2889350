// The only file that knows which compiler reads the physics: C++20 on a CPU, or OpenCL C 1.2 on a device.
//
// Everything in physics/ and kernels/ is written in the common subset of both languages: plain structs of `real` and
// `int`, `static inline` functions without overloads, no references, no templates, no standard library, structs
// returned by value. Every name starts with `sc_`; every literal is written R(0.5); pointers carry SC_GLOBAL.
#ifndef SCREE_PHYSICS_DEVICE_H
#define SCREE_PHYSICS_DEVICE_H

#if defined(__OPENCL_VERSION__) || defined(SCREE_DEVICE)
#pragma OPENCL FP_CONTRACT OFF
#ifdef SCREE_FLOAT
typedef float real;
typedef unsigned int sc_bits;
#define SC_BITS_OF(x) as_uint(x)
#define SC_REAL_OF(i) as_float(i)
#else
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double real;
typedef unsigned long sc_bits;
#define SC_BITS_OF(x) as_ulong(x)
#define SC_REAL_OF(i) as_double(i)
#endif
#define SC_FN static inline
#define SC_LONG_FN static __attribute__((noinline))
#define SC_GLOBAL __global
#define SC_SQRT(x) sqrt(x)
#define SC_FABS(x) fabs(x)
#define SC_FLOOR(x) floor(x)
#define R(x) ((real)(x))
#else
// Builtins, so that the loops around them vectorise. Single precision on a CPU is for tests of the text.
#ifdef SCREE_FLOAT
typedef float real;
typedef unsigned int sc_bits;
#define SC_SQRT(x) __builtin_sqrtf(x)
#define SC_FABS(x) __builtin_fabsf(x)
#define SC_FLOOR(x) __builtin_floorf(x)
#else
typedef double real;
typedef unsigned long long sc_bits;
#define SC_SQRT(x) __builtin_sqrt(x)
#define SC_FABS(x) __builtin_fabs(x)
#define SC_FLOOR(x) __builtin_floor(x)
#endif
#define SC_BITS_OF(x) __builtin_bit_cast(sc_bits, (x))
#define SC_REAL_OF(i) __builtin_bit_cast(real, (i))
#define SC_FN [[maybe_unused, gnu::always_inline]] static inline
// Seldom run, and too long to be written out wherever it is called: compilers would take minutes.
#define SC_LONG_FN [[maybe_unused, gnu::noinline]] static inline
#define SC_GLOBAL
// A function, not a macro: libraries use the name R for their own things.
template <class T>
[[maybe_unused, gnu::always_inline]] static constexpr inline real R(T x) {
  return static_cast<real>(x);
}
#endif

// Smallest divisor that counts as different from zero: what is divided by it stays finite.
#ifdef SCREE_FLOAT
#define SC_TINY R(1e-36)
#else
#define SC_TINY R(1e-280)
#endif

// By comparison on both sides: the libraries' fmin and fmax differ in what they do with NaN and do not vectorise.
#define SC_MIN(a, b) ((a) < (b) ? (a) : (b))
#define SC_MAX(a, b) ((a) > (b) ? (a) : (b))

#endif
