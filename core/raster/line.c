#include "line.h"

#include "../format/word.h"
#include "edge.h"

/* Opaque lines of one color, inside the clip, in short runs: pixel by pixel, by
 * Bresenham's walk. Step k along the longer side is floor(k across / length +
 * 1/2) steps across, where x does not fall with y, and ceil(.. - 1/2) where it
 * does: at a tie it is the right one of two columns, the lower one of two rows.
 */
struct pixels {
    uint32_t pixel;
    int32_t n, length, across;
    int32_t error; /* in [-2 length, 0) */
};

static PEL_ALWAYS_INLINE void store(uintptr_t address, uint32_t pixel,
                                    int bytes)
{
    if (bytes == 4) {
        *(pel_word32 *)address = pixel;
    } else if (bytes == 2) {
        *(pel_word16 *)address = (pel_word16)pixel;
    } else {
        uint8_t *const p = (uint8_t *)address;
        p[0] = (uint8_t)pixel;
        if (bytes == 3) {
            p[1] = (uint8_t)(pixel >> 8);
            p[2] = (uint8_t)(pixel >> 16);
        }
    }
}

/* The address moves by `along` from pixel to pixel, and by `aside`, too, where
 * the error becomes 0 or more. Without a branch, which could not be guessed. */
static PEL_ALWAYS_INLINE void put_words(const struct pixels *l, uintptr_t p,
                                        uintptr_t along, uintptr_t aside,
                                        int bytes)
{
    const uint32_t pixel = l->pixel;
    const int32_t up = 2 * l->across, down = 2 * l->length;
    int32_t error = l->error, n = l->n;
    do {
        store(p, pixel, bytes);
        p += along;
        error += up;
        if (error >= 0) {
            error -= down;
            p += aside;
        }
    } while (--n);
}

/* Where pixels share bytes, a step in one direction moves their mask around,
 * and the byte by `carry` where it leaves that; a step in the other moves the
 * byte. */
struct bits {
    uint8_t *byte;
    uint32_t mask, pixels; /* the bits of the pixel; it in every place */
    int turn;              /* of the mask to the left, 1 to 7 */
    bool up;               /* to higher bits of the byte */
    ptrdiff_t carry, other;
};

static PEL_NOINLINE void put_bits(const struct pixels *l, const struct bits *b,
                                  bool turns)
{
    const int32_t across = 2 * l->across, length = 2 * l->length;
    uint8_t *byte = b->byte;
    uint32_t mask = b->mask;
    int32_t error = l->error, n = l->n;
    do {
        *byte = (uint8_t)(*byte ^ ((*byte ^ b->pixels) & mask));
        error += across;
        const bool both = error >= 0;
        if (both)
            error -= length;
        if (both || turns) {
            const uint32_t before = mask;
            mask = (mask << b->turn | mask << b->turn >> 8) & 0xFF;
            if ((mask > before) != b->up)
                byte += b->carry;
        }
        if (both || !turns)
            byte += b->other;
    } while (--n);
}

/* In pages bits go down, elsewhere to the right, the high one first. */
static void put_packed(const struct pixels *l, const struct pel_surface *s,
                       const struct pel_rect *p, bool flat)
{
    const bool pages = s->format->id == PEL_FORMAT_MONO1_PAGES;
    const int bits = s->format->bits;
    const int32_t side = p->x1 < p->x0 ? -1 : 1;
    const int32_t x = p->x0 - s->bounds.x0, y = p->y0 - s->bounds.y0;
    const uint32_t ones = bits == 4 ? 0x11 : bits == 2 ? 0x55 : 0xFF;
    struct bits b = {s->pixels, 1u << (y & 7), l->pixel * ones, 1, true,
                     s->stride, side};
    if (pages) {
        b.byte += (y >> 3) * (ptrdiff_t)s->stride + x;
    } else {
        b.byte += y * (ptrdiff_t)s->stride + (x * bits >> 3);
        b.mask = (0xFF00u >> bits & 0xFF) >> (x * bits & 7);
        b.up = side < 0;
        b.turn = b.up ? bits : 8 - bits;
        b.carry = side;
        b.other = s->stride;
    }
    put_bits(l, &b, flat != pages);
}

/* False when it is another line, or a format of no usual display. */
static PEL_HOT_LOOP bool put_pixels(const struct pel_surface *s,
                                    const struct pel_rect *p,
                                    const struct pel_paint *paint)
{
    const struct pel_format *f = s->format;
    const struct pel_rect *clip = &s->clip;
    const int32_t left = pel_min(p->x0, p->x1), right = pel_max(p->x0, p->x1);
    const int32_t dx = right - left, dy = p->y1 - p->y0;
    if (dx >= 8 * dy || paint->fill != pel_flat_fill ||
        f->id > PEL_FORMAT_GRAY2 || !f->fill || left < clip->x0 ||
        right >= clip->x1 || p->y0 < clip->y0 || p->y1 >= clip->y1)
        return false;
    const pel_color color = ((const struct pel_flat *)paint)->color;
    if (pel_alpha(color) != 255)
        return false;
    const bool flat = dx >= dy;
    struct pixels l = {f->pack(color), 0, pel_max(dx, dy), pel_min(dx, dy), 0};
    l.n = l.length + 1;
    l.error = -l.length - (!flat && p->x1 < p->x0);
    if (f->bits < 8) {
        put_packed(&l, s, p, flat);
        return true;
    }
    const int bytes = f->bits / 8;
    const uintptr_t at = pel_address(s, p->x0, p->y0, bytes);
    const uintptr_t down = (uintptr_t)(ptrdiff_t)s->stride;
    const uintptr_t beside = (uintptr_t)(p->x1 < p->x0 ? -bytes : bytes);
    const uintptr_t along = flat ? beside : down, aside = flat ? down : beside;
    if (bytes == 2)
        put_words(&l, at, along, aside, 2);
    else if (bytes == 4)
        put_words(&l, at, along, aside, 4);
    else if (bytes == 3)
        put_words(&l, at, along, aside, 3);
    else
        put_words(&l, at, along, aside, 1);
    return true;
}

