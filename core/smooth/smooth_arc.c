#include "smooth_arc.h"

#include "../base/trig.h"
#include "../round/angle_range.h"
#include "arc_ends.h"
#include "ring_rows.h"
#include "smooth_ring.h"

/* The ring's rows, and what they lack of an arc. */
struct body {
    struct pel_smooth_ring_walk ring; /* first */
    struct pel_smooth_ends ends;
};

/* What a batch touches, from row y on, or up to it. */
static struct pel_rect part_of(const struct pel_smooth_batch *b, int32_t y,
                               int32_t step)
{
    struct pel_rect part = {INT32_MAX, y, INT32_MIN, y + b->n};
    for (int32_t i = 0; i < b->n; i++) {
        const struct pel_span *const full = &b->at.full[i];
        part.x0 = pel_min(part.x0, full->x0 - b->count[2 * i]);
        part.x1 = pel_max(part.x1, full->x1 + b->count[2 * i + 1]);
    }
    if (step < 0) {
        part.y0 = y - b->n + 1;
        part.y1 = y + 1;
    }
    return part;
}

static PEL_NOINLINE void paint_near(const struct body *body, int32_t y,
                                    int32_t step)
{
    const struct pel_smooth_batch *const b = &body->ring.rows.batch;
    const uint8_t *coverage = b->coverage;
    for (int32_t i = 0; i < b->n; i++) {
        const struct pel_span *const full = &b->at.full[i];
        const uint8_t *const count = b->count + 2 * i;
        const struct pel_smooth_row row = {y + i * step, full->x0 - count[0],
                                           count[0],     full->x1 - full->x0,
                                           count[1],     coverage};
        pel_smooth_ends_paint(&body->ends, &body->ring.rows.smooth, &row);
        coverage += count[0] + count[1];
    }
}

/* The batch from row y on, up or down. */
static void paint_rows(struct body *body, int32_t y, int32_t step)
{
    struct pel_smooth_rows *const rows = &body->ring.rows;
    const struct pel_rect part = part_of(&rows->batch, y, step);
    const enum pel_smooth_share share =
        pel_smooth_ends_share(&body->ends, &part);
    if (share == PEL_SMOOTH_NEAR)
        paint_near(body, y, step);
    else if (share == PEL_SMOOTH_ALL && step > 0)
        pel_smooth_paint_batch(&rows->smooth, &rows->batch);
    else if (share == PEL_SMOOTH_ALL)
        pel_smooth_paint_upwards(&rows->smooth, &rows->batch, y);
}

static void paint_batch(struct body *body)
{
    struct pel_smooth_rows *const rows = &body->ring.rows;
    const int32_t y = rows->batch.y, n = rows->batch.n;
    paint_rows(body, y, 1);
    rows->batch.n -= pel_smooth_is_own_image(rows);
    if (!PEL_SMALL_CODE && rows->twins)
        paint_rows(body, rows->image_y - y, -1);
    rows->batch.n = n;
}

/* The rows of less than half of a ring are those of a box around it. */
static PEL_NOINLINE void paint_body(const struct pel_surface *surface,
                                    const struct pel_arc_shape *arc,
                                    const struct pel_rect *box, bool round,
                                    const struct pel_paint *paint)
{
    const struct pel_ring_shape ring = {arc->center, arc->inner, arc->outer};
    struct pel_surface part = *surface;
    struct body body;
    if ((uint16_t)((uint16_t)arc->to - (uint16_t)arc->from) < 32768)
        part.clip = *box;
    if (!pel_smooth_ring_begin(&body.ring, &part, &ring, paint))
        return;
    pel_smooth_ends_set(&body.ends, arc, round);
    while (pel_smooth_ring_next(&body.ring))
        paint_batch(&body);
}

/* What is painted near the ends. */
struct tips {
    struct pel_smooth smooth;
    struct pel_smooth_ends ends;
    int bows, lines, gaps;
    struct pel_smooth_bow bow[4];
    union {
        struct pel_smooth_line line[2];
        struct pel_smooth_gap gap[4];
    } at; /* cut ends, or round ones */
};

/* An end of an arc: at its beginning the outline goes outwards. */
struct end {
    const struct pel_arc_shape *arc;
    uint16_t angle;
    bool begins;
};

