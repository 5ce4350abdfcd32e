#include "patch.h"

#include "../format/span32.h"
#include "../format/word32.h"
#include "ramp_lanes.h"
#include "ramp_vector.h"

#if PEL_PATCHES

/* A fill on its way. */
struct fill {
    const struct pel_patchwork *work;
    const struct pel_spans *rows;
    struct pel_ramp_mixer mixer;
    struct pel_span whole; /* pixels that are in every row of the strip */
    bool in_place;         /* colours are the surface's pixels */
    bool pairs; /* and what is left of the centre is a mirror image */
};

/* Pixels from (x, y) on, and where their colours go: those of its mirror image
 * too, unless that is NULL. */
struct patch {
    int32_t x, y, rows;
    int size;
    pel_color *out, *image;
    ptrdiff_t stride; /* in colours */
};

static int32_t width_of(const struct patch *p)
{
    return PEL_GRID_WIDTH >> p->size;
}

/* The pixels of line y that are in a patch; may be empty. */
static struct pel_span part_of(const struct fill *f, const struct patch *p,
                               int32_t y)
{
    const struct pel_span *row = &f->rows->span[y - f->rows->y];
    return (struct pel_span){pel_max(row->x0, p->x),
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
        const struct pel_span row = part_of(f, p, y);
        empty = row.x0 >= row.x1;
    }
    return empty;
}

/* Where the mirror image of n pixels from x on begins. */
static int32_t image_of(const struct fill *f, int32_t x, int32_t n)
{
    return (f->work->curve->center.x >> 7) - x - n;
}

static void color_run(const struct fill *f, const struct pel_run *run,
                      pel_color *out)
{
    f->work->colors(f->work->paint, &f->mixer, run, out);
}

/* Pixels too near to the centre, row by row: their colours need not be mirrored
 * to the last bit. */
static void color_near(const struct fill *f, const struct patch *p)
{
    for (int32_t i = 0; i < p->rows; i++) {
        const struct pel_span row = part_of(f, p, p->y + i);
        struct pel_run run = {row.x0, p->y + i, row.x1 - row.x0};
        if (run.n <= 0)
            continue;
        color_run(f, &run, p->out + i * p->stride + (row.x0 - p->x));
        run.x = image_of(f, run.x, run.n);
        if (p->image)
            color_run(f, &run, p->image + i * p->stride);
    }
}

/* Pixels for which a padded ramp has ended. */
static void color_outside(const struct fill *f, const struct patch *p)
{
    const struct pel_ramp *ramp = f->work->ramp;
    const pel_value32 last = pel_make_value32(ramp->colors[ramp->n - 1]);
    for (int32_t i = 0; i < p->rows; i++) {
        pel_span32(p->out + i * p->stride, width_of(p), last);
        if (p->image)
            pel_span32(p->image + i * p->stride, width_of(p), last);
    }
}

/* From right to left into the mirror image. */
static void mirror(const struct patch *p)
{
    const int32_t last = width_of(p) - 4;
    for (int32_t i = 0; i < p->rows; i++) {
        const pel_color *from = p->out + i * p->stride;
        pel_color *to = p->image + i * p->stride;
        for (int32_t u = 0; u <= last; u += 4) {
            const pel_u32x4 four = pel_get_u32x4(from + last - u);
            pel_put_u32x4(to + u, PEL_LANES(four, four, 3, 2, 1, 0));
        }
    }
}

/* Four pixels in doubt, u to the right of a patch's first and v below; and the
 * four of the mirror image, whose cubics may be others. */
static void settle(const struct fill *f, const struct patch *p, int32_t u,
                   int32_t v)
{
    struct pel_run run = {p->x + u, p->y + v, 4};
    color_run(f, &run, p->out + v * p->stride + u);
    run.x = image_of(f, run.x, 4);
    if (p->image)
        color_run(f, &run, p->image + v * p->stride + (width_of(p) - 4 - u));
}

