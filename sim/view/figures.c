#include "sim/view/figures.h"

#include <math.h>
#include <string.h>

#include "sim/cli/number.h"

#define TURN 6.283185307179586

#define MARK PEL_RGB(255, 255, 160)

/* The hues from red over green and blue to red again. */
static const pel_color hues[7] = {PEL_RGB(255, 0, 0), PEL_RGB(255, 255, 0),
                                  PEL_RGB(0, 255, 0), PEL_RGB(0, 255, 255),
                                  PEL_RGB(0, 0, 255), PEL_RGB(255, 0, 255),
                                  PEL_RGB(255, 0, 0)};

/* #rrggbbaa, as the style shows a color: half way to MARK where it is marked.
 */
static void put_color(FILE *out, const struct style *style, pel_color color)
{
    const pel_color half = (color >> 1 & 0x7F7F7F) + (MARK >> 1 & 0x7F7F7F);
    const pel_color c = style->marked ? half : color;
    const unsigned alpha = (pel_alpha(color) * style->alpha + 127) / 255;
    fprintf(out, "#%06x%02x", (unsigned)c & 0xFFFFFF, alpha);
}

static void put_stop(FILE *out, const struct style *style, double at,
                     pel_color color)
{
    fprintf(out, " %.5f ", at);
    put_color(out, style, color);
}

static void put_corners(FILE *out, const struct style *style,
                        const struct outline *o)
{
    fputs("paint fan", out);
    for (int i = 0; i < o->corners; i++) {
        fprintf(out, " %.4f %.4f ", o->corner[i][0], o->corner[i][1]);
        put_color(out, style, hues[i * 6 / o->corners]);
    }
}

static void put_rings(FILE *out, const struct style *style,
                      const struct outline *o)
{
    const double r = o->r / 3 > 1 ? o->r / 3 : 1;
    fprintf(out,
            "option cells 256\noption spread repeat\noption phase %.5f\n"
            "paint radial %.4f %.4f %.4f",
            o->phase, o->x, o->y, r);
    put_stop(out, style, 0, PEL_RGB(255, 255, 255));
    put_stop(out, style, 0.5, style->color | PEL_RGB(0, 0, 0));
    put_stop(out, style, 1, PEL_RGB(255, 255, 255));
}

static void put_sectors(FILE *out, const struct style *style,
                        const struct outline *o)
{
    fprintf(out,
            "option cells 512\noption spread pad\npaint conic %.4f %.4f %.5f",
            o->x, o->y, o->turn);
    for (int i = 0; i < 7; i++)
        put_stop(out, style, i / 6.0, hues[i]);
}

void style_write(FILE *out, const struct style *style,
                 const struct outline *outline)
{
    switch (style->fill) {
    case FILL_CORNERS:
        put_corners(out, style, outline);
        break;
    case FILL_RADIAL:
        put_rings(out, style, outline);
        break;
    case FILL_SECTOR:
        put_sectors(out, style, outline);
        break;
    default:
        fputs("paint flat ", out);
        put_color(out, style, style->color | PEL_RGB(0, 0, 0));
    }
    fputc('\n', out);
}

void style_recolor(FILE *out, const struct style *style, const char *line)
{
    while (*line) {
        pel_color color = 0;
        const size_t length = number_color(line, &color);
        if (length && (!line[length] || strchr(" \t\r\n", line[length]))) {
            put_color(out, style, color);
            line += length;
        } else {
            fputc(*line++, out);
        }
    }
    fputc('\n', out);
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
    const double scale = shorter * 7.0 / 16, angle = all->turn * TURN;
    const double c = cos(angle), s = sin(angle);
    struct outline o = {.x = all->width / 2.0 + scale * (f->x * c - f->y * s),
                        .y = all->height / 2.0 + scale * (f->x * s + f->y * c),
                        .r = scale * f->r,
                        .turn = all->turn,
                        .phase = all->phase};
    const int n = f->corners ? f->corners * (f->star ? 2 : 1) : 6;
    for (int i = 0; i < n; i++) {
        const double at = angle * 2 + i * TURN / n - TURN / 4;
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

void figures_write(FILE *out, const struct figures *all,
                   const struct style style[FIGURES])
{
    fprintf(out, "canvas %d %d xrgb8888\n%s%sclear #101820\n", all->width,
            all->height, all->dithered ? "option dither on\n" : "",
            all->smooth ? "option smooth on\n" : "");
    for (int k = 0; k < FIGURES; k++) {
        const struct outline o = place(all, &figures[k]);
        const int corners = figures[k].corners;
        style_write(out, &style[k], &o);
        fputs(corners == 0   ? "circle"
              : corners == 3 ? "triangle"
                             : "polygon evenodd",
              out);
        if (corners == 0)
            fprintf(out, " %.4f %.4f %.4f", o.x, o.y, o.r);
        for (int i = 0; corners > 0 && i < o.corners; i++)
            fprintf(out, " %.4f %.4f", o.corner[i][0], o.corner[i][1]);
        fputc('\n', out);
    }
}
