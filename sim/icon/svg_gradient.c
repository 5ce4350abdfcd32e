/* The paint of a shape: a colour, or a gradient with what it takes from others.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/icon/svg.h"

static const struct svg_gradient *find(const struct svg *svg, const char *id)
{
    for (size_t i = 0; i < svg->gradients; i++)
        if (svg->gradient[i].id && strcmp(svg->gradient[i].id, id) == 0)
            return &svg->gradient[i];
    return NULL;
}

/* Takes from `other` what is not given. */
static void inherit(struct svg_gradient *g, const struct svg_gradient *other)
{
    for (int i = 0; i < SVG_LENGTHS; i++)
        if (!g->length[i].given)
            g->length[i] = other->length[i];
    g->spread = g->spread < 0 ? other->spread : g->spread;
    g->user_space = g->user_space < 0 ? other->user_space : g->user_space;
    if (!g->has_matrix) {
        g->has_matrix = other->has_matrix;
        g->matrix = other->matrix;
    }
    if (g->stops == 0) {
        g->stop = other->stop;
        g->stops = other->stops;
    }
}

/* A chain that leads back to itself ends. */
static struct svg_gradient whole(const struct svg *svg,
                                 const struct svg_gradient *g)
{
    struct svg_gradient all = *g;
    for (int i = 0; i < 100 && g && g->href; i++) {
        g = find(svg, g->href);
        if (g)
            inherit(&all, g);
    }
    return all;
}

static double length(const struct svg_gradient *g, int i, double percent,
                     double whole)
{
    const struct svg_length *const l = &g->length[i];
    if (!l->given)
        return percent * whole;
    return l->value * (l->percent ? whole : 1);
}

/* The frame in the gradient's own space; `all` is what percents are of. */
static void own_frame(const struct svg_gradient *g, struct svg_point all,
                      struct svg_frame *f)
{
    const double x1 = length(g, SVG_X1, 0, all.x);
    const double y1 = length(g, SVG_Y1, 0, all.y);
    const double dx = length(g, SVG_X2, 1, all.x) - x1;
    const double dy = length(g, SVG_Y2, 0, all.y) - y1;
    f->v[0] = (struct svg_point){x1, y1};
    f->v[1] = (struct svg_point){x1 + dx, y1 + dy};
    f->v[2] = (struct svg_point){x1 - dy, y1 + dx};
    f->focus = 0;
}

/* Around the focus, k from the centre in radii: sqrt(u^2 + v^2) + k u is the
 * place on the way when u is 1 - k^2 radii long and v sqrt(1 - k^2). */
static void own_circle(const struct svg_gradient *g, struct svg_point all,
                       struct svg_frame *f)
{
    const double r =
        length(g, SVG_R, 0.5, hypot(all.x, all.y) / 1.4142135623730951);
    const double cx = length(g, SVG_CX, 0.5, all.x);
    const double cy = length(g, SVG_CY, 0.5, all.y);
    const double x = g->length[SVG_FX].given ? length(g, SVG_FX, 0, all.x) : cx;
    const double y = g->length[SVG_FY].given ? length(g, SVG_FY, 0, all.y) : cy;
    const double far = hypot(x - cx, y - cy);
    const double k = r > 0 ? fmin(far / r, 0.99) : 0;
    const double c = far > 0 ? (x - cx) / far : 1;
    const double s = far > 0 ? (y - cy) / far : 0;
    const double a = r * (1 - k * k), b = r * sqrt(1 - k * k);
    const struct svg_point from = {cx + k * r * c, cy + k * r * s};
    f->v[0] = from;
    f->v[1] = (struct svg_point){from.x + a * c, from.y + a * s};
    f->v[2] = (struct svg_point){from.x - b * s, from.y + b * c};
    f->focus = k;
}

/* False: nothing is painted. */
static bool place(const struct svg *svg, const struct svg_shape *shape,
                  const struct svg_gradient *g, struct svg_frame *f)
{
    static const struct svg_matrix same = {1, 0, 0, 1, 0, 0};
    struct svg_point all = svg->view;
    struct svg_matrix m = shape->matrix;
    if (g->user_space != 1) {
        double box[4];
        svg_path_box(&shape->path, &same, box);
        const struct svg_matrix unit = {box[2] - box[0], 0,      0,
                                        box[3] - box[1], box[0], box[1]};
        if (!(unit.a > 0 && unit.d > 0))
            return false;
        all = (struct svg_point){1, 1};
        m = svg_times(&m, &unit);
    }
    m = svg_times(&m, &g->matrix);
    (g->radial ? own_circle : own_frame)(g, all, f);
    for (int i = 0; i < 3; i++)
        f->v[i] = svg_at(&m, f->v[i].x, f->v[i].y);
    return true;
}

static pel_color with_opacity(pel_color color, double opacity)
{
    const double alpha = (double)pel_alpha(color) * opacity;
    return (color & 0xFFFFFF) | (pel_color)lround(alpha) << 24;
}

static bool copy_stops(struct svg_frame *f, const struct svg_gradient *g,
                       double opacity)
{
    f->stop = malloc(g->stops * sizeof *f->stop);
    f->stops = g->stops;
    f->radial = g->radial;
    f->spread = g->spread > 0 ? g->spread : PEL_ICON_PAD;
    for (size_t i = 0; f->stop && i < g->stops; i++)
        f->stop[i] = (struct svg_stop){g->stop[i].at,
                                       with_opacity(g->stop[i].color, opacity)};
    return f->stop || message_error("out of memory");
}

/* One without area shows its last stop. */
static bool is_flat(const struct svg_frame *f)
{
    const struct svg_point *const v = f->v;
    return fabs((v[1].x - v[0].x) * (v[2].y - v[0].y) -
                (v[1].y - v[0].y) * (v[2].x - v[0].x)) < 1e-9;
}

bool svg_resolve(const struct svg *svg, const struct svg_shape *shape,
                 bool stroke, struct svg_frame *frame)
{
    const struct svg_style *const s = &shape->style;
    const struct svg_paint *const paint = stroke ? &s->stroke : &s->fill;
    const double opacity =
        s->opacity * (stroke ? s->stroke_opacity : s->fill_opacity);
    *frame = (struct svg_frame){.color = with_opacity(paint->color, opacity)};
    if (paint->kind == SVG_CURRENT)
        frame->color = with_opacity(PEL_RGB(0, 0, 0), opacity);
    if (paint->kind != SVG_GRADIENT)
        return true;
    const struct svg_gradient *const named = find(svg, paint->id);
    if (!named)
        return message_error_at(svg->path, shape->line,
                                "no gradient '%.100s' is in the file: expected "
                                "a linear or a radial one",
                                paint->id);
    const struct svg_gradient g = whole(svg, named);
    if (g.stops == 0 || opacity == 0 || !place(svg, shape, &g, frame))
        return true;
    frame->color = with_opacity(g.stop[g.stops - 1].color, opacity);
    return g.stops == 1 || is_flat(frame) || copy_stops(frame, &g, opacity);
}