/* False where too many pixels would be in doubt. */
static bool color_far(const struct fill *f, const struct patch *p,
                      struct pel_point way)
{
    struct pel_grid g;
    if (!pel_patch_grid(f->work, way, p->size, &g))
        return false;
    g.rows = p->rows;
    g.out = p->out;
    g.stride = p->stride;
    g.doubts = 0;
    if (g.padded)
        f->mixer.rows_padded(&f->mixer, &g);
    else
        f->mixer.rows(&f->mixer, &g);
    if (p->image)
        mirror(p);
    for (int32_t i = 0; i < g.doubts; i++)
        settle(f, p, g.doubt[i].u, g.doubt[i].v);
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

static void color(const struct fill *f, const struct patch *p);

static void color_quarters(const struct fill *f, const struct patch *p)
{
    const int32_t wide = width_of(p) / 2, high = PEL_GRID_ROWS / 2 >> p->size;
    for (int32_t i = 0; i < p->rows; i += high) {
        struct patch q = {p->x,
                          p->y + i,
                          pel_min(high, p->rows - i),
                          p->size + 1,
                          p->out + i * p->stride,
                          NULL,
                          p->stride};
        if (p->image)
            q.image = p->image + i * p->stride + wide;
        color(f, &q);
        q.x += wide;
        q.out += wide;
        if (p->image)
            q.image -= wide;
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
    else if (square < pel_patch_far[p->size] && p->size < PEL_PATCH_SIZES - 1)
        color_quarters(f, p);
    else if (square < pel_patch_far[p->size] || !color_far(f, p, way))
        color_near(f, p);
}

/* A patch of the largest size, by way of a buffer. */
static void color_and_put(struct fill *f, struct patch *p)
{
    pel_color colors[PEL_GRID_WIDTH * PEL_GRID_ROWS];
    p->out = colors;
    p->stride = PEL_GRID_WIDTH;
    color(f, p);
    for (int32_t y = p->y; y < p->y + p->rows; y++, p->out += p->stride) {
        const struct pel_span row = part_of(f, p, y);
        if (row.x0 < row.x1)
            pel_put_colors(f->rows->surface, row.x0, y, row.x1 - row.x0,
                           p->out + (row.x0 - p->x));
    }
}

static void color_in_place(const struct fill *f, struct patch *p)
{
    p->out = pel_address32(f->rows->surface, p->x, p->y);
    p->stride = f->rows->surface->stride / 4;
    color(f, p);
}

/* A patch of the largest size, which may be empty. */
static void color_one(struct fill *f, struct patch *p)
{
    p->image = NULL;
    if (f->in_place && is_whole(f, p))
        color_in_place(f, p);
    else if (!is_empty(f, p))
        color_and_put(f, p);
}

/* Where to begin a patch that goes beyond the strip: sooner, where pixels may
 * be coloured twice and so all of it fits, which is faster. */
static int32_t last_of(const struct fill *f, const struct patch *p,
                       struct pel_span all)
{
    const int32_t sooner = all.x1 - PEL_GRID_WIDTH;
    const bool fits = f->in_place && sooner < p->x && sooner >= f->whole.x0 &&
                      all.x1 == f->whole.x1;
    return fits ? sooner : p->x;
}

/* Patches from the axis to both sides, the left one the mirror image of the
 * right one. A column on the axis is in both. */
static void color_pairs(struct fill *f, struct patch *p, struct pel_span all)
{
    const bool symmetric = image_of(f, all.x0, 0) == all.x1;
    struct patch left = *p;
    p->x = f->work->curve->center.x >> 8;
    while (p->x < all.x1 || image_of(f, p->x, 0) > all.x0) {
        if (symmetric)
            p->x = last_of(f, p, all);
        left.x = image_of(f, p->x, PEL_GRID_WIDTH);
        if (is_whole(f, p) && is_whole(f, &left)) {
            p->image = pel_address32(f->rows->surface, left.x, p->y);
            color_in_place(f, p);
        } else {
            color_one(f, p);
            color_one(f, &left);
        }
        p->x += PEL_GRID_WIDTH;
    }
}

/* From the first pixel of lines y to y + n - 1 to behind the last. */
static struct pel_span measure(struct fill *f, int32_t y, int32_t n,
                               int32_t *covered)
{
    struct pel_span all = {INT32_MAX, INT32_MIN};
    f->whole = (struct pel_span){INT32_MIN, INT32_MAX};
    *covered = 0;
    for (int32_t i = y - f->rows->y; i < y - f->rows->y + n; i++) {
        const struct pel_span *row = &f->rows->span[i];
        f->whole.x0 = pel_max(f->whole.x0, row->x0);
        f->whole.x1 = pel_min(f->whole.x1, row->x1);
        if (row->x0 < row->x1) {
            all.x0 = pel_min(all.x0, row->x0);
            all.x1 = pel_max(all.x1, row->x1);
            *covered += row->x1 - row->x0;
        }
    }
    return all;
}

static void color_strip(struct fill *f, struct patch *p, struct pel_span all)
{
    const int32_t middle = f->work->curve->center.x >> 8;
    if (f->pairs && all.x0 < middle && middle < all.x1) {
        color_pairs(f, p, all);
        return;
    }
    for (p->x = all.x0; p->x < all.x1; p->x += PEL_GRID_WIDTH) {
        p->x = last_of(f, p, all);
        color_one(f, p);
    }
}

/* Lines y to y + n - 1: by patches, where these are few. A patch takes as long
 * as some 250 pixels along a row, and a row's beginning as long as 50. */
static void color_lines(struct fill *f, int32_t y, int32_t n)
{
    const struct pel_spans part = {f->rows->surface,
                                   &f->rows->span[y - f->rows->y], y, n, 1};
    struct patch p = {0, y, n, 0, NULL, NULL, 0};
    int32_t covered;
    const struct pel_span all = measure(f, y, n, &covered);
    if (covered == 0)
        return;
    if ((all.x1 - all.x0) / PEL_GRID_WIDTH * 250 + 250 < n * 50 + covered)
        color_strip(f, &p, all);
    else
        pel_color_paint_fill(&f->work->paint->paint, &part);
}

/* Are the ramp's cells so long that few pixels are in doubt even where cubics
 * are longest, some 500 pixels from the centre? */
static bool is_coarse(const struct pel_patchwork *work)
{
    const struct pel_point there = {PEL_PX(500), 0};
    struct pel_grid g;
    return pel_patch_grid(work, there, 0, &g);
}

void pel_patch_fill(const struct pel_patchwork *work,
                    const struct pel_spans *rows)
{
    const bool many = rows->step == 1 && rows->n > 1 &&
                      work->ramp->spread != PEL_REFLECT && is_coarse(work);
    struct fill f;
    if (!many) {
        pel_color_paint_fill(&work->paint->paint, rows);
        return;
    }
    f.work = work;
    f.rows = rows;
    f.in_place = pel_colors_in_place(work->paint, rows->surface);
    f.pairs = f.in_place && work->mirrored && work->curve->center.x % 128 == 0;
    pel_ramp_prepare(&f.mixer, work->ramp);
    for (int32_t i = 0; i < rows->n; i += PEL_GRID_ROWS)
        color_lines(&f, rows->y + i, pel_min(rows->n - i, PEL_GRID_ROWS));
}

#endif
