/* Any shape of core as a value: made at random, drawn, asked for hits, and
 * judged by the references. For tests that hold for every shape. */
#ifndef TESTS_SUPPORT_ANY_SHAPE_H
#define TESTS_SUPPORT_ANY_SHAPE_H

#include "cases.h"
#include "core/hit/hit.h"
#include "core/pel.h"

enum any_kind {
    ANY_TRIANGLE,
    ANY_RECTANGLE,
    ANY_POLYGON,
    ANY_CIRCLE,
    ANY_ELLIPSE,
    ANY_ROUNDED_RECTANGLE,
    ANY_RING,
    ANY_SECTOR,
    ANY_ARC,
    ANY_LINE,
    ANY_THICK_LINE,
    ANY_REFERENCED, /* kinds before it have a reference */
    ANY_PATH = ANY_REFERENCED,
    ANY_STROKE,
    ANY_KINDS
};

enum { ANY_POINTS = 12 };

struct any_shape {
    struct pel_point v[ANY_POINTS]; /* of round shapes v[0] is the centre */
    enum any_kind kind;
    enum pel_fill_rule rule; /* of polygons and paths */
    int32_t n;               /* points of a polygon, path or stroke */
    int32_t radius, inner;   /* or width */
    int32_t from, to; /* bits of `to` say which lines of a path are curves, and
                         what a stroke along them looks like */
};

/* The shape as core's structs have it. */
#define POLYGON(s) (&(struct pel_polygon_shape){s->v, s->n, s->rule})
#define ELLIPSE(s) (&(struct pel_ellipse_shape){s->v[0], {s->radius, s->inner}})
#define ROUNDED(s) (&(struct pel_rounded_shape){s->v[0], s->v[1], s->radius})
#define RING(s) (&(struct pel_ring_shape){s->v[0], s->inner, s->radius})
#define SECTOR(s) \
    (&(struct pel_sector_shape){s->v[0], s->radius, s->from, s->to})
#define ARC(s) \
    (&(struct pel_arc_shape){s->v[0], s->inner, s->radius, s->from, s->to})
#define THICK(s) (&(struct pel_thick_line_shape){s->v[0], s->v[1], s->radius})

const char *any_name(const struct any_shape *s);

/* Anywhere in the range; adversarial: centres, ties, limits (shapes.h), equal
 * radii, angles that are multiples of an eighth of a turn or next to one. */
void any_random(struct random *r, struct any_shape *s, enum any_kind kind,
                bool adversarial);

/* About as large as the box, its points in it or up to 6 px beside it; now and
 * then all but the last adversarial. */
void any_in_box(struct random *r, struct any_shape *s, enum any_kind kind,
                const struct pel_rect *box);

/* How many of its points count. */
int32_t any_points(const struct any_shape *s);

/* A window on its edge, or anywhere (shapes.h). */
struct pel_rect any_window(struct random *r, const struct any_shape *s,
                           int32_t size);

void any_draw(const struct pel_surface *surface, const struct any_shape *s,
              const struct pel_paint *paint);

/* What a stroke may reach beyond its points. */
int32_t any_reach(const struct any_shape *s);

/* By its smooth function; false, and nothing is drawn, when it has none. */
bool any_draw_smooth(const struct pel_surface *surface,
                     const struct any_shape *s, const struct pel_paint *paint);

bool any_hit(const struct any_shape *s, int32_t x, int32_t y);

/* Of kinds that have one. */
bool any_reference_at(const struct any_shape *s, int32_t x, int32_t y);

/* By the shape's outline function or outline/outline_filter.h; of sectors the
 * arc. */
void any_draw_outline(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint);
bool any_reference_outline_at(const struct any_shape *s, int32_t x, int32_t y);

/* For hits_check: by the references; that of fills fails when the hit test says
 * something else. */
bool any_fill_expected(const void *s, int32_t x, int32_t y);
bool any_outline_expected(const void *s, int32_t x, int32_t y);

#endif
