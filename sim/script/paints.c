/* Paints and their settings. Paints are made for every shape that they fill. */
#include "core/paint/paint_blend.h"
#include "core/paint/paint_conic.h"
#include "core/paint/paint_dither.h"
#include "core/paint/paint_fan.h"
#include "core/paint/paint_linear.h"
#include "core/paint/paint_nine_slice.h"
#include "core/paint/paint_pattern.h"
#include "core/paint/paint_radial.h"
#include "core/paint/paint_texture.h"
#include "sim/script/parser.h"

enum {
    SCRIPT_RAMP_COLORS = 2048, /* at most, of a gradient with stops */
    SCRIPT_STOPS_MAX = 64,
    SCRIPT_FAN_POINTS_MAX = 64
};

/* Memory for one paint, which is made anew for every shape. */
struct script_paints {
    union {
        struct pel_paint paint; /* how all others begin */
        struct pel_flat flat;
        struct pel_gouraud gouraud;
        struct pel_smooth_gouraud smooth_gouraud;
        struct pel_linear linear;
        struct pel_radial radial;
        struct pel_conic conic;
        struct pel_hue_wheel wheel;
        struct pel_fan fan;
        struct pel_texture texture;
        struct pel_checker checker;
        struct pel_hatch hatch;
        struct pel_nine_slice slices;
    } any;
    struct pel_blend blend;
    struct pel_dither dither;
    pel_color ramp[SCRIPT_RAMP_COLORS];
    struct pel_fan_triangle triangles[SCRIPT_FAN_POINTS_MAX];
};

static struct pel_point point(const int32_t *v)
{
    return (struct pel_point){v[0], v[1]};
}

/* A ramp from the values from v[first] on, AT COLOUR AT COLOUR ... */
static struct pel_ramp ramp_of(const struct script_pen *pen, size_t first)
{
    struct pel_stop stops[SCRIPT_STOPS_MAX];
    const int32_t *v = script_values(pen, pen->paint) + first;
    const size_t n = (pen->paint->count - first) / 2;
    for (size_t i = 0; i < n; i++)
        stops[i] = (struct pel_stop){v[2 * i], (pel_color)v[2 * i + 1]};
    const int32_t cells = SCRIPT_RAMP_COLORS >> pen->fewer;
    pel_ramp_fill(pen->paints->ramp, cells, stops, (int32_t)n);
    return (struct pel_ramp){pen->paints->ramp, cells, pen->spread};
}

/* These make pen->paints->any; v are its values. None can fail: the values
 * were checked when the script was read. */

static void make_flat(const struct script_pen *pen, const int32_t *v)
{
    pen->paints->any.flat = (struct pel_flat)PEL_FLAT((pel_color)v[0]);
}

/* A color for each vertex of the triangle that is drawn. */
static void make_vertex(const struct script_pen *pen, const int32_t *v)
{
    const int32_t *at = script_values(pen, pen->item);
    const struct pel_point p[3] = {point(at), point(at + 2), point(at + 4)};
    const pel_color color[3] = {(pel_color)v[0], (pel_color)v[1],
                                (pel_color)v[2]};
    if (pen->smooth)
        pel_smooth_gouraud_init(&pen->paints->any.smooth_gouraud, p, color);
    else
        pel_gouraud_init(&pen->paints->any.gouraud, p, color);
}

static void make_linear(const struct script_pen *pen, const int32_t *v)
{
    pen->paints->ramp[0] = (pel_color)v[2];
    pen->paints->ramp[1] = (pel_color)v[5];
    const struct pel_ramp ramp = {pen->paints->ramp, 2, pen->spread};
    pel_linear_init(&pen->paints->any.linear, point(v), point(v + 3), &ramp);
}

static void make_linear_stops(const struct script_pen *pen, const int32_t *v)
{
    const struct pel_ramp ramp = ramp_of(pen, 4);
    pel_linear_init(&pen->paints->any.linear, point(v), point(v + 2), &ramp);
}

static void make_radial(const struct script_pen *pen, const int32_t *v)
{
    const struct pel_rings rings = {point(v), v[2], pen->phase};
    const struct pel_ramp ramp = ramp_of(pen, 3);
    pel_radial_init(&pen->paints->any.radial, &rings, &ramp);
}

static void make_conic(const struct script_pen *pen, const int32_t *v)
{
    const struct pel_ramp ramp = ramp_of(pen, 3);
    pel_conic_init(&pen->paints->any.conic, point(v), (uint16_t)v[2], &ramp);
}

static void make_wheel(const struct script_pen *pen, const int32_t *v)
{
    pel_hue_wheel_init(&pen->paints->any.wheel, point(v), (uint16_t)v[2],
                       (uint8_t)v[3], (uint8_t)v[4]);
}

