/* What the commands of a script do to one pixel, and why. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/raster/thick_line.h"
#include "core/raster/triangle.h"
#include "sim/script/commands.h"

struct explanation {
    const struct script *script;
    int at[2]; /* the pixel's x, y */
    bool all;  /* tells of commands that leave the pixel, too */
    struct script_pen pen;
    const struct script_item *clip; /* in force, or NULL */
    bool touched;
};

static const struct pel_point *points(const int32_t *v)
{
    return (const struct pel_point *)(const void *)v;
}

/* How far the pixel's centre c lies inside of a triangle's edges, and the rule
 * where it lies on one. */
static void explain_triangle(struct pel_point c, const int32_t *v, size_t n)
{
    (void)n;
    const struct pel_point *p = points(v);
    const int64_t area = pel_triangle_area(p);
    if (area == 0)
        puts("    without area: nothing, unless option collinear is line");
    for (int i = 0; area != 0 && i < 3; i++) {
        const struct pel_point a = p[area > 0 ? i : (i + 1) % 3];
        const struct pel_point b = p[area > 0 ? (i + 1) % 3 : i];
        const int64_t dx = b.x - a.x, dy = b.y - a.y;
        const int64_t edge = dx * (c.y - a.y) - dy * (c.x - a.x);
        printf("    edge %d-%d: ", i, (i + 1) % 3);
        if (edge == 0)
            printf("the centre lies on it, a %s\n",
                   dy < 0   ? "left one: inside"
                   : dy > 0 ? "right one: outside"
                   : dx > 0 ? "top one: inside"
                            : "bottom one: outside");
        else
            printf("%s by %.6g px (%lld / 65536 px2)\n",
                   edge > 0 ? "inside" : "outside",
                   fabs((double)edge) / hypot((double)dx, (double)dy) / 256,
                   (long long)edge);
    }
}

/* Circles, rings, sectors and arcs: the distance from their centre, squared
 * exactly, and the angle. From and to are the last of the n values. */
static void explain_round(struct pel_point c, const int32_t *v, size_t n)
{
    const int64_t dx = c.x - v[0], dy = c.y - v[1];
    const int64_t square = dx * dx + dy * dy;
    const double angle = atan2((double)dy, (double)dx) / 6.283185307179586;
    printf("    the centre lies %.6f px from the shape's; squares in 1/65536 "
           "px2: %lld, of the radius %lld",
           sqrt((double)square) / 256, (long long)square,
           (long long)v[2] * v[2]);
    if (n % 2 == 0)
        printf(" and %lld", (long long)v[3] * v[3]);
    if (n > 4)
        printf("; at %.6f turns, of %.6f up to, not including, %.6f",
               angle - floor(angle), v[n - 2] / 65536.0, v[n - 1] / 65536.0);
    putchar('\n');
}

static void explain_ellipse(struct pel_point c, const int32_t *v, size_t n)
{
    (void)n;
    const double x = (c.x - v[0]) / (double)v[2];
    const double y = (c.y - v[1]) / (double)v[3];
    printf("    the squares of the distance in parts of the radii: %.6f + "
           "%.6f = %.6f, inside up to 1\n",
           x * x, y * y, x * x + y * y);
}

static void explain_rect(struct pel_point c, const int32_t *v, size_t n)
{
    (void)n;
    printf("    the centre %.8g %.8g, sides from %.8g %.8g up to, not "
           "including, %.8g %.8g\n",
           c.x / 256.0, c.y / 256.0, v[0] / 256.0, v[1] / 256.0,
           (v[0] + v[2]) / 256.0, (v[1] + v[3]) / 256.0);
}

/* The sides of a polygon that the pixel's row crosses before its centre. */
static void explain_polygon(struct pel_point c, const int32_t *v, size_t n)
{
    const struct pel_point *p = points(v);
    int down = 0, up = 0;
    for (size_t i = 0; i < n; i += 2) {
        const struct pel_point a = p[i / 2], b = p[(i + 2) % n / 2];
        const bool falls = a.y <= c.y && b.y > c.y;
        const bool rises = b.y <= c.y && a.y > c.y;
        const int64_t edge = (int64_t)(b.x - a.x) * (c.y - a.y) -
                             (int64_t)(b.y - a.y) * (c.x - a.x);
        down += falls && edge <= 0;
        up += rises && edge >= 0;
    }
    printf("    sides left of the centre or through it: %d down, %d up: "
           "winding %d, %s\n",
           down, up, down - up, (down + up) % 2 ? "odd" : "even");
}

static void explain_thick(struct pel_point c, const int32_t *v, size_t n)
{
    (void)n;
    const struct pel_thick_line_shape line = {points(v)[0], points(v)[1], v[4]};
    struct pel_point corner[4];
    if (pel_thick_line_corners(&line, corner))
        explain_polygon(c, &corner[0].x, 8);
}

