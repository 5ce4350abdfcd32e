#include "any_shape.h"

#include <stdlib.h>

#include "core/outline/outline.h"
#include "core/outline/outline_filter.h"

const char *any_name(const struct any_shape *s)
{
    static const char *const names[ANY_KINDS] = {
        "triangle",          "rectangle", "polygon", "circle", "ellipse",
        "rounded rectangle", "ring",      "sector",  "arc",    "line",
        "thick line",        "path",      "stroke"};
    return names[s->kind];
}

/* A path along the points, with a stroke. */
struct any_path {
    uint8_t verbs[3 * ANY_POINTS];
    struct pel_path path;
    struct pel_path_shape shape;
};

static struct pel_stroke stroke_of(const struct any_shape *s)
{
    static const int32_t lengths[2] = {1357, 300};
    static const struct pel_dashes dashes = {&pel_dashed, lengths, 2, 100};
    return (struct pel_stroke){.width = s->radius,
                               .cap = (enum pel_cap)((uint32_t)s->from % 3),
                               .join =
                                   (enum pel_join)((uint32_t)s->from / 4 % 3),
                               .dashes = s->to & 4 ? &dashes : NULL};
}

/* Lines and curves, closed now and then. */
static void set_path(struct any_path *p, const struct any_shape *s)
{
    uint32_t bits = (uint32_t)s->to >> 4;
    int32_t n = 0, points = 1;
    p->verbs[n++] = PEL_MOVE;
    for (; points < s->n; bits /= 4) {
        const int32_t most = s->n - points;
        const int32_t take = bits ? pel_min((int32_t)(bits % 4), most) : 1;
        points += take;
        p->verbs[n++] = (uint8_t)(take ? take : PEL_CLOSE);
    }
    p->path = (struct pel_path){p->verbs, NULL, &s->v->x, n, points};
    p->shape = (struct pel_path_shape){
        .path = &p->path, .rule = s->rule, .stroke = stroke_of(s)};
}

static struct pel_polyline_shape line_of(const struct any_shape *s)
{
    return (struct pel_polyline_shape){s->v, s->n, s->to & 16, stroke_of(s)};
}

int32_t any_reach(const struct any_shape *s)
{
    return s->kind == ANY_STROKE ? 2 * s->radius + 1028 : 0;
}

/* The path, or the stroke along it or along points. */
static void draw_path(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint,
                      bool smooth)
{
    static uint64_t scratch[1 << 18];
    const struct pel_polyline_shape line = line_of(s);
    enum pel_status status;
    struct any_path p;
    set_path(&p, s);
    if (s->kind == ANY_PATH)
        status = (smooth ? pel_smooth_path_fill : pel_path_fill)(
            surface, &p.shape, paint, scratch, sizeof scratch);
    else if (s->to & 8)
        status = (smooth ? pel_smooth_path_stroke : pel_path_stroke)(
            surface, &p.shape, paint, scratch, sizeof scratch);
    else
        status = (smooth ? pel_smooth_polyline : pel_polyline)(
            surface, &line, paint, scratch, sizeof scratch);
    if (status != PEL_OK && status != PEL_ERROR_RANGE)
        abort();
}

static void draw_polygon(const struct pel_surface *surface,
                         const struct any_shape *s,
                         const struct pel_paint *paint)
{
    int32_t scratch[PEL_POLYGON_SCRATCH_SIZE(ANY_POINTS) / 4];
    if (pel_polygon(surface, POLYGON(s), paint, scratch, sizeof scratch))
        abort();
}

/* On surfaces of any width: in parts. */
static void smooth_polygon(const struct pel_surface *surface,
                           const struct any_shape *s,
                           const struct pel_paint *paint)
{
    enum { WIDTH = 256 };
    uint64_t scratch[PEL_SMOOTH_POLYGON_SCRATCH_SIZE(ANY_POINTS, WIDTH) / 8];
    const int32_t end = surface->clip.x1;
    struct pel_surface part = *surface;
    for (; part.clip.x0 < end; part.clip.x0 += WIDTH) {
        part.clip.x1 = pel_min(part.clip.x0 + WIDTH, end);
        if (pel_smooth_polygon(&part, POLYGON(s), paint, scratch,
                               sizeof scratch) == PEL_ERROR_SCRATCH)
            abort();
    }
}

#define FILL(name) (smooth ? pel_smooth_##name : pel_##name)

