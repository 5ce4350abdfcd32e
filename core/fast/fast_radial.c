/* Radial gradients of narrow rings: pixel by pixel, by tables that are made for
 * every batch of rows. Squares of distances are in 512ths, as in
 * paint_radial.c, and those in the tables less the batch's least. */
#include "../base/sqrt.h"
#include "../format/word.h"
#include "../paint/cells.h"
#include "../paint/paint_radial.h"

#if PEL_FAST_FILLS && PEL_64BIT

/* Rings of WIDE px and more, on average, are walked faster than looked up. */
enum { MOST = 2048, WIDE = 3 };

/* A pixel lies beyond a ring when its square is larger than `outer`. */
struct ring {
    uint32_t outer, value;
};

/* The rings of a batch; neighbours of one pixel value are one. */
struct rings {
    const struct pel_radial *paint;
    const struct pel_spans *spans;
    int64_t least, range; /* of squares; `range` first is the largest */
    int32_t n;
    int32_t pad; /* 1/256 px: the radius where the last one begins */
    int shift;
    struct ring ring[MOST];
    uint16_t at[MOST]; /* the ring of the square i << shift */
};

static int32_t root_of(int64_t square)
{
    struct pel_root root;
    pel_square_root((uint64_t)square, &root);
    return (int32_t)root.root;
}

/* The ring that holds a pixel, by its square, whole. */
static int32_t ring_at(const struct pel_radial *p, int64_t square)
{
    const int64_t n = p->base.cells;
    return square == 0 ? 0
                       : (int32_t)(((root_of(square - 1) + 1) * n - 1) /
                                   p->rings.radius);
}

static pel_color color_of(const struct pel_radial *p, int32_t ring)
{
    const struct pel_gradient *g = &p->base;
    const int32_t cell = ring + p->first;
    return g->color(g, pel_cells_index(g, cell / g->cells, cell % g->cells));
}

/* Sets the least and the largest square of the batch, and returns how many
 * pixels it has. */
static int32_t set_extent(struct rings *r)
{
    const struct pel_spans *spans = r->spans;
    const struct pel_point c = r->paint->rings.center;
    const int32_t y0 = spans->y, y1 = y0 + (spans->n - 1) * spans->step + 1;
    struct pel_span hull;
    const int32_t pixels = pel_spans_hull(&hull, spans->span, spans->n);
    if (pixels == 0)
        return 0;
    r->least =
        pel_radial_square(r->paint, pel_nearest_pixel(hull.x0, hull.x1, c.x),
                          pel_nearest_pixel(y0, y1, c.y));
    r->range =
        pel_radial_square(r->paint, pel_farthest_pixel(hull.x0, hull.x1, c.x),
                          pel_farthest_pixel(y0, y1, c.y));
    return pixels;
}

/* Rings `first` to `last`: false where the walk by cells is right or faster. */
static bool set_rings(struct rings *r, int32_t first, int32_t last)
{
    const struct pel_radial *p = r->paint;
    const struct pel_format *format = r->spans->surface->format;
    int32_t inner = 0, second = 0;
    r->n = r->pad = 0;
    for (int32_t k = first; k <= last; k++) {
        const pel_color color = color_of(p, k);
        const uint32_t value = format->pack(color);
        if (pel_alpha(color) != 255)
            return false;
        if (r->n == 0 || value != r->ring[r->n - 1].value) {
            second = r->n == 1 ? inner : second;
            r->pad = inner;
            if (r->n == MOST ||
                (r->n > 9 && inner - second >= 256 * WIDE * (r->n - 2)))
                return false;
            r->ring[r->n++].value = value;
        }
        inner = (int32_t)((k + INT64_C(1)) * p->rings.radius / p->base.cells);
        r->ring[r->n - 1].outer =
            (uint32_t)(((pel_square(inner) - p->low) >> 9) - r->least);
    }
    r->ring[r->n - 1].outer = UINT32_MAX;
    return r->pad - second < 256 * WIDE * (r->n - 2);
}

static void set_index(struct rings *r, int32_t pixels)
{
    const uint32_t range = (uint32_t)r->range;
    const uint32_t most = (uint32_t)pel_min(pixels, MOST);
    uint32_t k = 0;
    for (r->shift = 0; range >> r->shift >= most; r->shift++)
        ;
    for (uint32_t i = 0; i <= range >> r->shift; i++) {
        while (r->ring[k].outer < i << r->shift)
            k++;
        r->at[i] = (uint16_t)k;
    }
}

