#include "line.h"

#include "collect.h"
#include "edge.h"

/* Both cases are walks of an exact edge (edge.h).
 *
 * Flat lines are moved down by half a pixel, so that the walk's row y answers
 * for the boundary above row y: its x is where the run of row y begins. A
 * centre exactly on the boundary belongs to the row below, that is to the run
 * towards which x runs; so a line that runs left is walked in a mirror, where
 * pixel x is pixel -1 - x. */

struct run {
    struct pel_collector *out;
    const struct pel_rect *clip;
    bool mirrored;
};

static void put(struct run *r, int32_t y, int32_t x0, int32_t x1)
{
    if (r->mirrored) {
        int32_t t = -x0;
        x0 = -x1;
        x1 = t;
    }
    x0 = pel_max(x0, r->clip->x0);
    x1 = pel_min(x1, r->clip->x1);
    if (x0 < x1)
        pel_collect(r->out, y, x0, x1);
}

/* Longer in x, and running right and down: pixels (x0, y0) to (x1, y1). */
static void flat_line(struct run *r, const struct pel_rect *p)
{
    const struct pel_point a = {pel_pixel_center(p->x0), PEL_PX(p->y0 + 1)};
    const struct pel_point b = {pel_pixel_center(p->x1), PEL_PX(p->y1 + 1)};
    struct pel_edge e = {0, 0, 0, 0, 0};
    int32_t y = pel_max(p->y0, r->clip->y0);
    int32_t end = pel_min(p->y1 + 1, r->clip->y1);
    int32_t x = p->x0;
    if (y >= end)
        return;
    if (p->y0 < p->y1)
        pel_edge_start(&e, &a, &b, pel_max(y, p->y0 + 1));
    if (y > p->y0) {
        x = e.x;
        pel_edge_next(&e);
    }
    for (; y < end; y++) {
        int32_t next = y < p->y1 ? e.x : p->x1 + 1;
        put(r, y, x, next);
        x = next;
        pel_edge_next(&e);
    }
}

/* Longer in y, running down: row y has the pixel floor(X / 256), X the line's x
 * at the row's centre; that is -ceil((128 - X - 128) / 256). */
static void steep_line(struct run *r, const struct pel_rect *p)
{
    const struct pel_point a = {-PEL_PX(p->x0), pel_pixel_center(p->y0)};
    const struct pel_point b = {-PEL_PX(p->x1), pel_pixel_center(p->y1)};
    struct pel_edge e;
    int32_t y = pel_max(p->y0, r->clip->y0);
    int32_t end = pel_min(p->y1 + 1, r->clip->y1);
    if (y >= end)
        return;
    pel_edge_start(&e, &a, &b, y);
    for (; y < end; y++) {
        put(r, y, -e.x, 1 - e.x);
        pel_edge_next(&e);
    }
}

static void draw(struct run *r, struct pel_rect p)
{
    int32_t dx = p.x1 - p.x0, dy = p.y1 - p.y0;
    if (dy > dx && dy > -dx) {
        steep_line(r, &p);
        return;
    }
    if (dx < 0) {
        r->mirrored = true;
        p.x0 = -1 - p.x0;
        p.x1 = -1 - p.x1;
    }
    flat_line(r, &p);
}

void pel_line(const struct pel_surface *surface, struct pel_point from,
              struct pel_point to, const struct pel_paint *paint)
{
    bool legal = pel_points_legal(&from, 1) && pel_points_legal(&to, 1);
    PEL_ASSERT(legal);
    if (!legal)
        return;
    struct pel_collector c;
    struct run r = {&c, &surface->clip, false};
    struct pel_rect down = {pel_pixel_of(from.x), pel_pixel_of(from.y),
                            pel_pixel_of(to.x), pel_pixel_of(to.y)};
    struct pel_rect up = {down.x1, down.y1, down.x0, down.y0};
    pel_collect_begin(&c, surface, paint);
    draw(&r, down.y0 <= down.y1 ? down : up);
    pel_collect_end(&c);
}