/* Where the outline comes to an end from its circle, or goes on. */
static struct pel_smooth_place place_of(const struct end *end, bool comes)
{
    const struct pel_arc_shape *const arc = end->arc;
    const int32_t radius = end->begins == comes ? arc->inner : arc->outer;
    return pel_smooth_place_at(pel_direction(end->angle), radius);
}

static void add_line(struct tips *tips, const struct end *end)
{
    const struct pel_smooth_place from = place_of(end, true);
    const struct pel_smooth_place to = place_of(end, false);
    if (from.y != to.y)
        pel_smooth_line_set(&tips->at.line[tips->lines++], end->arc->center,
                            pel_direction(end->angle), from, to);
}

/* Closes what rounding leaves open between the heights of two places. */
static void add_gap(struct tips *tips, struct pel_point at, int32_t x,
                    int32_t from, int32_t to)
{
    if (from != to)
        tips->at.gap[tips->gaps++] = (struct pel_smooth_gap){at, x, from, to};
}

static void add_bow(struct tips *tips, const struct pel_smooth_bow *bow,
                    int32_t radius)
{
    if (radius == 0)
        return;
    tips->bow[tips->bows] = *bow;
    pel_smooth_bow_set(&tips->bow[tips->bows++], radius);
}

static void add_half(struct tips *tips, const struct end *end)
{
    const struct pel_arc_shape *const arc = end->arc;
    const int32_t radius = (arc->outer - arc->inner) >> 1;
    const struct pel_point at = pel_smooth_end_center(arc, end->angle);
    const int32_t up = (arc->center.y - at.y) * 256;
    const uint16_t angle = (uint16_t)(end->angle + (end->begins ? 32768 : 0));
    const struct pel_smooth_place p =
        pel_smooth_place_at(pel_direction(angle), radius);
    const struct pel_smooth_bow bow = {.center = at,
                                       .from = p,
                                       .to = {-p.x, -p.y},
                                       .first = (uint8_t)(angle >> 14),
                                       .count = 3};
    add_gap(tips, at, p.x, place_of(end, true).y + up, p.y);
    add_bow(tips, &bow, radius);
    add_gap(tips, at, -p.x, -p.y, place_of(end, false).y + up);
}

static void add_end(struct tips *tips, const struct end *end, bool round)
{
    if (round)
        add_half(tips, end);
    else
        add_line(tips, end);
}

/* Once through a quadrant, or back to it. */
static uint8_t quadrants_of(struct pel_angles a)
{
    const int32_t steps = ((a.to >> 14) - (a.from >> 14)) & 3;
    const bool back = (uint16_t)(a.to - a.from) > 16384;
    return (uint8_t)(steps == 0 && back ? 5 : steps + 1);
}

static void add_circle(struct tips *tips, struct pel_point center,
                       struct pel_angles angles, int32_t radius, bool hole)
{
    const struct pel_smooth_bow bow = {
        .center = center,
        .from = pel_smooth_place_at(pel_direction(angles.from), radius),
        .to = pel_smooth_place_at(pel_direction(angles.to), radius),
        .first = (uint8_t)(angles.from >> 14),
        .count = quadrants_of(angles),
        .hole = hole};
    add_bow(tips, &bow, radius);
}

static PEL_NOINLINE void find_tips(struct tips *tips,
                                   const struct pel_arc_shape *arc, bool round)
{
    const struct pel_angles angles = {(uint16_t)arc->from, (uint16_t)arc->to};
    const struct end begin = {arc, angles.from, true};
    const struct end end = {arc, angles.to, false};
    tips->bows = tips->lines = tips->gaps = 0;
    pel_smooth_ends_set(&tips->ends, arc, round);
    add_circle(tips, arc->center, angles, arc->outer, false);
    add_circle(tips, arc->center, angles, arc->inner, true);
    add_end(tips, &begin, round);
    add_end(tips, &end, round);
}

/* From x on: up to where. */
static PEL_NOINLINE int32_t paint_window(struct tips *tips, int32_t y,
                                         int32_t x, int32_t end)
{
    struct pel_smooth_window window;
    pel_smooth_window_begin(&window, y, x, end);
    for (int i = 0; i < tips->bows; i++)
        pel_smooth_bow_add(&tips->bow[i], &window);
    for (int i = 0; i < tips->lines; i++)
        pel_smooth_line_add(&tips->at.line[i], &window);
    for (int i = 0; i < tips->gaps; i++)
        pel_smooth_gap_add(&tips->at.gap[i], &window);
    pel_smooth_window_paint(&window, &tips->smooth);
    return window.next;
}

