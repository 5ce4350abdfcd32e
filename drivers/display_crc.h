/* A display that reports a number for each frame, the same on a board and on a
 * host: so a test of a real board needs no camera. It stands before the real
 * display, which shows the frames as before:
 *
 *     static void print(const struct pel_display_crc *crc)
 *     {
 *         printf("%08lx\n", (unsigned long)crc->sum);
 *     }
 *     struct pel_display_crc crc = {.inner = &panel, .report = print};
 *     pel_display_crc_init(&display, &crc);
 *
 * The number is the sum of the CRC-32 of every row that is flushed: of its x
 * and y, two bytes each, and its colors, four bytes each, blue first. The order
 * of bands and their heights do not change it. */
#ifndef PEL_DRIVERS_DISPLAY_CRC_H
#define PEL_DRIVERS_DISPLAY_CRC_H

#include "display.h"

PEL_BEGIN_DECLS

struct pel_display_crc {
    const struct pel_display *inner;
    void (*report)(const struct pel_display_crc *crc); /* at every flip */
    uint32_t sum; /* of the frame, since the last flip */
};

/* Both structs stay the caller's. A surface that cannot be read (of a fill-only
 * format) is PEL_ERROR_FORMAT when flushed. PEL_ERROR_NULL. */
enum pel_status pel_display_crc_init(struct pel_display *display,
                                     struct pel_display_crc *crc);
PEL_END_DECLS
#endif
