/* Knobs of Pel. Each has a default, so no configuration file is needed; a
 * program that wants others compiles with -DPEL_CONFIG_FILE='"my_pel.h"' or
 * with -DPEL_NAME=value, the library and all that includes its headers alike:
 * some knobs are sizes of structs. No knob changes a pixel: only speed and
 * size. */
#ifndef PEL_CONFIG_H
#define PEL_CONFIG_H

#include <stdint.h>

#ifdef PEL_CONFIG_FILE
#include PEL_CONFIG_FILE
#endif

/* C++: headers declare C functions, and cast in its own words. */
#ifdef __cplusplus
#define PEL_BEGIN_DECLS extern "C" {
#define PEL_END_DECLS }
#define PEL_CAST(type, value) static_cast<type>(value)
#define PEL_CAST_ADDRESS(type, value) reinterpret_cast<type>(value)
#else
#define PEL_BEGIN_DECLS
#define PEL_END_DECLS
#define PEL_CAST(type, value) ((type)(value))
#define PEL_CAST_ADDRESS(type, value) ((type)(value))
#endif

/* What a broken contract does (a vertex out of range, a format that lacks the
 * function a paint needs). By default nothing: the call draws nothing. */
#ifndef PEL_ASSERT
#define PEL_ASSERT(condition) ((void)0)
#endif

/* 1 on CPUs with 64-bit registers and division: the fast fillers that own
 * their row loop are compiled in. Costs about 3 KB of code, and 4 KB where a
 * nearest texture is linked, 7 KB where a bilinear one is. */
#ifndef PEL_FAST_64BIT
#if UINTPTR_MAX > 0xFFFFFFFFu
#define PEL_FAST_64BIT 1
#else
#define PEL_FAST_64BIT 0
#endif
#endif

/* 1 on CPUs that multiply 32 by 32 to 64 bits with one instruction or two:
 * RISC-V with M, and Xtensa but for the ESP8266, which has no windowed ABI. */
#ifndef PEL_LONG_MULTIPLY
#if PEL_FAST_64BIT || (defined(__ARM_ARCH) && __ARM_ARCH >= 7) || \
    defined(__i386__) || defined(__riscv_mul) ||                  \
    defined(__XTENSA_WINDOWED_ABI__)
#define PEL_LONG_MULTIPLY 1
#else
#define PEL_LONG_MULTIPLY 0
#endif
#endif

/* 1 where the compiler has 16-byte GNU vectors and the CPU registers for them;
 * 0 takes plain loops that write the same bytes. */
#ifndef PEL_VECTORS
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__ARM_NEON)) && \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define PEL_VECTORS 1
#else
#define PEL_VECTORS 0
#endif
#endif

/* 1: triangles find out first which of their edges is the left one, so that
 * rows need not be sorted and clipped one by one. Costs about 150 bytes: by
 * default not where the compiler is asked for small code. */
#ifndef PEL_KNOW_SIDES
#ifdef __OPTIMIZE_SIZE__
#define PEL_KNOW_SIDES 0
#else
#define PEL_KNOW_SIDES 1
#endif
#endif

/* Rows that a shape hands to a paint at a time: 8 bytes of stack each. */
#ifndef PEL_BATCH_ROWS
#if PEL_FAST_64BIT
#define PEL_BATCH_ROWS 64
#elif PEL_KNOW_SIDES
#define PEL_BATCH_ROWS 8
#else
#define PEL_BATCH_ROWS 4
#endif
#endif
#if PEL_BATCH_ROWS < 4 || PEL_BATCH_ROWS > 255
#error "PEL_BATCH_ROWS: 4 to 255 rows"
#endif

/* Pixels of the colour buffer between a paint and a format: 4 bytes of stack
 * each. */
#ifndef PEL_BUFFER_PIXELS
#if PEL_FAST_64BIT
#define PEL_BUFFER_PIXELS 32
#elif PEL_KNOW_SIDES
#define PEL_BUFFER_PIXELS 16
#else
#define PEL_BUFFER_PIXELS 4
#endif
#endif
#if PEL_BUFFER_PIXELS < 4 || PEL_BUFFER_PIXELS > 255
#error "PEL_BUFFER_PIXELS: 4 to 255 pixels"
#endif

/* PEL_NOINLINE: functions that keep their stack to themselves, so that it is
 * free again before the caller calls another. PEL_HOT: inlined where speed goes
 * before size. PEL_WALK: a loop that is a function of its own where registers
 * are few or code is to be small, and inlined elsewhere. PEL_WIDE: a function
 * of its own where 64 bits are long code, or stack is short. */
#ifdef __GNUC__
#define PEL_NOINLINE __attribute__((__noinline__))
#else
#define PEL_NOINLINE
#endif
#if PEL_FAST_64BIT && defined(__GNUC__)
#define PEL_HOT inline __attribute__((__always_inline__))
#else
#define PEL_HOT
#endif
#if defined(__thumb__) && (!defined(__thumb2__) || !PEL_KNOW_SIDES)
#define PEL_WALK PEL_NOINLINE
#elif defined(__GNUC__)
#define PEL_WALK inline __attribute__((__always_inline__))
#else
#define PEL_WALK
#endif
#if PEL_FAST_64BIT
#define PEL_WIDE
#else
#define PEL_WIDE PEL_NOINLINE
#endif

#endif