static enum pel_status init_fan(struct script_paints *paints, const int32_t *v,
                                size_t n)
{
    struct pel_point perimeter[SCRIPT_FAN_POINTS_MAX];
    pel_color colors[SCRIPT_FAN_POINTS_MAX];
    struct pel_fan_points points = {
        .n = (int32_t)n / 3, .perimeter = perimeter, .colors = colors};
    for (int32_t i = 0; i < points.n; i++, v += 3) {
        perimeter[i] = point(v);
        colors[i] = (pel_color)v[2];
    }
    pel_fan_set_hub(&points);
    return pel_fan_init(&paints->any.fan, &points, paints->triangles);
}

static void make_fan(const struct script_pen *pen, const int32_t *v)
{
    init_fan(pen->paints, v, pen->paint->count);
}

static void make_mapped(const struct script_pen *pen, int32_t picture,
                        const struct pel_texture_map *map)
{
    struct pel_texture *p = &pen->paints->any.texture;
    const struct pel_texels texels = {
        .surface = &pen->script->assets[picture].picture};
    (pen->bilinear ? pel_texture_init_bilinear
                   : pel_texture_init_nearest)(p, &texels, map);
    p->wrap_u = p->wrap_v = (uint8_t)pen->wrap;
}

static void make_texture(const struct script_pen *pen, const int32_t *v)
{
    const struct pel_texture_map map = PEL_TEXTURE_AT(v[1], v[2]);
    make_mapped(pen, v[0], &map);
}

static void make_texture_map(const struct script_pen *pen, const int32_t *v)
{
    struct pel_texture_map map;
    struct pel_point at[3];
    struct pel_texel_point texel[3];
    for (int i = 0; i < 3; i++) {
        at[i] = point(v + 1 + 4 * i);
        texel[i] = (struct pel_texel_point){v[3 + 4 * i], v[4 + 4 * i]};
    }
    pel_texture_map_triangle(&map, at, texel);
    make_mapped(pen, v[0], &map);
}

static void make_checker(const struct script_pen *pen, const int32_t *v)
{
    const struct pel_checker_fields fields = {v[2], v[3], v[0], v[1]};
    pel_checker_init(&pen->paints->any.checker, &fields, (pel_color)v[4],
                     (pel_color)v[5]);
}

static enum pel_status init_hatch(struct pel_hatch *hatch, const int32_t *v)
{
    const struct pel_hatch_lines lines = {v[0], v[1], v[2], v[3], v[4]};
    return pel_hatch_init(hatch, &lines, (pel_color)v[5], (pel_color)v[6]);
}

static void make_hatch(const struct script_pen *pen, const int32_t *v)
{
    init_hatch(&pen->paints->any.hatch, v);
}

static struct pel_rect rect_of(const int32_t *v)
{
    return (struct pel_rect){v[0], v[1], v[0] + v[2], v[1] + v[3]};
}

/* Without a middle inside the picture it draws nothing. */
static void make_slices(const struct script_pen *pen, const int32_t *v)
{
    struct pel_nine_slice *const p = &pen->paints->any.slices;
    const struct pel_surface *const picture =
        &pen->script->assets[v[0]].picture;
    const struct pel_rect asked = rect_of(v + 1), box = rect_of(v + 5);
    const struct pel_rect middle = pel_rect_intersect(&asked, &picture->bounds);
    pel_nine_slice_init(p, picture, &middle, &box);
    p->tiled = pen->wrap == PEL_WRAP_REPEAT;
}

const struct pel_paint *script_paint(const struct script_pen *pen)
{
    static const int32_t white = -1;
    struct script_paints *paints = pen->paints;
    if (pen->paint)
        pen->paint->command->make(pen, script_values(pen, pen->paint));
    else
        make_flat(pen, &white);
    const struct pel_paint *paint = &paints->any.paint;
    if (pen->blend) {
        pel_blend_init(&paints->blend, paint,
                       (enum pel_blend_mode)(pen->blend - 1));
        paint = &paints->blend.paint;
    }
    if (!pen->dither)
        return paint;
    pel_dither_init(&paints->dither, paint);
    return &paints->dither.paint;
}

size_t script_paint_size(void)
{
    return sizeof(struct script_paints);
}

static const char *check_ends(const int32_t *from, const int32_t *to)
{
    return from[0] == to[0] && from[1] == to[1]
               ? "expected two points that are not the same"
               : NULL;
}

