/* Knobs of Pel. Each has a default, so no configuration file is needed; a
 * program that wants others compiles with -DPEL_CONFIG_FILE='"my_pel.h"' or
 * with -DPEL_NAME=value, the library and all that includes its headers alike:
 * some knobs are sizes of structs, and so is -Os: compile all files of core
 * with it, or none. No knob changes a pixel: only speed and size. */
#ifndef PEL_CONFIG_H
#define PEL_CONFIG_H

#include <stdint.h>

#if defined(__INT_MAX__) && __INT_MAX__ < 0x7FFFFFFF
#error "Pel needs an int of 32 bits: not for AVR, MSP430 and other 16-bit CPUs"
#endif

#ifdef PEL_CONFIG_FILE
#include PEL_CONFIG_FILE
#endif

/* Is called with the condition of a contract, such as the range of a vertex.
 * By default nothing is reported: a call that breaks its contract draws
 * nothing. To learn which call it was, include <assert.h> in a configuration
 * file and define this as assert(condition). */
#ifndef PEL_ASSERT
#define PEL_ASSERT(condition) ((void)0)
#endif

/* Is called with false for a shape that lies in the first two pixels: mostly
 * its points are pixels where sub-pixels were wanted, as pel_at(120, 120) and
 * PEL_PX(30) are. By default nothing is reported. While you write a program,
 * define it as assert(condition) too, or as a message of yours. */
#ifndef PEL_HINT
#define PEL_HINT(condition) ((void)0)
#endif

/* 1 on CPUs whose registers and division have 64 bits. */
#ifndef PEL_64BIT
#define PEL_64BIT (UINTPTR_MAX > 0xFFFFFFFFu)
#endif

/* 1: the fillers of core/fast are compiled in, which loop over the rows of
 * unclipped triangles themselves, or write four pixels at a time. They divide
 * in 64 bits, and cost about 2 KB of code, 4 KB more where a nearest texture is
 * linked, 12 KB where a bilinear one is, 6 KB where a depth buffer is; and
 * radial gradients of narrow rings cost 21 KB of stack. (Horizontal gradients
 * have a buffer of 8 KB on CPUs of 64 bits, with or without.) */
#ifndef PEL_FAST_FILLS
#define PEL_FAST_FILLS PEL_64BIT
#endif

/* 1 on CPUs that multiply 32 by 32 to 64 bits with one instruction or two: Arm
 * but for Thumb-1 (Cortex-M0, M0+, M23), RISC-V with M, and Xtensa but for the
 * ESP8266, which has no windowed ABI. */
#if defined(PEL_LONG_MULTIPLY)
#elif (defined(__ARM_ARCH) && (!defined(__thumb__) || defined(__thumb2__))) || \
    defined(__i386__) || defined(__riscv_mul) ||                               \
    defined(__XTENSA_WINDOWED_ABI__)
#define PEL_LONG_MULTIPLY 1
#else
#define PEL_LONG_MULTIPLY PEL_64BIT
#endif

/* 1 where the compiler has 16-byte GNU vectors and the CPU registers for them;
 * 0 takes plain loops that write the same bytes. */
#if defined(PEL_VECTORS)
#elif defined(__GNUC__) && (defined(__SSE2__) || defined(__ARM_NEON)) && \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define PEL_VECTORS 1
#else
#define PEL_VECTORS 0
#endif

/* 1: the smallest code and stack, for use with -Os. On a Cortex-M4 a flat
 * triangle saves 0.2 KB of 1.1, a program with a gradient 1 to 2.5 KB, all of
 * core 7 of 34. A pixel of a gradient takes 5 to 17 times as long, of a
 * texture, a dither or text up to 3 times, of flat colors as long as before
 * (docs/MATRIX.md has both); a smooth edge up to 25 times. Nothing but the
 * program sets this. The stack is as short as with the next knob. */
#ifndef PEL_SMALL_CODE
#define PEL_SMALL_CODE 0
#endif

/* 1: with -Os every paint fits every shape in 384 bytes of stack, smooth shapes
 * too, as measured on a Cortex-M0+ and M4; a paint around another, as a dither
 * of a gradient, takes what that takes as well. The default with -Os on CPUs of
 * 32 bits; not on an ESP32 or with Arduino, where there are kilobytes; 0 where
 * PEL_SMALL_CODE is 1, whose stack is as short. Text, fans, nine slices,
 * patterns, textures, blends and Phong take up to 1.6 times as long as with 0,
 * gradients in other shapes than rectangles, and horizontal ones, up to 2.5
 * times, smooth edges 3 to 12 times. With 0 -Os takes 1.1 times as long as
 * -O2, 1.6 times at most; a smooth shape has up to 2.1 KB of stack then, and 4
 * to 9 KB more code. */
#if PEL_SMALL_CODE
#undef PEL_SHORT_STACK
#define PEL_SHORT_STACK 0
#elif defined(PEL_SHORT_STACK)
#elif defined(__OPTIMIZE_SIZE__) && !defined(ESP_PLATFORM) && !defined(ARDUINO)
#define PEL_SHORT_STACK (!PEL_64BIT)
#else
#define PEL_SHORT_STACK 0
#endif

/* Rows that a shape hands to a paint at a time, 4 to 255: 8 bytes of stack
 * each; at most 4 where PEL_SHORT_STACK is 1, but in rectangles. */
#ifndef PEL_BATCH_ROWS
#define PEL_BATCH_ROWS (PEL_64BIT ? 255 : PEL_SMALL_CODE ? 4 : 8)
#endif

/* Pixels of the color buffer between a paint and a format, 4 to 255: 4 bytes
 * of stack each; at most 8 where PEL_SHORT_STACK is 1. */
#ifndef PEL_BUFFER_PIXELS
#define PEL_BUFFER_PIXELS (PEL_64BIT ? 32 : PEL_SMALL_CODE ? 4 : 16)
#endif

#if PEL_BATCH_ROWS < 4 || PEL_BATCH_ROWS > 255 || PEL_BUFFER_PIXELS < 4 || \
    PEL_BUFFER_PIXELS > 255
#error "PEL_BATCH_ROWS and PEL_BUFFER_PIXELS: 4 to 255"
#endif

#endif
