#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "canvas.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "cases.h"
#include "check.h"

enum { POISON = 0xA5 };

static size_t page_size(void)
{
    return (size_t)sysconf(_SC_PAGESIZE);
}

static bool is_pages(const struct canvas *c)
{
    return c->layout->format->id == PEL_FORMAT_MONO1_PAGES;
}

/* Where a pixel begins: byte of the memory, and the bit in that byte. */
static size_t offset_of(const struct canvas *c, int32_t x, int32_t y, int *bit)
{
    const struct pel_rect *b = &c->surface.bounds;
    int32_t dx = x - b->x0, dy = y - b->y0, bits = c->layout->bits;
    ptrdiff_t line = is_pages(c) ? dy / 8 : dy;
    ptrdiff_t at = (ptrdiff_t)c->first + line * c->surface.stride;
    *bit = 0;
    if (is_pages(c)) {
        *bit = dy % 8;
        at += dx;
    } else if (bits < 8) {
        *bit = 8 - bits - dx * bits % 8;
        at += dx * bits / 8;
    } else {
        at += (ptrdiff_t)dx * bits / 8;
    }
    return (size_t)at;
}

static uint32_t get(const struct canvas *c, const uint8_t *memory, int32_t x,
                    int32_t y)
{
    int bit;
    size_t at = offset_of(c, x, y, &bit);
    if (c->layout->bits < 8)
        return (uint32_t)memory[at] >> bit & ((1u << c->layout->bits) - 1);
    uint32_t v = 0;
    for (int i = 0; i < c->layout->bits; i += 8)
        v |= (uint32_t)memory[at++] << i;
    return v;
}

static void put(const struct canvas *c, uint8_t *memory, int32_t x, int32_t y,
                uint32_t v)
{
    int bit;
    size_t at = offset_of(c, x, y, &bit);
    if (c->layout->bits < 8) {
        uint32_t mask = ((1u << c->layout->bits) - 1) << bit;
        memory[at] = (uint8_t)((memory[at] & ~mask) | (v << bit & mask));
        return;
    }
    for (int i = 0; i < c->layout->bits; i += 8)
        memory[at++] = (uint8_t)(v >> i);
}

uint32_t canvas_pixel(const struct canvas *c, int32_t x, int32_t y)
{
    return get(c, c->memory, x, y);
}

uint32_t canvas_pixel_before(const struct canvas *c, int32_t x, int32_t y)
{
    return get(c, c->before, x, y);
}

