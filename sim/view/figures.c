#include "sim/view/figures.h"

#include <math.h>

#include "sim/cli/list.h"
#include "sim/script/commands.h"

#define RADIANS 6.283185307179586 /* of a turn */

enum { TURN = 65536 }; /* in the units of scripts; 1 for positions of stops */

#define MARK PEL_RGB(255, 255, 160)

/* The hues from red over green and blue to red again. */
static const pel_color hues[7] = {PEL_RGB(255, 0, 0), PEL_RGB(255, 255, 0),
                                  PEL_RGB(0, 255, 0), PEL_RGB(0, 255, 255),
                                  PEL_RGB(0, 0, 255), PEL_RGB(255, 0, 255),
                                  PEL_RGB(255, 0, 0)};

/* A color as the style shows it: half way to MARK where it is marked. */
static int32_t shown(const struct style *style, pel_color color)
{
    const pel_color half = (color >> 1 & 0x7F7F7F) + (MARK >> 1 & 0x7F7F7F);
    const pel_color c = style->marked ? half : color;
    return (int32_t)(pel_round_div255(pel_alpha(color) * style->alpha) << 24 |
                     (c & 0xFFFFFF));
}

static int32_t sub_pixels(double px)
{
    return (int32_t)fmax(PEL_COORDINATE_MIN,
                         fmin(round(px * 256), PEL_COORDINATE_MAX));
}

static bool add_one(struct script *script, const char *name, int32_t value)
{
    return script_add(script, name, &value, 1);
}

static bool add_corners(struct script *script, const struct style *style,
                        const struct outline *o)
{
    int32_t v[3 * OUTLINE_CORNERS];
    for (int i = 0; i < o->corners; i++) {
        v[3 * i] = sub_pixels(o->corner[i][0]);
        v[3 * i + 1] = sub_pixels(o->corner[i][1]);
        v[3 * i + 2] = shown(style, hues[i * 6 / o->corners]);
    }
    return script_add(script, "paint fan", v, 3 * (size_t)o->corners);
}

static bool add_rings(struct script *script, const struct style *style,
                      const struct outline *o)
{
    enum { CELLS_256 = 3 };
    const int32_t white = shown(style, PEL_RGB(255, 255, 255));
    const int32_t color = shown(style, style->color | PEL_RGB(0, 0, 0));
    const int32_t x = sub_pixels(o->x), y = sub_pixels(o->y);
    const int32_t r = sub_pixels(fmax(o->r / 3, 1));
    const int32_t v[] = {x, y, r, 0, white, TURN / 2, color, TURN, white};
    return add_one(script, "option cells", CELLS_256) &&
           add_one(script, "option spread", PEL_REPEAT) &&
           add_one(script, "option phase", (int32_t)round(o->phase * TURN)) &&
           script_add(script, "paint radial", v, sizeof v / sizeof *v);
}

static bool add_sectors(struct script *script, const struct style *style,
                        const struct outline *o)
{
    enum { CELLS_512 = 2, HUES = 6 };
    int32_t v[3 + 2 * (HUES + 1)] = {sub_pixels(o->x), sub_pixels(o->y),
                                     (int32_t)round(o->turn * TURN)};
    for (int i = 0; i <= HUES; i++) {
        v[3 + 2 * i] = (TURN * i + HUES / 2) / HUES;
        v[4 + 2 * i] = shown(style, hues[i]);
    }
    return add_one(script, "option cells", CELLS_512) &&
           add_one(script, "option spread", PEL_PAD) &&
           script_add(script, "paint conic", v, sizeof v / sizeof *v);
}

bool style_add(struct script *script, const struct style *style,
               const struct outline *outline)
{
    switch (style->fill) {
    case FILL_CORNERS:
        return add_corners(script, style, outline);
    case FILL_RADIAL:
        return add_rings(script, style, outline);
    case FILL_SECTOR:
        return add_sectors(script, style, outline);
    default:
        return add_one(script, "paint flat",
                       shown(style, style->color | PEL_RGB(0, 0, 0)));
    }
}

bool style_recolor(struct script *script, const struct style *style,
                   const struct script_item *paint)
{
    const struct script_item own = {paint->command, paint->line,
                                    script->value_count, paint->count};
    bool done = true;
    for (size_t i = 0; done && i < paint->count; i++) {
        int32_t v = script->values[paint->first + i];
        if (script_kind_of(paint->command, i) == KIND_COLOR)
            v = shown(style, (pel_color)v);
        done = list_add(&script->values, &script->value_count, &v, sizeof v);
    }
    return done && script_add_item(script, &own);
}

