/* Paints and their settings. Paints are made for every shape that they fill. */
#include "sim/script/paints.h"

#include "sim/script/assets.h"

static struct pel_point point(const int32_t *v)
{
    return (struct pel_point){v[0], v[1]};
}

/* A ramp from n values, AT COLOUR AT COLOUR ... */
static struct pel_ramp ramp_of(const struct script_pen *pen, const int32_t *v,
                               size_t n)
{
    struct pel_stop stops[SCRIPT_STOPS_MAX];
    for (size_t i = 0; i < n / 2; i++)
        stops[i] = (struct pel_stop){v[2 * i], (pel_color)v[2 * i + 1]};
    const int32_t cells = SCRIPT_RAMP_COLORS >> pen->fewer;
    pel_ramp_fill(pen->paints->ramp, cells, stops, (int32_t)n / 2);
    return (struct pel_ramp){pen->paints->ramp, cells, pen->spread};
}

/* None of these can fail: the values were checked when the script was read. */

static const struct pel_paint *make_flat(const struct script_pen *pen)
{
    static const struct pel_flat flat = PEL_FLAT(0);
    struct pel_flat *p = &pen->paints->paint.flat;
    *p = flat;
    p->color = (pel_color)pen->values[0];
    return &p->paint;
}

static const struct pel_paint *make_linear(const struct script_pen *pen)
{
    struct pel_linear *p = &pen->paints->paint.linear;
    const int32_t *v = pen->values;
    pen->paints->ramp[0] = (pel_color)v[2];
    pen->paints->ramp[1] = (pel_color)v[5];
    const struct pel_ramp ramp = {pen->paints->ramp, 2, pen->spread};
    pel_linear_init(p, point(v), point(v + 3), &ramp);
    return &p->base.paint;
}

static const struct pel_paint *make_linear_stops(const struct script_pen *pen)
{
    struct pel_linear *p = &pen->paints->paint.linear;
    const int32_t *v = pen->values;
    const struct pel_ramp ramp = ramp_of(pen, v + 4, pen->value_count - 4);
    pel_linear_init(p, point(v), point(v + 2), &ramp);
    return &p->base.paint;
}

static const struct pel_paint *make_radial(const struct script_pen *pen)
{
    struct pel_radial *p = &pen->paints->paint.radial;
    const int32_t *v = pen->values;
    const struct pel_rings rings = {point(v), v[2], pen->phase};
    const struct pel_ramp ramp = ramp_of(pen, v + 3, pen->value_count - 3);
    pel_radial_init(p, &rings, &ramp);
    return &p->base.paint;
}

static const struct pel_paint *make_conic(const struct script_pen *pen)
{
    struct pel_conic *p = &pen->paints->paint.conic;
    const int32_t *v = pen->values;
    const struct pel_ramp ramp = ramp_of(pen, v + 3, pen->value_count - 3);
    pel_conic_init(p, point(v), (uint16_t)v[2], &ramp);
    return &p->base.paint;
}

static const struct pel_paint *make_wheel(const struct script_pen *pen)
{
    struct pel_hue_wheel *p = &pen->paints->paint.wheel;
    const int32_t *v = pen->values;
    pel_hue_wheel_init(p, point(v), (uint16_t)v[2], (uint8_t)v[3],
                       (uint8_t)v[4]);
    return &p->conic.base.paint;
}

static void set_fan_points(struct pel_fan_points *points, const int32_t *v,
                           struct pel_point *perimeter, pel_color *colors)
{
    for (int32_t i = 0; i < points->n; i++) {
        perimeter[i] = point(v + 3 * i);
        colors[i] = (pel_color)v[3 * i + 2];
    }
    points->perimeter = perimeter;
    points->colors = colors;
    pel_fan_set_hub(points);
}

static enum pel_status init_fan(const struct script_pen *pen)
{
    struct pel_point perimeter[SCRIPT_FAN_POINTS_MAX];
    pel_color colors[SCRIPT_FAN_POINTS_MAX];
    struct pel_fan_points points = {.n = (int32_t)pen->value_count / 3};
    set_fan_points(&points, pen->values, perimeter, colors);
    return pel_fan_init(&pen->paints->paint.fan, &points,
                        pen->paints->triangles);
}

static const struct pel_paint *make_fan(const struct script_pen *pen)
{
    init_fan(pen);
    return &pen->paints->paint.fan.base.paint;
}

