/* Integer edge functions, stepped from pixel to pixel over the box, with the
 * top-left rule: exact until they overflow. 32-bit ones wrap here, as they do
 * on all CPUs that people use. */
#include "fill.h"

struct line {
    uint64_t at, dx, dy; /* at the box's first centre; to the right, and down */
};

/* Positive inside; 0 on edges that are not owned becomes -1. In units of
 * 2^-bits px. */
static void line_set(struct line *l, const struct pel_point *a,
                     const struct pel_point *b, const struct pel_rect *box,
                     int bits)
{
    const int down = 8 - bits;
    const int64_t dx = (b->x - a->x) >> down, dy = (b->y - a->y) >> down;
    const int64_t px = pel_pixel_center(box->x0) - a->x;
    const int64_t py = pel_pixel_center(box->y0) - a->y;
    const bool owned = dy < 0 || (dy == 0 && dx > 0);
    l->at = (uint64_t)(dx * (py >> down) - dy * (px >> down) - !owned);
    l->dx = (uint64_t)(-dy * (1 << bits));
    l->dy = (uint64_t)(dx * (1 << bits));
}

/* The n pixels of a row. */
static void row_64(uint32_t *row, int32_t n, const struct line l[3],
                   uint32_t pixel)
{
    uint64_t a = l[0].at, b = l[1].at, c = l[2].at;
    for (; n > 0; n--, row++) {
        if (!((a | b | c) >> 63))
            *row = pixel;
        a += l[0].dx;
        b += l[1].dx;
        c += l[2].dx;
    }
}

static void row_32(uint32_t *row, int32_t n, const struct line l[3],
                   uint32_t pixel)
{
    uint32_t a = (uint32_t)l[0].at, b = (uint32_t)l[1].at;
    uint32_t c = (uint32_t)l[2].at;
    for (; n > 0; n--, row++) {
        if (!((a | b | c) >> 31))
            *row = pixel;
        a += (uint32_t)l[0].dx;
        b += (uint32_t)l[1].dx;
        c += (uint32_t)l[2].dx;
    }
}

static PEL_ALWAYS_INLINE void draw(const struct pel_surface *s,
                                   const struct pel_point v[3], uint32_t pixel,
                                   int bits, bool wide)
{
    struct line l[3];
    const struct pel_rect box = fill_box(s, v);
    const int64_t area = pel_triangle_area(v);
    for (int i = 0; i < 3; i++) {
        const struct pel_point *a = &v[i], *b = &v[(i + 1) % 3];
        line_set(&l[i], area < 0 ? b : a, area < 0 ? a : b, &box, bits);
    }
    for (int32_t y = box.y0; area && y < box.y1; y++) {
        uint32_t *row = (uint32_t *)(void *)pel_surface_line(s, y);
        (wide ? row_64 : row_32)(row + box.x0 - s->bounds.x0, box.x1 - box.x0,
                                 l, pixel);
        for (int i = 0; i < 3; i++)
            l[i].at += l[i].dy;
    }
}

static void draw_64(const struct pel_surface *s, const struct pel_point v[3],
                    uint32_t pixel)
{
    draw(s, v, pixel, 8, true);
}

static void draw_32(const struct pel_surface *s, const struct pel_point v[3],
                    uint32_t pixel)
{
    draw(s, v, pixel, 8, false);
}

static void draw_32_4(const struct pel_surface *s, const struct pel_point v[3],
                      uint32_t pixel)
{
    draw(s, v, pixel, 4, false);
}

const struct fill_method fill_half_space_64 = {"int64 half-space", 8, draw_64};
const struct fill_method fill_half_space_32 = {"int32 half-space S=8", 8,
                                               draw_32};
const struct fill_method fill_half_space_32_4 = {"int32 half-space S=4", 4,
                                                 draw_32_4};
