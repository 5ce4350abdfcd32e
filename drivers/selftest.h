/* Does core draw on this board, built by this compiler, what it draws
 * everywhere? A small picture of triangles, circles, a gradient, dither and
 * alpha is drawn in bands, and its CRC-32 compared with that of the tests.
 *
 *     static uint32_t memory[PEL_SELFTEST_SIZE / 4];
 *     if (pel_selftest(&pel_rgb565_be, memory, sizeof memory) != PEL_OK)
 *         blink();
 *
 * Nothing else links this, nor what it needs of core. */
#ifndef PEL_DRIVERS_SELFTEST_H
#define PEL_DRIVERS_SELFTEST_H

#include <pel/pel.h>

PEL_BEGIN_DECLS

/* Bytes of memory for any format, aligned to 4. */
#define PEL_SELFTEST_SIZE (48 * 8 * 4)

/* PEL_ERROR_DEVICE: the picture is another one; PEL_ERROR_FORMAT: a format that
 * no display of core has, or one that takes no alpha (pel_rgb565_le_fill and
 * pel_rgb565_be_fill: test those that they are of); PEL_ERROR_NULL,
 * PEL_ERROR_SIZE, PEL_ERROR_ALIGNMENT. */
enum pel_status pel_selftest(const struct pel_format *format, void *memory,
                             size_t size);

/* In every format that is linked, with GNU C and ELF, where a format can be
 * asked whether it is there; PEL_ERROR_FORMAT elsewhere. The first error. */
enum pel_status pel_selftest_all(void *memory, size_t size);
PEL_END_DECLS
#endif