/* In parts of 7/8 of half the shorter side, with falling area. A star has its
 * inner corners at half the radius. */
static const struct figure {
    int corners; /* 0: a circle */
    bool star;
    double x, y, r;
    pel_color color;
    enum fill fill;
} figures[FIGURES] = {
    {0, false, 0, 0, 1, PEL_RGB(52, 73, 94), FILL_RADIAL},
    {4, false, -0.42, -0.36, 0.52, PEL_RGB(230, 126, 34), FILL_CORNERS},
    {6, false, 0.45, 0.38, 0.40, PEL_RGB(46, 204, 113), FILL_FLAT},
    {3, false, 0.42, -0.42, 0.46, PEL_RGB(52, 152, 219), FILL_CORNERS},
    {0, false, -0.46, 0.44, 0.28, PEL_RGB(155, 89, 182), FILL_SECTOR},
    {5, true, 0.02, 0.04, 0.34, PEL_RGB(241, 196, 15), FILL_FLAT},
    {0, false, 0.62, -0.08, 0.16, PEL_RGB(231, 76, 60), FILL_RADIAL},
    {5, false, -0.05, -0.66, 0.16, PEL_RGB(26, 188, 156), FILL_SECTOR},
    {3, false, 0.0, 0.66, 0.16, PEL_RGB(236, 240, 241), FILL_FLAT},
};

void figures_styles(struct style style[FIGURES])
{
    for (int k = 0; k < FIGURES; k++)
        style[k] =
            (struct style){figures[k].fill, figures[k].color, 255, false};
}

/* Where a figure is: all turn around the middle, and each around its own. */
static struct outline place(const struct figures *all, const struct figure *f)
{
    const int shorter = all->width < all->height ? all->width : all->height;
    const double scale = shorter * 7.0 / 16, angle = all->turn * RADIANS;
    const double c = cos(angle), s = sin(angle);
    struct outline o = {.x = all->width / 2.0 + scale * (f->x * c - f->y * s),
                        .y = all->height / 2.0 + scale * (f->x * s + f->y * c),
                        .r = scale * f->r,
                        .turn = all->turn,
                        .phase = all->phase};
    const int n = f->corners ? f->corners * (f->star ? 2 : 1) : 6;
    for (int i = 0; i < n; i++) {
        const double at = angle * 2 + i * RADIANS / n - RADIANS / 4;
        const double r = f->star && i % 2 ? o.r / 2 : o.r;
        o.corner[i][0] = o.x + r * cos(at);
        o.corner[i][1] = o.y + r * sin(at);
    }
    o.corners = n;
    return o;
}

struct pel_rect figures_box(const struct figures *all, int k)
{
    const struct outline o = place(all, &figures[k]);
    return (struct pel_rect){
        (int32_t)floor(o.x - o.r) - 1, (int32_t)floor(o.y - o.r) - 1,
        (int32_t)ceil(o.x + o.r) + 1, (int32_t)ceil(o.y + o.r) + 1};
}

static bool add_shape(struct script *script, const struct figure *f,
                      const struct outline *o)
{
    int32_t v[2 * OUTLINE_CORNERS] = {sub_pixels(o->x), sub_pixels(o->y),
                                      sub_pixels(o->r)};
    if (f->corners == 0)
        return script_add(script, "circle", v, 3);
    for (int i = 0; i < 2 * o->corners; i++)
        v[i] = sub_pixels(o->corner[i / 2][i % 2]);
    return script_add(script, f->corners == 3 ? "triangle" : "polygon evenodd",
                      v, 2 * (size_t)o->corners);
}

bool figures_add(struct script *script, const struct figures *all,
                 const struct style style[FIGURES])
{
    script->width = all->width;
    script->height = all->height;
    bool done = add_one(script, "clear", (int32_t)PEL_RGB(16, 24, 32));
    for (int k = 0; done && k < FIGURES; k++) {
        const struct outline o = place(all, &figures[k]);
        done = style_add(script, &style[k], &o) &&
               add_shape(script, &figures[k], &o);
    }
    return done;
}
