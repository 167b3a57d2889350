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
#else
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double real;
#endif
#define SC_FN static inline
#define SC_GLOBAL __global
#define SC_SQRT(x) sqrt(x)
#define SC_FABS(x) fabs(x)
#define SC_FLOOR(x) floor(x)
#define R(x) ((real)(x))
#else
typedef double real;
#define SC_FN [[maybe_unused, gnu::always_inline]] static inline
#define SC_GLOBAL
// Builtins, so that the loops around them vectorise.
#define SC_SQRT(x) __builtin_sqrt(x)
#define SC_FABS(x) __builtin_fabs(x)
#define SC_FLOOR(x) __builtin_floor(x)
// A function, not a macro: libraries use the name R for their own things.
template <class T>
[[maybe_unused, gnu::always_inline]] static constexpr inline real R(T x) {
  return static_cast<real>(x);
}
#endif

// By comparison on both sides: the libraries' fmin and fmax differ in what they do with NaN and do not vectorise.
#define SC_MIN(a, b) ((a) < (b) ? (a) : (b))
#define SC_MAX(a, b) ((a) > (b) ? (a) : (b))

#endif
