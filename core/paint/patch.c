#include "patch.h"

#include "../format/span32.h"
#include "../format/word32.h"
#include "ramp_lanes.h"
#include "ramp_vector.h"

#if PEL_PATCHES

/* A fill on its way. */
struct fill {
    const struct pel_patchwork *work;
    const struct pel_rows *rows;
    struct pel_ramp_mixer mixer;
    struct pel_row whole; /* pixels that are in every row of the strip */
    ptrdiff_t stride;     /* of where colours go, in colours */
};

/* Pixels from (x, y) on, and where their colours go. */
struct patch {
    int32_t x, y, rows;
    int size;
    pel_color *out;
};

static int32_t width_of(const struct patch *p)
{
    return PEL_GRID_WIDTH >> p->size;
}

/* The pixels of line y that are in a patch; may be empty. */
static struct pel_row part_of(const struct fill *f, const struct patch *p,
                              int32_t y)
{
    const struct pel_row *row = &f->rows->row[y - f->rows->y];
    return (struct pel_row){pel_max(row->x0, p->x),
                            pel_min(row->x1, p->x + width_of(p))};
}

static bool is_whole(const struct fill *f, const struct patch *p)
{
    return p->x >= f->whole.x0 && p->x + width_of(p) <= f->whole.x1;
}

static bool is_empty(const struct fill *f, const struct patch *p)
{
    bool empty = !is_whole(f, p);
    for (int32_t y = p->y; empty && y < p->y + p->rows; y++) {
        const struct pel_row row = part_of(f, p, y);
        empty = row.x0 >= row.x1;
    }
    return empty;
}

/* Pixels too near to the centre, row by row. */
static void color_near(const struct fill *f, const struct patch *p)
{
    pel_color *out = p->out;
    for (int32_t y = p->y; y < p->y + p->rows; y++, out += f->stride) {
        const struct pel_row row = part_of(f, p, y);
        const struct pel_run run = {row.x0, y, row.x1 - row.x0};
        if (run.n > 0)
            f->work->colors(f->work->paint, &f->mixer, &run,
                            out + (row.x0 - p->x));
    }
}

/* Pixels for which a padded ramp has ended. */
static void color_outside(const struct fill *f, const struct patch *p)
{
    const struct pel_ramp *ramp = f->work->ramp;
    const pel_value32 last = pel_make_value32(ramp->colors[ramp->n - 1]);
    pel_color *out = p->out;
    for (int32_t i = 0; i < p->rows; i++, out += f->stride)
        pel_span32(out, width_of(p), last);
}

/* From around a pixel to around the one u to the right of it and v below. */
static void move(struct pel_taylor *t, uint64_t u, uint64_t v)
{
    t->at += u * (t->x + u * (t->xx + u * t->xxx) + v * (t->xy + u * t->xxy)) +
             v * (t->y + v * (t->yy + v * t->yyy + u * t->xyy));
    t->x += u * (2 * t->xx + 3 * u * t->xxx + 2 * v * t->xxy) +
            v * (t->xy + v * t->xyy);
    t->y += v * (2 * t->yy + 3 * v * t->yyy + 2 * u * t->xyy) +
            u * (t->xy + u * t->xxy);
    t->xx += 3 * u * t->xxx + v * t->xxy;
    t->xy += 2 * (u * t->xxy + v * t->xyy);
    t->yy += 3 * v * t->yyy + u * t->xyy;
}

static PEL_ALWAYS_INLINE struct pel_lanes lanes_of(uint64_t at, uint64_t d1,
                                                   uint64_t d2, uint64_t d3,
                                                   int shift)
{
    const struct pel_ramp_walk w = {at, d1, d2, d3, 0, true, 0};
    return pel_lanes_of(&w, shift);
}

/* The differences of a polynomial around its first pixel. */
static void set_lanes(struct pel_grid *g, const struct pel_taylor *t, int shift)
{
    const uint64_t xxx = 6 * t->xxx, yyy = 6 * t->yyy;
    g->row[0] =
        lanes_of(t->at, t->x + t->xx + t->xxx, 2 * t->xx + xxx, xxx, shift);
    g->row[1] = lanes_of(t->y + t->yy + t->yyy, t->xy + t->xxy + t->xyy,
                         2 * t->xxy, 0, shift);
    g->row[2] = lanes_of(2 * t->yy + yyy, 2 * t->xyy, 0, 0, shift);
    g->row[3] = lanes_of(yyy, 0, 0, 0, shift);
}

static void color_grid(const struct fill *f, const struct patch *p,
                       struct pel_grid *g, bool padded)
{
    g->width = width_of(p);
    g->rows = p->rows;
    g->out = p->out;
    g->stride = f->stride;
    g->doubts = 0;
    if (padded)
        f->mixer.rows_padded(&f->mixer, g);
    else
        f->mixer.rows(&f->mixer, g);
    for (int32_t i = 0; i < g->doubts; i++) {
        const int32_t u = g->doubt[i].u, v = g->doubt[i].v;
        const struct pel_run run = {p->x + u, p->y + v, 4};
        f->work->colors(f->work->paint, &f->mixer, &run,
                        p->out + v * f->stride + u);
    }
}

/* False where so many pixels would be in doubt, one of 32 or more, that patches
 * are no faster. A patch that a padded ramp ends in is less than 37 pixels
 * high and wide and at least 26 from the centre: no position reaches 2. */
