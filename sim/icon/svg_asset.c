/* Shapes in px become parts in units. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/icon/svg.h"

struct making {
    const struct svg *svg;
    const struct svg_shape *shape; /* at work */
    double unit;                   /* units in a px */
    struct pel_icon_part *part;
    struct pel_icon_gradient *gradient;
    struct pel_icon_stop *stop;
    uint8_t *verb;
    int16_t *point; /* x and y in turn */
    size_t parts, gradients, stops, verbs, points;
    double box[4]; /* around all parts, units */
};

static bool refuse(const struct making *m, const char *what)
{
    return message_error_at(m->svg->path, m->shape->line, "%s", what);
}

/* How wide a stroke of width 1 becomes: the root of the area that the matrix
 * gives a square. Refused where that makes an edge more than 1/8 px wrong, as
 * the matrix makes it wider one way than the other. */
static bool stroke_scale(const struct making *m, double *scale)
{
    const struct svg_matrix *const x = &m->shape->matrix;
    const double area = fabs(x->a * x->d - x->b * x->c);
    const double sum = (x->a * x->a + x->b * x->b + x->c * x->c + x->d * x->d);
    const double least = sqrt(fmax(sum - 2 * area, 0)); /* s1 - s2 */
    *scale = sqrt(area);
    return m->shape->style.width * least / 2 <= 0.125 ||
           refuse(m, "a stroke that transform makes wider one way than the "
                     "other: expected it as a path (in Inkscape: Stroke to "
                     "Path)");
}

static bool add_points(struct making *m, struct pel_icon_part *part,
                       double around)
{
    const struct svg_path *const path = &m->shape->path;
    const struct svg_matrix *const matrix = &m->shape->matrix;
    if (path->verbs > 65535 || path->points > 65535)
        return refuse(m, "a path of over 65,535 points");
    part->verbs = (uint16_t)path->verbs;
    part->points = (uint16_t)path->points;
    for (size_t i = 0; i < path->verbs; i++)
        if (!list_add(&m->verb, &m->verbs, &path->verb[i], 1))
            return false;
    for (size_t i = 0; i < path->points; i++) {
        const struct svg_point p =
            svg_at(matrix, path->point[i].x, path->point[i].y);
        const double x = p.x * m->unit, y = p.y * m->unit;
        if (!(fabs(x) + around < 32767 && fabs(y) + around < 32767))
            return refuse(m, "reaches too far beyond the icon's box: expected "
                             "shapes in it, or near it");
        const int16_t v[2] = {(int16_t)lround(x), (int16_t)lround(y)};
        if (!list_add(&m->point, &m->points, v, sizeof v))
            return false;
        m->box[0] = fmin(m->box[0], x - around);
        m->box[1] = fmin(m->box[1], y - around);
        m->box[2] = fmax(m->box[2], x + around);
        m->box[3] = fmax(m->box[3], y + around);
    }
    return true;
}

/* Adds the stops of a gradient, or finds the same ones of others. */
static bool add_stops(struct making *m, const struct svg_frame *f,
                      struct pel_icon_gradient *g)
{
    struct pel_icon_stop *const list = calloc(f->stops, sizeof *list);
    size_t same = 0;
    bool done = list || message_error("out of memory");
    for (size_t i = 0; list && i < f->stops; i++) {
        list[i].at = (uint16_t)lround(f->stop[i].at * 4096);
        list[i].color = f->stop[i].color;
    }
    while (list && same + f->stops <= m->stops &&
           memcmp(m->stop + same, list, f->stops * sizeof *list) != 0)
        same++;
    g->stop = (uint16_t)same;
    g->stops = (uint16_t)f->stops;
    if (list && same + f->stops > m->stops) {
        g->stop = (uint16_t)m->stops;
        done = m->stops + f->stops <= 65535 ||
               refuse(m, "over 65,535 stops of gradients");
        for (size_t i = 0; done && i < f->stops; i++)
            done = list_add(&m->stop, &m->stops, &list[i], sizeof *list);
    }
    free(list);
    return done;
}

/* Moves the frame of a linear gradient across its way, which changes no colour,
 * to near the middle of the icon. */
static void come_near(const struct making *m, struct svg_frame *f)
{
    struct svg_point *const v = f->v;
    const double size = fmax(m->svg->width, m->svg->height);
    const double x = v[2].x - v[0].x, y = v[2].y - v[0].y;
    const double length = hypot(x, y), bx = x / length, by = y / length;
    const double by_much =
        (m->svg->width / 2 - v[0].x) * bx + (m->svg->height / 2 - v[0].y) * by;
    for (int i = 0; i < 2; i++) {
        v[i].x += by_much * bx;
        v[i].y += by_much * by;
    }
    v[2] = (struct svg_point){v[0].x + size * bx, v[0].y + size * by};
}

static bool add_gradient(struct making *m, struct svg_frame *f, uint8_t *index)
{
    struct pel_icon_gradient g = {.radial = (uint8_t)f->radial,
                                  .spread = (uint8_t)f->spread,
                                  .focus = (uint16_t)lround(f->focus * 65536)};
    if (!f->radial)
        come_near(m, f);
    for (int i = 0; i < 3; i++) {
        const double x = f->v[i].x * m->unit, y = f->v[i].y * m->unit;
        if (!(fabs(x) < 8e6 && fabs(y) < 8e6))
            return refuse(m, "a gradient that is far longer than the icon");
        g.frame[i] = (struct pel_point){(int32_t)lround(x), (int32_t)lround(y)};
    }
    if (!add_stops(m, f, &g))
        return false;
    size_t i = 0;
    while (i < m->gradients && memcmp(&m->gradient[i], &g, sizeof g) != 0)
        i++;
    *index = (uint8_t)i;
    if (i == PEL_ICON_PROGRAM)
        return refuse(m, "over 254 gradients: expected fewer, or a PNG");
    return i < m->gradients ||
           list_add(&m->gradient, &m->gradients, &g, sizeof g);
}

