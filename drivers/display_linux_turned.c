#include "display_linux_turned.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Columns of the device that are copied together, so that a line of the cache
 * is read for all of its pixels when the frame is turned on its side. */
enum { STRIP = 16 };

/* Pixels of the frame that are a row of the device: the first, and from each to
 * the next. */
struct walk {
    int32_t x, y, dx, dy;
};

static bool is_sideways(const struct pel_turned *turned)
{
    return turned->turns & 1;
}

/* The size as the device has it. */
static struct pel_point size_of(const struct pel_turned *turned)
{
    const struct pel_rect *const b = &turned->upright.bounds;
    struct pel_point size = {b->x1, b->y1};
    if (is_sideways(turned))
        size = (struct pel_point){b->y1, b->x1};
    return size;
}

/* Row y of the device, from x on. A quarter clockwise brings the
 * pixel (x, y) of the frame to (width - 1 - y, x). */
static struct walk walk_at(const struct pel_turned *turned, int32_t x,
                           int32_t y)
{
    const struct pel_point size = size_of(turned);
    switch (turned->turns) {
    case 0:
        return (struct walk){x, y, 1, 0};
    case 1:
        return (struct walk){y, size.x - 1 - x, 0, -1};
    case 2:
        return (struct walk){size.x - 1 - x, size.y - 1 - y, -1, 0};
    default:
        return (struct walk){size.y - 1 - y, x, 0, 1};
    }
}

struct pel_rect pel_turned_place(const struct pel_turned *turned,
                                 const struct pel_rect *a)
{
    const struct pel_point size = size_of(turned);
    switch (turned->turns) {
    case 0:
        return *a;
    case 1:
        return (struct pel_rect){size.x - a->y1, a->x0, size.x - a->y0, a->x1};
    case 2:
        return (struct pel_rect){size.x - a->x1, size.y - a->y1, size.x - a->x0,
                                 size.y - a->y0};
    default:
        return (struct pel_rect){a->y0, size.y - a->x1, a->y1, size.y - a->x0};
    }
}

/* n pixels of `size` bytes, which is inlined, `step` bytes apart in the frame.
 */
static PEL_ALWAYS_INLINE void copy_pixels(uint8_t *to, const uint8_t *from,
                                          ptrdiff_t step, int32_t n,
                                          size_t size)
{
    for (; n > 0; n--, to += size, from += step)
        memcpy(to, from, size);
}

static void copy_bytes(const struct pel_turned *turned, int32_t x, int32_t y,
                       int32_t n, const struct pel_turned_memory *m)
{
    const struct walk walk = walk_at(turned, x, y);
    const ptrdiff_t bytes = m->bits / 8;
    const ptrdiff_t step = walk.dx * bytes + walk.dy * turned->upright.stride;
    const uint8_t *const from =
        pel_surface_line(&turned->upright, walk.y) + walk.x * bytes;
    uint8_t *const to = m->pixels + y * m->stride + x * bytes;
    if (step == bytes)
        memcpy(to, from, (size_t)(n * bytes));
    else if (bytes == 4)
        copy_pixels(to, from, step, n, 4);
    else if (bytes == 2)
        copy_pixels(to, from, step, n, 2);
    else
        copy_pixels(to, from, step, n, (size_t)bytes);
}

/* The upper bits of a pixel of the frame, mono1 or gray8. */
static uint32_t level_at(const struct pel_surface *frame, int32_t x, int32_t y,
                         int32_t bits)
{
    const uint8_t *const line = pel_surface_line(frame, y);
    if (frame->format->bits == 1)
        return line[x / 8] >> (7 - x % 8) & 1;
    return (uint32_t)line[x] >> (8 - bits);
}

static void copy_bits(const struct pel_turned *turned, int32_t x, int32_t y,
                      int32_t n, const struct pel_turned_memory *m)
{
    const struct walk walk = walk_at(turned, x, y);
    const uint32_t mask = (1u << m->bits) - 1;
    for (int32_t i = 0; i < n; i++) {
        const int32_t bit = (x + i) * m->bits, in = bit % 8;
        const int shift = m->low_first ? in : 8 - m->bits - in;
        uint8_t *const to = m->pixels + y * m->stride + bit / 8;
        uint32_t level = level_at(&turned->upright, walk.x + i * walk.dx,
                                  walk.y + i * walk.dy, m->bits);
        if (m->inverted)
            level ^= mask;
        *to = (uint8_t)((*to & ~(mask << shift)) | level << shift);
    }
}

void pel_turned_copy(const struct pel_turned *turned,
                     const struct pel_rect *area,
                     const struct pel_turned_memory *m)
{
    const struct pel_rect r = pel_turned_place(turned, area);
    const int32_t strip = is_sideways(turned) ? STRIP : r.x1 - r.x0;
    for (int32_t x = r.x0, n; x < r.x1; x += n) {
        n = pel_min(strip, r.x1 - x);
        for (int32_t y = r.y0; y < r.y1; y++)
            (m->bits < 8 ? copy_bits : copy_bytes)(turned, x, y, n, m);
    }
}

void pel_turned_change(struct pel_turned *turned, const struct pel_rect *a)
{
    struct pel_rect *const c = &turned->changed;
    if (pel_rect_empty(a))
        return;
    *c = pel_rect_empty(c) ? *a : pel_rect_join(c, a);
}

void pel_turned_forget(struct pel_turned *turned)
{
    turned->changed = (struct pel_rect){0, 0, 0, 0};
}

int pel_turned_make(struct pel_turned *turned, const struct pel_format *format,
                    const struct pel_turned_memory *m, int32_t turns)
{
    struct pel_rect bounds = {0, 0, m->width, m->height};
    *turned = (struct pel_turned){.turns = turns};
    if (is_sideways(turned))
        bounds = (struct pel_rect){0, 0, m->height, m->width};
    const int32_t stride = pel_stride(format, bounds.x1);
    void *const pixels = calloc((size_t)bounds.y1, (size_t)stride);
    if (pixels && pel_surface_init_rect(&turned->upright, format, pixels,
                                        stride, &bounds) == PEL_OK)
        return 0;
    free(pixels);
    turned->upright.pixels = NULL;
    return ENOMEM;
}

void pel_turned_free(struct pel_turned *turned)
{
    free(turned->upright.pixels);
    turned->upright.pixels = NULL;
}

bool pel_turned_parse(const char *text, int32_t *turns)
{
    static const char *const angles[4] = {"0", "90", "180", "270"};
    for (*turns = 0; *turns < 4; ++*turns)
        if (strcmp(text, angles[*turns]) == 0)
            return true;
    return false;
}