static bool color_far(const struct fill *f, const struct patch *p,
                      struct pel_point way)
{
    const struct pel_ramp *ramp = f->work->ramp;
    const int bits = f->work->curve->bits;
    struct pel_taylor t;
    struct pel_grid g;
    f->work->taylor(f->work->curve, way.x, way.y, p->size, &t);
    const bool padded =
        ramp->spread == PEL_PAD && t.at + t.reach >= UINT64_C(1) << (bits & 63);
    const int shift = (padded ? 62 : 64) - bits;
    const uint64_t n = ramp->n == 2 ? 256 : (uint64_t)ramp->n;
    const uint64_t error = (t.error << shift >> 31) + PEL_GRID_ERROR + 2;
    if (error * n >> 27 != 0)
        return false;
    g.error = (uint32_t)error;
    t.at -= t.error;
    move(&t, 0 - (uint64_t)(PEL_GRID_WIDTH / 2 >> p->size),
         0 - (uint64_t)(PEL_GRID_ROWS / 2 >> p->size));
    set_lanes(&g, &t, shift);
    color_grid(f, p, &g, padded);
    return true;
}

/* From the paint's centre to a pixel in the middle. */
static struct pel_point way_to(const struct fill *f, const struct patch *p)
{
    const struct pel_point *center = &f->work->curve->center;
    const int32_t x = p->x + (PEL_GRID_WIDTH / 2 >> p->size);
    const int32_t y = p->y + (PEL_GRID_ROWS / 2 >> p->size);
    return (struct pel_point){pel_pixel_center(x) - center->x,
                              pel_pixel_center(y) - center->y};
}

/* Squares of how far away patches must be, in sub-pixels. */
static const int64_t far[PEL_PATCH_SIZES] = {
    INT64_C(65536) * 320 * PEL_PATCH_FAR_0 * PEL_PATCH_FAR_0,
    INT64_C(65536) * 80 * PEL_PATCH_FAR_1 *PEL_PATCH_FAR_1,
    INT64_C(65536) * 20 * PEL_PATCH_FAR_2 *PEL_PATCH_FAR_2};

static void color(const struct fill *f, const struct patch *p);

static void color_quarters(const struct fill *f, const struct patch *p)
{
    const int32_t high = PEL_GRID_ROWS / 2 >> p->size;
    for (int32_t i = 0; i < p->rows; i += high) {
        struct patch q = {p->x, p->y + i, pel_min(high, p->rows - i),
                          p->size + 1, p->out + i * f->stride};
        color(f, &q);
        q.x += width_of(&q);
        q.out += width_of(&q);
        color(f, &q);
    }
}

static void color(const struct fill *f, const struct patch *p)
{
    const struct pel_point way = way_to(f, p);
    const int64_t square = pel_square(way.x) + pel_square(way.y);
    const int32_t outside = f->work->curve->outside;
    if (is_empty(f, p))
        return;
    if (outside < PEL_CURVE_NOWHERE &&
        square >= pel_square(outside + (PEL_PX(18) >> p->size)))
        color_outside(f, p);
    else if (square >= far[p->size] && color_far(f, p, way))
        return;
    else if (p->size < PEL_PATCH_SIZES - 1)
        color_quarters(f, p);
    else
        color_near(f, p);
}

/* A patch of the largest size, by way of a buffer. */
static void color_and_put(struct fill *f, struct patch *p)
{
    pel_color colors[PEL_GRID_WIDTH * PEL_GRID_ROWS];
    p->out = colors;
    f->stride = PEL_GRID_WIDTH;
    color(f, p);
    for (int32_t y = p->y; y < p->y + p->rows; y++, p->out += f->stride) {
        const struct pel_row row = part_of(f, p, y);
        if (row.x0 < row.x1)
            pel_put_colors(f->rows->surface, row.x0, y, row.x1 - row.x0,
                           p->out + (row.x0 - p->x));
    }
}

/* Lines y to y + n - 1. */
static void color_strip(struct fill *f, int32_t y, int32_t n, bool in_place)
{
    const struct pel_surface *surface = f->rows->surface;
    struct patch p = {INT32_MAX, y, n, 0, NULL};
    int32_t end = INT32_MIN;
    f->whole = (struct pel_row){INT32_MIN, INT32_MAX};
    for (int32_t i = y - f->rows->y; i < y - f->rows->y + n; i++) {
        const struct pel_row *row = &f->rows->row[i];
        f->whole.x0 = pel_max(f->whole.x0, row->x0);
        f->whole.x1 = pel_min(f->whole.x1, row->x1);
        if (row->x0 < row->x1) {
            p.x = pel_min(p.x, row->x0);
            end = pel_max(end, row->x1);
        }
    }
    for (; p.x < end; p.x += PEL_GRID_WIDTH) {
        if (in_place && is_whole(f, &p)) {
            p.out = pel_address32(surface, p.x, y);
            f->stride = surface->stride / 4;
            color(f, &p);
        } else {
            color_and_put(f, &p);
        }
    }
}

void pel_patch_fill(const struct pel_patchwork *work,
                    const struct pel_rows *rows)
{
    const bool in_place = pel_colors_in_place(work->paint, rows->surface);
    struct fill f;
    f.work = work;
    f.rows = rows;
    pel_ramp_prepare(&f.mixer, work->ramp);
    if (!f.mixer.run || rows->step != 1 || rows->n < 2) {
        pel_color_paint_fill(&work->paint->paint, rows);
        return;
    }
    for (int32_t i = 0; i < rows->n; i += PEL_GRID_ROWS)
        color_strip(&f, rows->y + i, pel_min(rows->n - i, PEL_GRID_ROWS),
                    in_place);
}

#endif