static bool set_colors(struct making *m, bool stroke,
                       struct pel_icon_part *part, bool *seen)
{
    const struct svg_style *const s = &m->shape->style;
    struct svg_frame frame;
    bool done = svg_resolve(m->svg, m->shape, stroke, &frame);
    if (!done)
        return false;
    part->gradient = (stroke ? s->stroke : s->fill).kind == SVG_CURRENT
                         ? PEL_ICON_PROGRAM
                         : PEL_ICON_FLAT;
    part->color = frame.color;
    *seen = pel_alpha(frame.color) > 0;
    for (size_t i = 0; i < frame.stops; i++)
        *seen = *seen || pel_alpha(frame.stop[i].color) > 0;
    if (*seen && frame.stops)
        done = add_gradient(m, &frame, &part->gradient);
    free(frame.stop);
    return done;
}

static bool add_fill(struct making *m)
{
    struct pel_icon_part part = {.kind = (uint8_t)m->shape->style.rule};
    bool seen = false;
    if (m->shape->style.fill.kind == SVG_NONE)
        return true;
    return set_colors(m, false, &part, &seen) &&
           (!seen || (add_points(m, &part, 0) &&
                      list_add(&m->part, &m->parts, &part, sizeof part)));
}

/* A miter reaches as far as its limit says. */
static bool add_stroke(struct making *m)
{
    const struct svg_style *const s = &m->shape->style;
    const double limit = fmin(fmax(s->miter_limit, 1), 16);
    struct pel_icon_part part = {.kind = PEL_ICON_STROKE,
                                 .cap = (uint8_t)s->cap,
                                 .join = (uint8_t)s->join,
                                 .miter_limit = (uint16_t)lround(limit * 256)};
    double scale;
    bool seen = false;
    if (s->stroke.kind == SVG_NONE || !(s->width > 0))
        return true;
    if (!set_colors(m, true, &part, &seen))
        return false;
    if (!seen)
        return true;
    if (s->dashed)
        return refuse(m, "stroke-dasharray: expected a stroke without dashes");
    if (!stroke_scale(m, &scale))
        return false;
    const double width = s->width * scale * m->unit;
    const double half =
        width / 2 * (s->join == PEL_JOIN_MITER ? fmax(limit, 1.5) : 1.5);
    if (!(width < 65535))
        return refuse(m, "a stroke as wide as the icon");
    part.width = (uint16_t)lround(fmax(width, 1));
    return add_points(m, &part, half) &&
           list_add(&m->part, &m->parts, &part, sizeof part);
}

/* The largest power of two by which all points fit. */
static double unit_of(const struct svg *svg)
{
    double far = fmax(svg->width, svg->height);
    for (size_t i = 0; i < svg->shapes; i++) {
        const struct svg_shape *const s = &svg->shape[i];
        double box[4];
        svg_path_box(&s->path, &s->matrix, box);
        const double around = s->style.stroke.kind == SVG_NONE
                                  ? 0
                                  : s->style.width * 2 *
                                        fmax(hypot(s->matrix.a, s->matrix.b),
                                             hypot(s->matrix.c, s->matrix.d));
        for (int k = 0; k < 4; k++)
            if (fabs(box[k]) + around < 32767)
                far = fmax(far, fabs(box[k]) + around);
    }
    return exp2(floor(log2(32000 / far)));
}

bool svg_to_asset(const struct svg *svg, struct pel_icon_asset *asset)
{
    struct making m = {.svg = svg,
                       .unit = unit_of(svg),
                       .box = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    const double w = svg->width * m.unit, h = svg->height * m.unit;
    static const struct svg_shape none = {.line = 0};
    m.shape = &none;
    if (!(lround(w) > 0 && lround(h) > 0 && fmax(w, h) >= 256))
        return refuse(&m, "its box is too small beside what it draws");
    for (size_t i = 0; i < svg->shapes; i++) {
        m.shape = &svg->shape[i];
        if (!add_fill(&m) || !add_stroke(&m))
            return false;
    }
    if (m.parts == 0 || m.parts > 65535)
        return message_error_at(svg->path, 0, "%s",
                                m.parts ? "has over 65,535 shapes"
                                        : "draws nothing: expected shapes");
    bool strokes = false;
    for (size_t i = 0; i < m.parts; i++)
        strokes = strokes || m.part[i].kind == PEL_ICON_STROKE;
    *asset =
        (struct pel_icon_asset){.magic = PEL_ICON_MAGIC,
                                .version = PEL_ICON_VERSION,
                                .strokes = strokes,
                                .width = (uint16_t)lround(w),
                                .height = (uint16_t)lround(h),
                                .left = (int16_t)fmax(floor(m.box[0]), -32767),
                                .top = (int16_t)fmax(floor(m.box[1]), -32767),
                                .right = (int16_t)fmin(ceil(m.box[2]), 32767),
                                .bottom = (int16_t)fmin(ceil(m.box[3]), 32767),
                                .parts = (uint16_t)m.parts,
                                .gradients = (uint16_t)m.gradients,
                                .stops = (uint16_t)m.stops,
                                .verbs = (uint32_t)m.verbs,
                                .points = (uint32_t)m.points,
                                .part = m.part,
                                .gradient = m.gradient,
                                .stop = m.stop,
                                .verb = m.verb,
                                .point = m.point};
    return true;
}
