/* Strokes along points, and paths of curves. */
#include "core/path/smooth_path.h"
#include "sim/script/commands.h"

enum { VERBS = 16384 };

/* The points of an item behind its width, if it has one. */
struct points {
    const struct pel_point *v;
    int32_t n, width;
};

static struct points points_of(const struct script_pen *pen, const int32_t *v)
{
    const bool wide = pen->item->command->kinds[0] == KIND_LENGTH;
    return (struct points){(const struct pel_point *)(const void *)(v + wide),
                           (int32_t)(pen->item->count - wide) / 2,
                           wide ? v[0] : 0};
}

/* `dashes` lives as long as the stroke. */
static struct pel_stroke stroke_of(const struct script_pen *pen, int32_t width,
                                   struct pel_dashes *dashes)
{
    *dashes = (struct pel_dashes){&pel_dashed, pen->dash, 2, pen->dash[2]};
    return (struct pel_stroke){.width = width,
                               .cap = (enum pel_cap)pen->cap,
                               .join = (enum pel_join)pen->join,
                               .dashes =
                                   pen->dash[0] + pen->dash[1] ? dashes : NULL};
}

static void draw_polyline(struct script_pen *pen, const int32_t *v)
{
    const struct points p = points_of(pen, v);
    struct pel_dashes dashes;
    const struct pel_polyline_shape line = {
        p.v, p.n, pen->item->command->closed, stroke_of(pen, p.width, &dashes)};
    script_finish(pen, (pen->smooth ? pel_smooth_polyline : pel_polyline)(
                           pen->surface, &line, script_paint(pen), pen->scratch,
                           pen->scratch_size));
}

/* Cubic curves, each from where the one before it ends; a fill closes them. */
static void draw_path(struct script_pen *pen, const int32_t *v)
{
    const struct points p = points_of(pen, v);
    uint8_t verbs[VERBS];
    struct pel_dashes dashes;
    const int32_t curves = pel_min((p.n - 1) / 3, VERBS - 1);
    const struct pel_path path = {.verbs = verbs,
                                  .points32 = &p.v->x,
                                  .verb_count = 1 + curves,
                                  .point_count = 1 + 3 * curves};
    const struct pel_path_shape shape = {.path = &path,
                                         .rule = pen->item->command->rule,
                                         .stroke =
                                             stroke_of(pen, p.width, &dashes)};
    verbs[0] = PEL_MOVE;
    for (int32_t i = 1; i <= curves; i++)
        verbs[i] = PEL_CUBIC;
    if (p.width > 0)
        script_finish(pen,
                      (pen->smooth ? pel_smooth_path_stroke : pel_path_stroke)(
                          pen->surface, &shape, script_paint(pen), pen->scratch,
                          pen->scratch_size));
    else
        script_finish(pen, (pen->smooth ? pel_smooth_path_fill : pel_path_fill)(
                               pen->surface, &shape, script_paint(pen),
                               pen->scratch, pen->scratch_size));
}

/* A miter goes at most twice the width from a point. */
static const char *check_stroke(const int32_t *v, size_t n)
{
    const int32_t most = PEL_COORDINATE_MAX - 1026;
    for (size_t i = 1; i < n; i++)
        if (v[0] > most / 2 || v[i] > most - 2 * v[0] || v[i] < 2 * v[0] - most)
            return "expected points twice the width away from -32764 and "
                   "32764";
    return NULL;
}

static const char *check_curves(const int32_t *v, size_t n)
{
    (void)v;
    return n / 2 % 3 != 1  ? "expected a point, and three more for each curve"
           : n / 2 > VERBS ? "expected 5461 curves or fewer"
                           : NULL;
}

static const char *check_curve_stroke(const int32_t *v, size_t n)
{
    const char *const wrong = check_curves(v, n);
    return wrong ? wrong : check_stroke(v, n);
}

static const char *check_dash(const int32_t *v, size_t n)
{
    (void)n;
    const int32_t period = v[0] + v[1];
    return period && (period < 256 || period > PEL_PX(32767))
               ? "expected a dash and a gap of 1 to 32767 px, or 0 0"
               : NULL;
}

const struct script_command script_strokes[] = {
    {"option cap", "o", "butt|square|round", SCRIPT_STATE,
     SCRIPT_SETTING(struct script_pen, cap, 1)},
    {"option join", "o", "bevel|miter|round", SCRIPT_STATE,
     SCRIPT_SETTING(struct script_pen, join, 1)},
    {"dash", "lll", "LENGTH GAP PHASE", SCRIPT_STATE,
     SCRIPT_SETTING(struct script_pen, dash, 3), .check = check_dash},
    {"stroke line", "lpppp*", "WIDTH X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_polyline, .check = check_stroke},
    {"stroke loop", "lpppp*", "WIDTH X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_polyline, .check = check_stroke, .closed = true},
    {"stroke curve", "lpppppppp*", "WIDTH X Y X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_path, .check = check_curve_stroke},
    {"path evenodd", "pppppppp*", "X Y X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_path, .check = check_curves, .rule = PEL_EVEN_ODD},
    {"path nonzero", "pppppppp*", "X Y X Y X Y X Y ...", SCRIPT_SHAPE,
     .draw = draw_path, .check = check_curves, .rule = PEL_NON_ZERO},
    {.next = script_images},
};