/* Other lines have one span in each row; an exact edge (edge.h) says where it
 * is.
 *
 * Flat lines, no higher than wide: the span of a row goes from where the line
 * crosses the row's upper boundary to where it crosses the lower one. The edge
 * is the line moved down by half a pixel, so that it has its x on boundaries.
 * A line to the left is mirrored, pixel x to pixel -1 - x, because a crossing
 * exactly in the centre of a column belongs to the row below.
 *
 * Steep lines: the pixel floor(x) at the row's centre. An edge rounds its x up,
 * so it is that of -x, and the pixel is minus its result. */
struct walk {
    struct pel_rect p; /* pixels (x0, y0) to (x1, y1), downwards */
    struct pel_edge edge;
    int32_t x; /* flat: begin of the span in this row */
    bool flat, mirrored;
};

/* Starts a flat line at row y, with the edge at the boundary below it. */
static void start_flat(struct walk *w, int32_t y)
{
    const struct pel_rect *p = &w->p;
    const struct pel_point a = {pel_pixel_center(p->x0), PEL_PX(p->y0 + 1)};
    const struct pel_point b = {pel_pixel_center(p->x1), PEL_PX(p->y1 + 1)};
    w->x = p->x0;
    if (p->y0 == p->y1)
        return;
    pel_edge_start(&w->edge, &a, &b, pel_max(y, p->y0 + 1));
    if (y > p->y0) {
        w->x = w->edge.x;
        pel_edge_next(&w->edge);
    }
}

static void start_steep(struct walk *w, int32_t y)
{
    const struct pel_rect *p = &w->p;
    const struct pel_point a = {-PEL_PX(p->x0), pel_pixel_center(p->y0)};
    const struct pel_point b = {-PEL_PX(p->x1), pel_pixel_center(p->y1)};
    pel_edge_start(&w->edge, &a, &b, y);
}

static PEL_NOINLINE void start(struct walk *w, int32_t y)
{
    const int32_t dx = w->p.x1 - w->p.x0, dy = w->p.y1 - w->p.y0;
    w->flat = dy <= dx || dy <= -dx;
    w->mirrored = w->flat && dx < 0;
    if (w->mirrored) {
        w->p.x0 = -1 - w->p.x0;
        w->p.x1 = -1 - w->p.x1;
    }
    if (w->flat)
        start_flat(w, y);
    else
        start_steep(w, y);
}

/* Sets the span of row y and moves on to the next row. */
static PEL_INLINE_LOOP void next_span(struct walk *w, int32_t y,
                                      struct pel_span *span)
{
    int32_t x = -w->edge.x, next = x + 1;
    if (w->flat) {
        x = w->x;
        next = y < w->p.y1 ? w->edge.x : w->p.x1 + 1;
        w->x = next;
    }
    span->x0 = w->mirrored ? -next : x;
    span->x1 = w->mirrored ? -x : next;
    pel_edge_next(&w->edge);
}

/* Paints rows [y, end), clipped. */
static void fill(struct walk *w, const struct pel_surface *surface, int32_t y,
                 int32_t end, const struct pel_paint *paint)
{
    const struct pel_rect *clip = &surface->clip;
    struct pel_span span[PEL_ROWS];
    struct pel_spans spans = {surface, span, y, 0, 1};
    for (; spans.y < end; spans.y += spans.n) {
        spans.n = pel_min(end - spans.y, PEL_ROWS);
        for (int32_t i = 0; i < spans.n; i++) {
            next_span(w, spans.y + i, &span[i]);
            span[i].x0 = pel_max(span[i].x0, clip->x0);
            span[i].x1 = pel_min(span[i].x1, clip->x1);
        }
        paint->fill(paint, &spans);
    }
}

void pel_line(const struct pel_surface *surface, struct pel_point from,
              struct pel_point to, const struct pel_paint *paint)
{
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, 0));
    if (!legal)
        return;
    struct walk w;
    if (from.y <= to.y)
        w.p = (struct pel_rect){pel_pixel_of(from.x), pel_pixel_of(from.y),
                                pel_pixel_of(to.x), pel_pixel_of(to.y)};
    else
        w.p = (struct pel_rect){pel_pixel_of(to.x), pel_pixel_of(to.y),
                                pel_pixel_of(from.x), pel_pixel_of(from.y)};
    w.edge = (struct pel_edge){0, 0, 0, 0, 0};
    const struct pel_rect *clip = &surface->clip;
    const int32_t y = pel_max(w.p.y0, clip->y0);
    const int32_t end = pel_min(w.p.y1 + 1, clip->y1);
    if (y >= end || pel_min(w.p.x0, w.p.x1) >= clip->x1 ||
        pel_max(w.p.x0, w.p.x1) < clip->x0 || put_pixels(surface, &w.p, paint))
        return;
    start(&w, y);
    fill(&w, surface, y, end, paint);
}