static void map_memory(struct canvas *c, size_t size)
{
    size_t page = page_size(), body = (size + page - 1) / page * page;
    if (c->map && c->map_size >= body + 2 * page)
        return;
    if (c->map)
        munmap(c->map, c->map_size);
    free(c->before);
    c->map_size = body + 2 * page;
    c->map = mmap(NULL, c->map_size, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(c->map != MAP_FAILED);
    assert_int_equal(mprotect(c->map, page, PROT_NONE), 0);
    assert_int_equal(mprotect(c->map + c->map_size - page, page, PROT_NONE), 0);
    c->before = malloc(body);
    assert_non_null(c->before);
}

static void fill_noise(struct canvas *c, const struct pel_rect *bounds)
{
    memset(c->memory, POISON, c->size);
    for (int32_t y = bounds->y0; y < bounds->y1; y++)
        for (int32_t x = bounds->x0; x < bounds->x1; x++) {
            struct random r = {(uint64_t)(uint32_t)y << 32 | (uint32_t)x};
            put(c, c->memory, x, y, random_word(&r));
        }
    memcpy(c->before, c->memory, c->size);
}

void canvas_open(struct canvas *c, const struct pel_format *format,
                 const struct pel_rect *bounds, unsigned style)
{
    c->layout = layout_of(format);
    int32_t lines = bounds->y1 - bounds->y0;
    int32_t stride = pel_stride(format, bounds->x1 - bounds->x0);
    bool up = style & CANVAS_UP && !is_pages(c);
    if (is_pages(c))
        lines = (lines + 7) / 8;
    if (style & CANVAS_PADDED)
        stride += 3 * format->word;
    c->size = (size_t)lines * (size_t)stride;
    map_memory(c, c->size);
    c->memory = c->map + page_size();
    if (style & CANVAS_AT_END)
        c->memory = c->map + c->map_size - page_size() - c->size;
    c->first = up ? (size_t)(lines - 1) * (size_t)stride : 0;
    assert_int_equal(pel_surface_init_rect(&c->surface, format,
                                           c->memory + c->first,
                                           up ? -stride : stride, bounds),
                     PEL_OK);
    fill_noise(c, bounds);
}

void canvas_copy(struct canvas *c, const struct canvas *from)
{
    const struct pel_rect *r = &c->surface.bounds, *f = &from->surface.bounds;
    for (int32_t y = r->y0; y < r->y1; y++)
        for (int32_t x = r->x0; x < r->x1; x++)
            put(c, c->memory, x, y,
                canvas_pixel(from, x - r->x0 + f->x0, y - r->y0 + f->y0));
    memcpy(c->before, c->memory, c->size);
}

void canvas_check_same(const struct canvas *a, const struct canvas *b)
{
    const struct pel_rect *r = &a->surface.bounds, *q = &b->surface.bounds;
    const int32_t dx = q->x0 - r->x0, dy = q->y0 - r->y0;
    for (int32_t y = r->y0; y < r->y1; y++)
        for (int32_t x = r->x0; x < r->x1; x++)
            if (canvas_pixel(a, x, y) != canvas_pixel(b, x + dx, y + dy))
                fail_msg("%s: pixel %d, %d: expected %x, got %x; %s",
                         a->layout->name, x, y, canvas_pixel(a, x, y),
                         canvas_pixel(b, x + dx, y + dy), cases_replay());
}

void canvas_check_part(const struct canvas *whole, const struct canvas *part)
{
    const struct pel_rect *r = &part->surface.clip;
    for (int32_t y = r->y0; y < r->y1; y++)
        for (int32_t x = r->x0; x < r->x1; x++)
            if (canvas_pixel(whole, x, y) != canvas_pixel(part, x, y))
                fail_msg("%s: pixel %d, %d is %x, in the whole %x; %s",
                         part->layout->name, x, y, canvas_pixel(part, x, y),
                         canvas_pixel(whole, x, y), cases_replay());
    canvas_check(part);
}

void canvas_check(const struct canvas *c)
{
    const struct pel_rect *clip = &c->surface.clip;
    uint8_t *expected = malloc(c->size);
    assert_non_null(expected);
    memcpy(expected, c->before, c->size);
    for (int32_t y = clip->y0; y < clip->y1; y++)
        for (int32_t x = clip->x0; x < clip->x1; x++)
            put(c, expected, x, y, canvas_pixel(c, x, y));
    bool same = memcmp(expected, c->memory, c->size) == 0;
    free(expected);
    if (!same)
        fail_msg("%s: a write outside the clip; %s", c->layout->name,
                 cases_replay());
}

void canvas_check_drawn(const struct canvas *c, const struct hits *shape,
                        canvas_color *color, const void *paint)
{
    const struct pel_rect *b = &c->surface.bounds;
    for (int32_t y = b->y0; y < b->y1; y++)
        for (int32_t x = b->x0; x < b->x1; x++) {
            const uint32_t before = canvas_pixel_before(c, x, y);
            const bool drawn = !shape || hits_at(shape, x, y);
            const pel_color source = drawn ? color(paint, x, y) : 0;
            const uint32_t want =
                drawn ? layout_over(c->layout, before, source) : before;
            if (canvas_pixel(c, x, y) != want)
                fail_msg("%s: pixel %d, %d: before %x, %08x over it: expected "
                         "%x, got %x; %s",
                         c->layout->name, x, y, before, source, want,
                         canvas_pixel(c, x, y), cases_replay());
        }
    canvas_check(c);
}

pel_color canvas_flat(const void *flat, int32_t x, int32_t y)
{
    (void)x, (void)y;
    return ((const struct pel_flat *)flat)->color;
}

pel_color canvas_gouraud(const void *gouraud, int32_t x, int32_t y)
{
    const struct pel_gouraud *g = gouraud;
    pel_color c = 0;
    for (int k = 0; k < 4; k++)
        c |= (g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k]) >>
             24 << 8 * k;
    return c;
}

int32_t canvas_difference(const struct canvas *a, const struct canvas *b)
{
    const struct pel_rect *r = &a->surface.bounds;
    int32_t most = 0;
    for (int32_t y = r->y0; y < r->y1; y++)
        for (int32_t x = r->x0; x < r->x1; x++)
            for (int k = 0; k < 24; k += 8) {
                const int32_t off =
                    (int32_t)(canvas_pixel(a, x, y) >> k & 255) -
                    (int32_t)(canvas_pixel(b, x, y) >> k & 255);
                most = pel_max(most, pel_magnitude(off));
            }
    return most;
}