static const struct pel_paint *make_mapped(const struct script_pen *pen,
                                           const struct pel_texture_map *map)
{
    struct pel_texture *p = &pen->paints->paint.texture;
    const struct pel_texels texels = {
        .surface = &pen->assets->pictures[pen->values[0]]};
    if (pen->bilinear)
        pel_texture_init_bilinear(p, &texels, map);
    else
        pel_texture_init_nearest(p, &texels, map);
    p->wrap_u = (uint8_t)pen->wrap;
    p->wrap_v = (uint8_t)pen->wrap;
    return &p->base.paint;
}

static const struct pel_paint *make_texture(const struct script_pen *pen)
{
    const int32_t x = pen->values[1], y = pen->values[2];
    const struct pel_texture_map map = PEL_TEXTURE_AT(x, y);
    return make_mapped(pen, &map);
}

static const struct pel_paint *make_texture_map(const struct script_pen *pen)
{
    struct pel_texture_map map;
    struct pel_point v[3];
    struct pel_texel_point t[3];
    for (int i = 0; i < 3; i++) {
        const int32_t *values = pen->values + 1 + 4 * i;
        v[i] = point(values);
        t[i] = (struct pel_texel_point){values[2], values[3]};
    }
    pel_texture_map_triangle(&map, v, t);
    return make_mapped(pen, &map);
}

const struct pel_paint *script_dithered(const struct script_pen *pen,
                                        const struct pel_paint *paint)
{
    if (!pen->dither)
        return paint;
    pel_dither_init(&pen->paints->dither, paint);
    return &pen->paints->dither.paint;
}

const struct pel_paint *script_paint(const struct script_pen *pen)
{
    return script_dithered(pen, pen->make(pen));
}

void script_paint_init(struct script_pen *pen)
{
    static const int32_t white = -1;
    pen->make = make_flat;
    pen->values = &white;
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
    const struct script_pen pen = {
        .values = v, .value_count = n, .paints = &paints};
    if (n / 3 > SCRIPT_FAN_POINTS_MAX)
        return "expected up to 64 points";
    return init_fan(&pen) == PEL_OK
               ? NULL
               : "expected points that go around their middle once";
}

#define PAINT(name, kinds, usage, make_, check_)                         \
    {                                                                    \
        name, kinds, usage, SCRIPT_PAINT, .check = check_, .make = make_ \
    }
#define OPTION(name, kinds, usage, member)               \
    {                                                    \
        name, kinds, usage, SCRIPT_STATE,                \
            SCRIPT_SETTING(struct script_pen, member, 1) \
    }

const struct script_command script_paint_commands[] = {
    PAINT("paint flat", "c", "COLOUR", make_flat, NULL),
    {"paint vertex", "ccc", "COLOUR0 COLOUR1 COLOUR2",
     .role = SCRIPT_PAINT_VERTEX},
    PAINT("paint linear stops", "ppppwcwc*",
          "X0 Y0 X1 Y1 AT COLOUR AT COLOUR ...", make_linear_stops,
          check_linear_stops),
    PAINT("paint linear", "ppcppc", "X0 Y0 COLOUR X1 Y1 COLOUR", make_linear,
          check_linear),
    PAINT("paint radial", "pplwcwc*", "CX CY R AT COLOUR AT COLOUR ...",
          make_radial, check_radial),
    PAINT("paint conic", "pptwcwc*", "CX CY TURN AT COLOUR AT COLOUR ...",
          make_conic, check_conic),
    PAINT("paint wheel", "pptbb", "CX CY TURN SATURATION VALUE", make_wheel,
          NULL),
    PAINT("paint fan", "ppcppcppc+", "X Y COLOUR X Y COLOUR X Y COLOUR ...",
          make_fan, check_fan),
    PAINT("paint texture map", "Ppppppppppppp",
          "FILE X0 Y0 U0 V0 X1 Y1 U1 V1 X2 Y2 U2 V2", make_texture_map, NULL),
    PAINT("paint texture", "Pii", "FILE X Y", make_texture, NULL),
    OPTION("option spread", "o", "pad|repeat|reflect", spread),
    OPTION("option phase", "t", "TURN", phase),
    OPTION("option cells", "o", "2048|1024|512|256|128|64", fewer),
    OPTION("option filter", "o", "nearest|bilinear", bilinear),
    OPTION("option wrap", "o", "clamp|repeat|mirror", wrap),
    OPTION("option dither", "o", "off|on", dither),
    {.name = NULL},
};