/* False: the kind has no smooth edges. */
static bool draw(const struct pel_surface *surface, const struct any_shape *s,
                 const struct pel_paint *paint, bool smooth)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        FILL(triangle)(surface, s->v, paint);
        break;
    case ANY_RECTANGLE:
        FILL(rectangle)(surface, s->v[0], s->v[1], paint);
        break;
    case ANY_POLYGON:
        (smooth ? smooth_polygon : draw_polygon)(surface, s, paint);
        break;
    case ANY_CIRCLE:
        FILL(circle)(surface, s->v[0], s->radius, paint);
        break;
    case ANY_ELLIPSE:
        FILL(ellipse)(surface, ELLIPSE(s), paint);
        break;
    case ANY_ROUNDED_RECTANGLE:
        FILL(rounded_rectangle)(surface, ROUNDED(s), paint);
        break;
    case ANY_RING:
        FILL(ring)(surface, RING(s), paint);
        break;
    case ANY_SECTOR:
        FILL(sector)(surface, SECTOR(s), paint);
        break;
    case ANY_ARC:
        (smooth && s->n % 2 ? pel_smooth_arc_round : FILL(arc))(surface, ARC(s),
                                                                paint);
        break;
    case ANY_LINE:
        if (!smooth)
            pel_line(surface, s->v[0], s->v[1], paint);
        return !smooth;
    case ANY_PATH:
    case ANY_STROKE:
        draw_path(surface, s, paint, smooth);
        break;
    default:
        (!smooth         ? pel_thick_line
         : s->n % 3 == 0 ? pel_smooth_thick_line
         : s->n % 3 == 1
             ? pel_smooth_thick_line_square
             : pel_smooth_thick_line_round)(surface, THICK(s), paint);
    }
    return true;
}

void any_draw(const struct pel_surface *surface, const struct any_shape *s,
              const struct pel_paint *paint)
{
    draw(surface, s, paint, false);
}

bool any_draw_smooth(const struct pel_surface *surface,
                     const struct any_shape *s, const struct pel_paint *paint)
{
    return draw(surface, s, paint, true);
}

static bool hit_path(const struct any_shape *s, int32_t x, int32_t y)
{
    const struct pel_polyline_shape line = line_of(s);
    struct any_path p;
    set_path(&p, s);
    if (s->kind == ANY_PATH)
        return pel_hit_path_fill(&p.shape, x, y);
    return s->to & 8 ? pel_hit_path_stroke(&p.shape, x, y)
                     : pel_hit_polyline(&line, x, y);
}

bool any_hit(const struct any_shape *s, int32_t x, int32_t y)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        return pel_hit_triangle(s->v, x, y);
    case ANY_RECTANGLE:
        return pel_hit_rectangle(s->v[0], s->v[1], x, y);
    case ANY_POLYGON:
        return pel_hit_polygon(POLYGON(s), x, y);
    case ANY_CIRCLE:
        return pel_hit_circle(s->v[0], s->radius, x, y);
    case ANY_ELLIPSE:
        return pel_hit_ellipse(ELLIPSE(s), x, y);
    case ANY_ROUNDED_RECTANGLE:
        return pel_hit_rounded_rectangle(ROUNDED(s), x, y);
    case ANY_RING:
        return pel_hit_ring(RING(s), x, y);
    case ANY_SECTOR:
        return pel_hit_sector(SECTOR(s), x, y);
    case ANY_ARC:
        return pel_hit_arc(ARC(s), x, y);
    case ANY_LINE:
        return pel_hit_line(s->v[0], s->v[1], x, y);
    case ANY_PATH:
    case ANY_STROKE:
        return hit_path(s, x, y);
    default:
        return pel_hit_thick_line(THICK(s), x, y);
    }
}

static void outline_polygon(const struct pel_surface *surface,
                            const struct any_shape *s,
                            const struct pel_paint *paint)
{
    int32_t scratch[PEL_POLYGON_OUTLINE_SCRATCH_SIZE(ANY_POINTS) / 4];
    if (pel_polygon_outline(surface, POLYGON(s), paint, scratch,
                            sizeof scratch))
        abort();
}

/* Shapes that have no outline function: by the filter. */
static void outline_rim(const struct pel_surface *surface,
                        const struct any_shape *s,
                        const struct pel_paint *paint)
{
    enum { SPANS = PEL_OUTLINE_FILTER_SPANS(22) }; /* of 42 pixels */
    struct pel_span memory[SPANS];
    struct pel_outline_filter filter;
    if (!pel_outline_filter_begin(&filter, surface, paint, memory, SPANS))
        return;
    any_draw(&filter.surface, s, &filter.paint);
    pel_outline_filter_end(&filter);
}

void any_draw_outline(const struct pel_surface *surface,
                      const struct any_shape *s, const struct pel_paint *paint)
{
    switch (s->kind) {
    case ANY_TRIANGLE:
        pel_triangle_outline(surface, s->v, paint);
        break;
    case ANY_RECTANGLE:
        pel_rectangle_outline(surface, s->v[0], s->v[1], paint);
        break;
    case ANY_POLYGON:
        outline_polygon(surface, s, paint);
        break;
    case ANY_CIRCLE:
        pel_circle_outline(surface, s->v[0], s->radius, paint);
        break;
    case ANY_ELLIPSE:
        pel_ellipse_outline(surface, ELLIPSE(s), paint);
        break;
    case ANY_ROUNDED_RECTANGLE:
        pel_rounded_rectangle_outline(surface, ROUNDED(s), paint);
        break;
    case ANY_SECTOR:
        pel_arc_outline(surface, SECTOR(s), paint);
        break;
    default:
        outline_rim(surface, s, paint);
    }
}
