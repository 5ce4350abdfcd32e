/* Screens that do not show memory as it was drawn: turned, or of pixels that
 * share bytes in an order of their own. A frame is drawn upright into ordinary
 * memory; what was flushed is copied from there, pixel by pixel where it is
 * turned. The same pixels are shown as without.
 *
 * Also the shadow of a framebuffer that is not turned: rows are copied then. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_TURNED_H
#define PEL_DRIVERS_DISPLAY_LINUX_TURNED_H

#include <pel/pel.h>

PEL_BEGIN_DECLS

/* What the device reads. Pixel values of 8 bits or more are those of the frame;
 * of fewer, the upper bits of its grey. */
struct pel_turned_memory {
    uint8_t *pixels; /* of the upper left pixel, at the beginning of a byte */
    ptrdiff_t stride;
    int32_t width, height; /* px, as the device has them */
    uint8_t bits;          /* of a pixel: 1, 2, 8, 16, 24 or 32 */
    bool low_first;        /* 1, 2: the left pixel is in the low bits */
    bool inverted;         /* 1, 2: 0 is white */
};

struct pel_turned {
    struct pel_surface upright; /* in memory of its own */
    struct pel_rect changed;    /* of it, since it was forgotten */
    int32_t turns;              /* quarters, clockwise, of the picture: 0..3 */
};

/* Makes the upright frame, black, for a device of that size. `format` has the
 * bits of the memory: mono1 where it has 1, gray8 where it has 2. An errno, or
 * 0. */
int pel_turned_make(struct pel_turned *turned, const struct pel_format *format,
                    const struct pel_turned_memory *memory, int32_t turns);
void pel_turned_free(struct pel_turned *turned);

/* What has changed, and nothing. */
void pel_turned_change(struct pel_turned *turned, const struct pel_rect *area);
void pel_turned_forget(struct pel_turned *turned);

/* Copies an area of the frame, which lies inside it. */
void pel_turned_copy(const struct pel_turned *turned,
                     const struct pel_rect *area,
                     const struct pel_turned_memory *memory);

/* Where it is seen, in px of the device. */
struct pel_rect pel_turned_place(const struct pel_turned *turned,
                                 const struct pel_rect *area);

/* The text of rotate=: 0, 90, 180 or 270. False when it is anything else. */
bool pel_turned_parse(const char *text, int32_t *turns);
PEL_END_DECLS
#endif