static void explain_line(struct pel_point c, const int32_t *v, size_t n)
{
    (void)c;
    (void)n;
    printf("    from pixel %d %d to %d %d, the nearest to the line in each "
           "step, a tie down or right\n",
           (int)(v[0] >> 8), (int)(v[1] >> 8), (int)(v[2] >> 8),
           (int)(v[3] >> 8));
}

static void (*const explain_form[])(struct pel_point c, const int32_t *v,
                                    size_t n) = {
    [FORM_TRIANGLE] = explain_triangle, [FORM_POLYGON] = explain_polygon,
    [FORM_ROUND] = explain_round,       [FORM_ELLIPSE] = explain_ellipse,
    [FORM_RECTANGLE] = explain_rect,    [FORM_LINE] = explain_line,
    [FORM_THICK_LINE] = explain_thick,
};

static void explain_shape(const struct explanation *e,
                          const struct script_item *item)
{
    const struct pel_point c = {pel_pixel_center(e->at[0]),
                                pel_pixel_center(e->at[1])};
    const enum script_form form = item->command->form;
    if (item->command->outline)
        puts("    of the shape, the pixels with one outside of it beside, "
             "above or below:");
    if (form != FORM_NONE)
        explain_form[form](c, script_values(&e->pen, item), item->count);
}

static pel_color pixel(const struct explanation *e)
{
    pel_color color;
    const struct pel_surface *s = e->pen.surface;
    s->format->load(s, e->at[0], e->at[1], 1, &color);
    return color;
}

static void print_paint(const struct explanation *e,
                        const struct script_item *item, pel_color color)
{
    const struct script_item *paint = e->pen.paint;
    const bool painted = script_is_painted(item);
    if (painted && paint)
        printf("%s (line %ld)%s%s, ", paint->command->name, paint->line,
               e->pen.blend ? ", blended" : "",
               e->pen.dither ? ", dithered" : "");
    else if (painted)
        printf("white, as at first, ");
    printf("#%06x", (unsigned)color & 0xFFFFFF);
    if (pel_alpha(color) != 255)
        printf(" alpha %u", (unsigned)pel_alpha(color));
}

/* Performs a command that draws, and explains what it did to the pixel. */
static void explain_item(struct explanation *e, const struct script_item *item)
{
    const struct pel_format *format = e->script->format;
    const pel_color before = pixel(e);
    pel_color color = before;
    const bool moves = item->command->role == SCRIPT_WHOLE;
    const bool weighed = e->pen.smooth && script_is_painted(item);
    const uint32_t coverage =
        weighed ? script_coverage(&e->pen, item, e->at) : 255;
    const bool covered =
        !moves && coverage > 0 && script_covers(&e->pen, item, e->at, &color);
    const bool clipped = !script_clip_holds(&e->pen, e->at);
    script_perform(&e->pen, item);
    const pel_color after = pixel(e);
    const bool touched = (covered && !clipped) || (moves && before != after);
    e->touched = e->touched || touched;
    if (!touched && !e->all)
        return;
    printf("line %ld: %s: ", item->line, item->command->name);
    if (covered && clipped)
        printf("outside of the clip of line %ld\n", e->clip->line);
    else if (!touched)
        puts("not covered");
    else {
        if (moves)
            printf("moved here");
        else
            print_paint(e, item, color);
        printf(" over #%06x gives #%06x, pixel value 0x%0*x\n",
               (unsigned)before & 0xFFFFFF, (unsigned)after & 0xFFFFFF,
               (format->bits + 3) / 4, (unsigned)format->pack(after));
    }
    if (weighed)
        printf("    covers %u / 255 of the pixel\n", (unsigned)coverage);
    explain_shape(e, item);
}

static void explain_all(struct explanation *e)
{
    for (size_t i = 0; i < e->script->item_count; i++) {
        const struct script_item *item = &e->script->items[i];
        if (strcmp(item->command->name, "clip") == 0)
            e->clip = item;
        if (item->command->role >= SCRIPT_CLEAR)
            explain_item(e, item);
        else
            script_perform(&e->pen, item);
    }
    if (!e->touched)
        puts("no command touches this pixel");
}

bool script_explain(const struct script *script, int x, int y, bool all)
{
    struct explanation e = {.script = script, .at = {x, y}, .all = all};
    struct canvas canvas;
    const int width = script->width, height = script->height;
    if (!canvas_init(&canvas, script->format, width, height))
        return false;
    const bool done = script_pen_init(&e.pen, script, &canvas.surface);
    if (done) {
        printf("pixel (%d, %d): centre %.1f %.1f of %d x %d\n", x, y, x + 0.5,
               y + 0.5, width, height);
        explain_all(&e);
        script_pen_free(&e.pen);
    }
    canvas_free(&canvas);
    return done;
}
