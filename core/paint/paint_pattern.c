#include "paint_pattern.h"

/* A row of stripes: `at` and `step` lie in 0..period - 1. */
struct stripes {
    int32_t at, step, period, width;
};

static void stripe(pel_color *colors, int32_t n, const struct stripes *s,
                   const pel_color pair[2])
{
    int32_t at = s->at;
    for (; n > 0; n--) {
        *colors++ = pair[at >= s->width];
        at += s->step;
        if (at >= s->period)
            at -= s->period;
    }
}

/* 0..period - 1 */
static int32_t mod(int32_t value, int32_t period)
{
    const int32_t rest = value % period;
    return rest < 0 ? rest + period : rest;
}

static bool are_opaque(pel_color on, pel_color off)
{
    return pel_alpha(on & off) == 255;
}

/* Two fields are a period: every other row of fields has the colors swapped.
 * x and y of the fields lie in a period, pixels in 16 bits: no sum overflows.
 */
static void checker_colors(const struct pel_color_paint *paint, int32_t x,
                           int32_t y, int32_t n, pel_color *colors)
{
    const struct pel_checker *const p = (const void *)paint;
    const struct pel_checker_fields *const f = &p->fields;
    const bool odd = mod(y - f->y, 2 * f->height) >= f->height;
    const struct stripes stripes = {mod(x - f->x, 2 * f->width), 1,
                                    2 * f->width, f->width};
    const pel_color pair[2] = {odd ? p->off : p->on, odd ? p->on : p->off};
    stripe(colors, n, &stripes, pair);
}

/* The sum is at most 2 * 255 * 2^15 + 2^15. */
static void hatch_colors(const struct pel_color_paint *paint, int32_t x,
                         int32_t y, int32_t n, pel_color *colors)
{
    const struct pel_hatch *const p = (const void *)paint;
    const struct pel_hatch_lines *const l = &p->lines;
    const struct stripes stripes = {
        mod(l->dx * x + l->dy * y + l->phase, l->period), mod(l->dx, l->period),
        l->period, l->width};
    const pel_color pair[2] = {p->on, p->off};
    stripe(colors, n, &stripes, pair);
}

static bool is_between(int32_t value, int32_t low, int32_t high)
{
    return value >= low && value <= high;
}

enum pel_status pel_checker_init(struct pel_checker *paint,
                                 const struct pel_checker_fields *fields,
                                 pel_color on, pel_color off)
{
    if (!paint)
        return PEL_ERROR_NULL;
    pel_paint_clear(&paint->base.paint);
    if (!fields)
        return PEL_ERROR_NULL;
    if (!is_between(fields->width, 1, 32767) ||
        !is_between(fields->height, 1, 32767))
        return PEL_ERROR_RANGE;
    pel_color_paint_init(&paint->base, checker_colors, are_opaque(on, off));
    paint->fields = *fields;
    paint->fields.x = mod(fields->x, 2 * fields->width);
    paint->fields.y = mod(fields->y, 2 * fields->height);
    paint->on = on;
    paint->off = off;
    return PEL_OK;
}

enum pel_status pel_hatch_init(struct pel_hatch *paint,
                               const struct pel_hatch_lines *lines,
                               pel_color on, pel_color off)
{
    if (!paint)
        return PEL_ERROR_NULL;
    pel_paint_clear(&paint->base.paint);
    if (!lines)
        return PEL_ERROR_NULL;
    if (!is_between(lines->dx, -255, 255) ||
        !is_between(lines->dy, -255, 255) ||
        !is_between(lines->period, 1, 32767) ||
        !is_between(lines->width, 0, lines->period))
        return PEL_ERROR_RANGE;
    pel_color_paint_init(&paint->base, hatch_colors, are_opaque(on, off));
    paint->lines = *lines;
    paint->lines.phase = mod(lines->phase, lines->period);
    paint->on = on;
    paint->off = off;
    return PEL_OK;
}
