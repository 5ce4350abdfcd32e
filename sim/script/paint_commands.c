#include "sim/script/paints.h"

/* Paints are made for every shape that they colour (script_paints.c): here they
 * are only chosen. */
static void choose(struct script_pen *pen, const int32_t *v, size_t n,
                   script_make_paint *make)
{
    pen->make = make;
    pen->values = v;
    pen->value_count = n;
    pen->by_vertex = false;
}

static void set_linear(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_linear);
}

static void set_linear_stops(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_linear_stops);
}

static void set_radial(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_radial);
}

static void set_conic(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_conic);
}

static void set_wheel(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_wheel);
}

static void set_fan(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_fan);
}

static void set_texture(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_texture);
}

static void set_texture_map(struct script_pen *pen, const int32_t *v, size_t n)
{
    choose(pen, v, n, script_make_texture_map);
}

static const char *check_ends(const int32_t *from, const int32_t *to)
{
    return from[0] == to[0] && from[1] == to[1]
               ? "the two points must not be the same"
               : NULL;
}

static const char *check_stops(const int32_t *v, size_t n)
{
    if (n / 2 > SCRIPT_STOPS_MAX)
        return "64 stops at most";
    for (size_t i = 2; i < n; i += 2)
        if (v[i] < v[i - 2])
            return "a stop must not lie before the one that it follows";
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
        return "the radius must be 1 or more";
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
        return "64 points at most";
    return script_fan_legal(&pen)
               ? NULL
               : "the points must go around their middle once";
}

static void set_pad(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->spread = PEL_PAD;
}

static void set_repeat(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->spread = PEL_REPEAT;
}

static void set_reflect(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->spread = PEL_REFLECT;
}

static void set_phase(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)n;
    pen->phase = (uint16_t)v[0];
}

static void set_nearest(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->bilinear = false;
}

static void set_bilinear(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->bilinear = true;
}

static void set_clamp(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->wrap = PEL_WRAP_CLAMP;
}

static void set_wrap(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->wrap = PEL_WRAP_REPEAT;
}

static void set_mirror(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->wrap = PEL_WRAP_MIRROR;
}

static void set_dither(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->dither = true;
}

static void set_no_dither(struct script_pen *pen, const int32_t *v, size_t n)
{
    (void)v;
    (void)n;
    pen->dither = false;
}

const struct script_command script_paint_commands[] = {
    {"paint linear stops", "ppppwcwc*", "X0 Y0 X1 Y1 AT COLOUR AT COLOUR ...",
     SCRIPT_PAINT, set_linear_stops, check_linear_stops},
    {"paint linear", "ppcppc", "X0 Y0 COLOUR X1 Y1 COLOUR", SCRIPT_PAINT,
     set_linear, check_linear},
    {"paint radial", "pplwcwc*", "CX CY R AT COLOUR AT COLOUR ...",
     SCRIPT_PAINT, set_radial, check_radial},
    {"paint conic", "pptwcwc*", "CX CY TURN AT COLOUR AT COLOUR ...",
     SCRIPT_PAINT, set_conic, check_conic},
    {"paint wheel", "pptbb", "CX CY TURN SATURATION VALUE", SCRIPT_PAINT,
     set_wheel, NULL},
    {"paint fan", "ppcppcppc+", "X Y COLOUR X Y COLOUR X Y COLOUR ...",
     SCRIPT_PAINT, set_fan, check_fan},
    {"paint texture map", "Ppppppppppppp",
     "FILE X0 Y0 U0 V0 X1 Y1 U1 V1 X2 Y2 U2 V2", SCRIPT_PAINT, set_texture_map,
     NULL},
    {"paint texture", "Pii", "FILE X Y", SCRIPT_PAINT, set_texture, NULL},
    {"option spread pad", "", "", SCRIPT_STATE, set_pad, NULL},
    {"option spread repeat", "", "", SCRIPT_STATE, set_repeat, NULL},
    {"option spread reflect", "", "", SCRIPT_STATE, set_reflect, NULL},
    {"option phase", "t", "TURN", SCRIPT_STATE, set_phase, NULL},
    {"option filter nearest", "", "", SCRIPT_STATE, set_nearest, NULL},
    {"option filter bilinear", "", "", SCRIPT_STATE, set_bilinear, NULL},
    {"option wrap clamp", "", "", SCRIPT_STATE, set_clamp, NULL},
    {"option wrap repeat", "", "", SCRIPT_STATE, set_wrap, NULL},
    {"option wrap mirror", "", "", SCRIPT_STATE, set_mirror, NULL},
    {"option dither on", "", "", SCRIPT_STATE, set_dither, NULL},
    {"option dither off", "", "", SCRIPT_STATE, set_no_dither, NULL},
    {NULL, NULL, NULL, SCRIPT_STATE, NULL, NULL},
};