static PEL_ALWAYS_INLINE void draw_row(const struct rings *r, int32_t y,
                                       struct pel_span span, int bytes)
{
    const int32_t n = span.x1 - span.x0, shift = r->shift;
    const uintptr_t row = pel_address(r->spans->surface, span.x0, y, bytes);
    uint32_t square =
        (uint32_t)((pel_radial_square(r->paint, span.x0, y) >> 9) - r->least);
    uint32_t step =
        (uint32_t)(pel_pixel_center(span.x0) - r->paint->rings.center.x + 128);
    const struct ring *const ring = r->ring;
    for (int32_t i = 0; i < n; i++) {
        size_t k = r->at[square >> shift];
        k += ring[k].outer < square; /* without a branch: often, or not */
        while (ring[k].outer < square)
            k++;
        if (bytes == 4)
            ((pel_word32 *)row)[i] = ring[k].value;
        else
            ((pel_word16 *)row)[i] = (pel_word16)ring[k].value;
        square += step;
        step += 256;
    }
}

/* The pixels of a row inside the circle where padding begins. */
static struct pel_span unpadded(const struct rings *r, int32_t y,
                                struct pel_span span)
{
    const struct pel_point c = r->paint->rings.center;
    const int64_t square =
        pel_square(r->pad) - pel_square(pel_pixel_center(y) - c.y);
    const int32_t half = square < 0 ? 0 : root_of(square);
    if (square < 0 || span.x0 >= span.x1)
        return (struct pel_span){span.x1, span.x1};
    const int32_t x =
        pel_max(span.x0, pel_min(pel_first_pixel(c.x - half), span.x1));
    return (struct pel_span){
        x, pel_max(x, pel_min(pel_first_pixel(c.x + half + 1), span.x1))};
}

/* The padding goes to the format some rows at a time, to spare the stack. */
static PEL_ALWAYS_INLINE void draw_rows(const struct rings *r, bool padded,
                                        int bytes)
{
    enum { ROWS = 32 };
    struct pel_span pad[2][ROWS];
    struct pel_spans part = *r->spans;
    const struct pel_span *span = part.span;
    for (int32_t left = part.n, y = part.y; left > 0; left -= part.n) {
        part.n = pel_min(left, ROWS);
        part.y = y;
        for (int32_t i = 0; i < part.n; i++, span++, y += part.step) {
            struct pel_span in = *span;
            if (padded) {
                in = unpadded(r, y, in);
                pad[0][i] = (struct pel_span){span->x0, in.x0};
                pad[1][i] = (struct pel_span){in.x1, span->x1};
            }
            draw_row(r, y, in, bytes);
        }
        for (int i = 0; padded && i < 2; i++) {
            part.span = pad[i];
            part.surface->format->fill(&part, r->ring[r->n - 1].value);
        }
    }
}

bool pel_radial_fast(const struct pel_radial *p, const struct pel_spans *spans)
{
    const struct pel_format *format = spans->surface->format;
    const int32_t end = p->base.ramp.spread == PEL_PAD
                            ? p->base.cells - 1 - p->first
                            : INT32_MAX;
    struct rings r;
    r.paint = p;
    r.spans = spans;
    if ((format->fill != pel_fill32 && format->fill != pel_fill16) ||
        p->width >= 256 * WIDE)
        return false;
    const int32_t pixels = set_extent(&r);
    if (pixels == 0 || r.range >> 40)
        return pixels == 0;
    const int32_t first = pel_min(ring_at(p, r.least), end);
    const int32_t last = pel_min(ring_at(p, r.range), end);
    r.least >>= 9;
    if (last - first > 8 * pixels || !set_rings(&r, first, last))
        return false;
    const bool padded = last == end && pel_square(r.pad) < r.range;
    if (padded)
        r.range = pel_square(r.pad);
    r.range = (r.range >> 9) - r.least;
    set_index(&r, pixels);
    if (format->fill == pel_fill32)
        draw_rows(&r, padded, 4);
    else
        draw_rows(&r, padded, 2);
    return true;
}

#endif
