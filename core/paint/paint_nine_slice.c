#include "paint_nine_slice.h"

/* Texel `at` of the picture is shown from the pixel asked for on, and so are
 * the texels behind it, or it alone, over so many pixels. */
struct run {
    int32_t at, n;
    bool one;
};

/* A stretched texel is the one at the pixel's centre, (2 x + 1) middle /
 * (2 room), so it is seen up to the pixel x' where (2 x' + 1) middle reaches
 * 2 room (at + 1). All are below 2^16 times 2^15. */
static struct run stretched(int32_t x, int32_t middle, int32_t room)
{
    const uint32_t m = (uint32_t)middle, r = 2 * (uint32_t)room;
    const uint32_t at = (2 * (uint32_t)x + 1) * m / r;
    const uint32_t end = (r * (at + 1) + m - 1) / m / 2;
    return (struct run){(int32_t)at, (int32_t)end - x, true};
}

/* At pixel x of the box, 0..size - 1. */
static struct run run_at(const struct pel_nine_slice_side *s, bool tiled,
                         int32_t x)
{
    const int32_t end = s->size - s->behind, inside = x - s->before;
    if (inside < 0)
        return (struct run){x, pel_min(-inside, s->size - x), false};
    if (x >= end)
        return (struct run){s->before + s->middle + x - end, s->size - x,
                            false};
    struct run run = {inside % s->middle, 0, false};
    run.n = s->middle - run.at;
    if (!tiled)
        run = stretched(inside, s->middle, end - s->before);
    run.at += s->before;
    run.n = pel_min(run.n, end - x);
    return run;
}

/* Is the pixel, counted from the beginning of the box, in it? */
static bool is_in(const struct pel_nine_slice_side *s, int32_t x)
{
    return x >= 0 && x < s->size;
}

static void load_run(const struct pel_surface *picture, int32_t row,
                     const struct run *run, pel_color *colors)
{
    picture->format->load(picture, picture->bounds.x0 + run->at, row,
                          run->one ? 1 : run->n, colors);
    for (int32_t i = 1; run->one && i < run->n; i++)
        colors[i] = colors[0];
}

static void colors_of(const struct pel_color_paint *paint, int32_t x, int32_t y,
                      int32_t n, pel_color *colors)
{
    const struct pel_nine_slice *const p = (const void *)paint;
    x -= p->across.from;
    y -= p->down.from;
    const bool shown = is_in(&p->down, y);
    if (shown)
        y = p->picture->bounds.y0 + run_at(&p->down, p->tiled, y).at;
    for (struct run run; n > 0; n -= run.n, x += run.n, colors += run.n) {
        run.n = 1;
        *colors = 0;
        if (!shown || !is_in(&p->across, x))
            continue;
        run = run_at(&p->across, p->tiled, x);
        run.n = pel_min(run.n, n);
        load_run(p->picture, y, &run, colors);
    }
}

enum pel_status pel_nine_slice_init(struct pel_nine_slice *paint,
                                    const struct pel_surface *picture,
                                    const struct pel_rect *middle,
                                    const struct pel_rect *box)
{
    if (!paint)
        return PEL_ERROR_NULL;
    pel_paint_clear(&paint->base.paint);
    if (!picture || !middle || !box)
        return PEL_ERROR_NULL;
    if (!picture->format || !picture->format->load)
        return PEL_ERROR_FORMAT;
    if (!pel_rect_inside(middle, &picture->bounds) || pel_rect_empty(middle) ||
        !pel_bounds_legal(box))
        return PEL_ERROR_RANGE;
    pel_color_paint_init(&paint->base, colors_of, false);
    paint->picture = picture;
    const struct pel_rect *const all = &picture->bounds;
    paint->across = (struct pel_nine_slice_side){
        box->x0, box->x1 - box->x0, middle->x0 - all->x0,
        middle->x1 - middle->x0, all->x1 - middle->x1};
    paint->down = (struct pel_nine_slice_side){
        box->y0, box->y1 - box->y0, middle->y0 - all->y0,
        middle->y1 - middle->y0, all->y1 - middle->y1};
    paint->tiled = false;
    return PEL_OK;
}
