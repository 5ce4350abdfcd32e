#include "sim/view/figures.h"

#include <string.h>

#include "sim/cli/number.h"

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