static const char *check_stops(const int32_t *v, size_t n)
{
    if (n / 2 > SCRIPT_STOPS_MAX)
        return "expected up to 64 stops";
    for (size_t i = 2; i < n; i += 2)
        if (v[i] < v[i - 2])
            return "expected stops in ascending order";
    return NULL;
}

static const char *check_linear(const int32_t *v, size_t n)
{
    (void)n;
    return check_ends(v, v + 3);
}

static const char *check_linear_stops(const int32_t *v, size_t n)
{
    const char *wrong = check_ends(v, v + 2);
    return wrong ? wrong : check_stops(v + 4, n - 4);
}

static const char *check_radial(const int32_t *v, size_t n)
{
    if (v[2] < PEL_PX(1))
        return "expected a radius of 1 or more";
    return check_stops(v + 3, n - 3);
}

static const char *check_conic(const int32_t *v, size_t n)
{
    return check_stops(v + 3, n - 3);
}

static const char *check_fan(const int32_t *v, size_t n)
{
    static struct script_paints paints;
    if (n / 3 > SCRIPT_FAN_POINTS_MAX)
        return "expected up to 64 points";
    return init_fan(&paints, v, n) == PEL_OK
               ? NULL
               : "expected points that go around their middle once";
}

static const char *check_hatch(const int32_t *v, size_t n)
{
    struct pel_hatch hatch;
    (void)n;
    return init_hatch(&hatch, v) == PEL_OK ? NULL
                                           : "expected DX and DY in -255..255, "
                                             "and a width up to the period";
}

static const char *check_slices(const int32_t *v, size_t n)
{
    const struct pel_rect box = rect_of(v + 5);
    (void)n;
    return pel_bounds_legal(&box) ? NULL : "expected a box up to 32767";
}

#define STATE(member) SCRIPT_STATE, SCRIPT_SETTING(struct script_pen, member, 1)

const struct script_command script_paint_commands[] = {
    {"paint flat", "c", "COLOUR", SCRIPT_PAINT, .make = make_flat},
    {"paint vertex", "ccc", "COLOUR0 COLOUR1 COLOUR2", SCRIPT_PAINT_VERTEX,
     .make = make_vertex},
    {"paint linear stops", "ppppwcwc*", "X0 Y0 X1 Y1 AT COLOUR AT COLOUR ...",
     SCRIPT_PAINT, .make = make_linear_stops, .check = check_linear_stops},
    {"paint linear", "ppcppc", "X0 Y0 COLOUR X1 Y1 COLOUR", SCRIPT_PAINT,
     .make = make_linear, .check = check_linear},
    {"paint radial", "pplwcwc*", "CX CY R AT COLOUR AT COLOUR ...",
     SCRIPT_PAINT, .make = make_radial, .check = check_radial},
    {"paint conic", "pptwcwc*", "CX CY TURN AT COLOUR AT COLOUR ...",
     SCRIPT_PAINT, .make = make_conic, .check = check_conic},
    {"paint wheel", "pptbb", "CX CY TURN SATURATION VALUE", SCRIPT_PAINT,
     .make = make_wheel},
    {"paint fan", "ppcppcppc+", "X Y COLOUR X Y COLOUR X Y COLOUR ...",
     SCRIPT_PAINT, .make = make_fan, .check = check_fan},
    {"paint texture map", "Ppppppppppppp",
     "FILE X0 Y0 U0 V0 X1 Y1 U1 V1 X2 Y2 U2 V2", SCRIPT_PAINT,
     .make = make_texture_map},
    {"paint texture", "Pii", "FILE X Y", SCRIPT_PAINT, .make = make_texture},
    {"paint checker", "iisscc", "X Y WIDTH HEIGHT COLOUR COLOUR", SCRIPT_PAINT,
     .make = make_checker},
    {"paint hatch", "iiisncc", "DX DY PHASE PERIOD WIDTH COLOUR COLOUR",
     SCRIPT_PAINT, .make = make_hatch, .check = check_hatch},
    {"paint slices", "Pnnssiiss", "FILE LEFT TOP WIDTH HEIGHT X Y WIDTH HEIGHT",
     SCRIPT_PAINT, .make = make_slices, .check = check_slices},
    {"option spread", "o", "pad|repeat|reflect", STATE(spread)},
    {"option phase", "t", "TURN", STATE(phase)},
    {"option cells", "o", "2048|1024|512|256|128|64", STATE(fewer)},
    {"option filter", "o", "nearest|bilinear", STATE(bilinear)},
    {"option wrap", "o", "clamp|repeat|mirror", STATE(wrap)},
    {"option dither", "o", "off|on", STATE(dither)},
    {"option blend", "o", "none|xor|add|multiply", STATE(blend)},
    {.next = script_mesh_commands},
};