static void paint_columns(struct tips *tips, int32_t y,
                          const struct pel_span *columns)
{
    const struct pel_rect *const clip = &tips->smooth.target->clip;
    const int32_t end = pel_min(columns->x1, clip->x1);
    int32_t x = pel_max(columns->x0, clip->x0);
    while (x < end)
        x = paint_window(tips, y, x, end);
}

/* No column twice where both ends are near. */
static void paint_row(struct tips *tips, int32_t y)
{
    struct pel_span a, b;
    const bool first = pel_smooth_end_columns(&tips->ends, 0, y, &a);
    if (pel_smooth_end_columns(&tips->ends, 1, y, &b)) {
        if (first && a.x0 < b.x1 && b.x0 < a.x1) {
            a.x0 = pel_min(a.x0, b.x0);
            a.x1 = pel_max(a.x1, b.x1);
        } else {
            paint_columns(tips, y, &b);
        }
    }
    if (first)
        paint_columns(tips, y, &a);
}

static PEL_NOINLINE void paint_tips(const struct pel_surface *surface,
                                    const struct pel_arc_shape *arc, bool round,
                                    const struct pel_paint *paint)
{
    struct tips tips;
    if (!pel_smooth_begin(&tips.smooth, surface, paint))
        return;
    find_tips(&tips, arc, round);
    const struct pel_rect *const a = &tips.ends.end[0].box;
    const struct pel_rect *const b = &tips.ends.end[1].box;
    const int32_t end = pel_min(pel_max(a->y1, b->y1), surface->clip.y1);
    int32_t y = pel_max(pel_min(a->y0, b->y0), surface->clip.y0);
    for (; y < end; y++)
        paint_row(&tips, y);
}

static bool is_legal(const struct pel_arc_shape *arc)
{
    return pel_point_legal(arc->center) && pel_radius_legal(arc->inner) &&
           pel_radius_legal(arc->outer);
}

/* The pixels of the clip that the arc may touch; false: none, or no angle. A
 * half disc reaches half of the arc's width beyond its ray, and coverage a
 * pixel further than the centres that a shape covers. */
static PEL_NOINLINE bool find_box(const struct pel_surface *surface,
                                  const struct pel_arc_shape *arc, bool round,
                                  struct pel_rect *box)
{
    struct pel_angle_range range;
    const int32_t beyond = round ? (arc->outer - arc->inner) >> 9 : 0;
    *box = surface->clip;
    return pel_angle_range_start(&range, arc, box, beyond + 2, box->y0);
}

static void paint_arc(const struct pel_surface *surface,
                      const struct pel_arc_shape *arc, bool round,
                      const struct pel_paint *paint)
{
    struct pel_angles angles;
    struct pel_rect box;
    const bool legal = is_legal(arc);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&arc->center, 1, arc->outer));
    if (!legal || arc->outer <= arc->inner ||
        !pel_angles_set(&angles, arc->from, arc->to) ||
        !find_box(surface, arc, round, &box))
        return;
    if (angles.from == angles.to) {
        const struct pel_ring_shape ring = {arc->center, arc->inner,
                                            arc->outer};
        pel_smooth_ring(surface, &ring, paint);
        return;
    }
    paint_body(surface, arc, &box, round, paint);
    paint_tips(surface, arc, round, paint);
}
void pel_smooth_arc(const struct pel_surface *surface,
                    const struct pel_arc_shape *arc,
                    const struct pel_paint *paint)
{
    paint_arc(surface, arc, false, paint);
}

void pel_smooth_arc_round(const struct pel_surface *surface,
                          const struct pel_arc_shape *arc,
                          const struct pel_paint *paint)
{
    paint_arc(surface, arc, true, paint);
}

void pel_smooth_sector(const struct pel_surface *surface,
                       const struct pel_sector_shape *sector,
                       const struct pel_paint *paint)
{
    const struct pel_arc_shape arc = {sector->center, 0, sector->radius,
                                      sector->from, sector->to};
    paint_arc(surface, &arc, false, paint);
}
