/* pel compare: where two pictures differ. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/image/picture.h"
#include "sim/image/texture.h"
#include "sim/script/script.h"

struct compare_options {
    char **path;
    const char *diff, *shrink, *command, *output, *mask;
    int tolerance;
    double allow; /* pixels, or % of them */
    bool is_percent;
    struct pel_rect *ignore;
    size_t ignored;
};

/* The pictures, and the one that says where they are compared, or none. */
struct pair {
    struct picture a, b, mask;
};

struct differences {
    long count;    /* pixels beyond the tolerance */
    long compared; /* pixels in all */
    int worst;     /* of any channel */
    int first[2];  /* the first such pixel, in reading order */
};

/* N or N%. */
static bool parse_allow(const char *option, const char *text, void *input)
{
    struct compare_options *o = input;
    char *end;
    o->allow = strtod(text, &end);
    o->is_percent = *end == '%';
    return (text[strspn(text, "0123456789.%")] == '\0' && end != text &&
            !end[o->is_percent] && o->allow >= 0 &&
            (o->is_percent ? o->allow <= 100 : !strchr(text, '.'))) ||
           option_refuse(option, text,
                         "pixels such as 20, or a part of them, "
                         "up to 100%, such as 0.5%");
}

static bool parse_ignore(const char *option, const char *text, void *input)
{
    struct compare_options *o = input;
    static const struct option_row numbers = {
        .n = 4, .separator = ',', .low = -32767, .high = 32767};
    double v[4];
    if (!option_numbers(text, &numbers, v) || v[2] < 0 || v[3] < 0)
        return option_refuse(option, text,
                             "X,Y,WIDTH,HEIGHT in pixels, such "
                             "as 10,20,30,8");
    const int32_t x = (int32_t)v[0], y = (int32_t)v[1];
    const struct pel_rect area = {x, y, x + (int32_t)v[2], y + (int32_t)v[3]};
    return list_add(&o->ignore, &o->ignored, &area, sizeof area);
}

static const struct option_row options[] = {
    {"tolerance", "N",
     "equal when no channel differs by more than N steps of 255 (0)",
     OPTION_INTEGER, .offset = offsetof(struct compare_options, tolerance),
     .low = 0, .high = 255},
    {"allow", "N|N%", "equal when no more pixels than that differ (0)",
     OPTION_CALL, .parse = parse_allow},
    {"mask", "PICTURE",
     "compare only where this picture, of the same size, is not black",
     OPTION_TEXT, .offset = offsetof(struct compare_options, mask)},
    {"ignore", "X,Y,W,H", "compare all but these pixels; may be given again",
     OPTION_CALL, .parse = parse_ignore},
    {"diff", "FILE",
     "write a picture of the differences: red, brighter where larger, on the "
     "first picture in grey; blue where only one has pixels",
     OPTION_TEXT, .offset = offsetof(struct compare_options, diff)},
    {"shrink", "SCRIPT",
     "no pictures: leave out lines of a scene script, as many as may go while "
     "the --command still fails, and write what is left",
     OPTION_TEXT, .offset = offsetof(struct compare_options, shrink)},
    {"command", "COMMAND",
     "for --shrink: a command of sh, with the script as $1; it fails when its "
     "status is that for the whole script, which is not 0",
     OPTION_TEXT, .offset = offsetof(struct compare_options, command)},
    {"output", "FILE", "of --shrink, instead of standard output", OPTION_TEXT,
     .offset = offsetof(struct compare_options, output), .letter = 'o'},
    {.help = NULL},
};

static const char about[] =
    "Compares two pictures (.ppm, .png and what else pel reads; - is standard "
    "input).\v"
    "Exit status: 0 equal, 1 different, 2 error. Prints the sizes when they "
    "differ, else the number of differing pixels, the worst difference, and "
    "the first such pixel. Alpha counts like a colour; the colours of clear "
    "pixels and comments in a file do not: with those, equal .ppm pictures "
    "may differ for cmp.\n\nThe smallest script whose bands are not as the "
    "whole:\n  pel compare --shrink BAD.pel --command 'pel run $1 -o a.ppm\n"
    "  pel run $1 --bands 8 -o b.ppm; pel compare a.ppm b.ppm'";

/* Of the channel that differs most; a clear pixel has no colour. */
static int pixel_difference(pel_color a, pel_color b)
{
    const bool is_clear = pel_alpha(a) == 0 || pel_alpha(b) == 0;
    int most = 0;
    for (int shift = is_clear ? 24 : 0; shift < 32; shift += 8) {
        const int d = abs((int)(a >> shift & 255) - (int)(b >> shift & 255));
        most = d > most ? d : most;
    }
    return most;
}

static bool is_compared(const struct pair *p, const struct compare_options *o,
                        int x, int y)
{
    for (size_t i = 0; i < o->ignored; i++)
        if (x >= o->ignore[i].x0 && x < o->ignore[i].x1 &&
            y >= o->ignore[i].y0 && y < o->ignore[i].y1)
            return false;
    return !o->mask || (picture_row(&p->mask, y)[x] & 0xFFFFFF) != 0;
}

static struct differences find_differences(const struct pair *p,
                                           const struct compare_options *o)
{
    struct differences d = {.count = 0};
    for (int y = 0; y < p->a.height; y++)
        for (int x = 0; x < p->a.width; x++) {
            if (!is_compared(p, o, x, y))
                continue;
            const int difference = pixel_difference(picture_row(&p->a, y)[x],
                                                    picture_row(&p->b, y)[x]);
            d.compared++;
            d.worst = difference > d.worst ? difference : d.worst;
            if (difference > o->tolerance && d.count++ == 0) {
                d.first[0] = x;
                d.first[1] = y;
            }
        }
    return d;
}

static bool has_pixel(const struct picture *p, int x, int y)
{
    return x < p->width && y < p->height;
}

static pel_color diff_color(const struct pair *p,
                            const struct compare_options *o, int x, int y)
{
    if (!has_pixel(&p->a, x, y) || !has_pixel(&p->b, x, y))
        return PEL_RGB(0, 0, 255);
    const pel_color a = picture_row(&p->a, y)[x];
    const int difference = pixel_difference(a, picture_row(&p->b, y)[x]);
    const uint32_t gray = pel_gray(a) / 3;
    return difference > o->tolerance && is_compared(p, o, x, y)
               ? PEL_RGB(127 + (difference + 1) / 2, 0, 0)
               : PEL_RGB(gray, gray, gray);
}

static bool write_diff(const struct pair *p, const struct compare_options *o)
{
    struct picture diff;
    const int width = pel_max(p->a.width, p->b.width);
    const int height = pel_max(p->a.height, p->b.height);
    if (!o->diff)
        return true;
    if (!picture_init(&diff, width, height, 0))
        return false;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            picture_row(&diff, y)[x] = diff_color(p, o, x, y);
    const bool done = picture_save(&diff, o->diff);
    picture_free(&diff);
    return done;
}

/* #rrggbb, or #rrggbbaa of a color that is not opaque. */
static void print_color(const char *before, pel_color color)
{
    printf("%s#%06x", before, (unsigned)color & 0xFFFFFF);
    if (pel_alpha(color) < 255)
        printf("%02x", (unsigned)pel_alpha(color));
}

static int report(const struct pair *p, const struct compare_options *o)
{
    const struct picture *a = &p->a, *b = &p->b;
    if (a->width != b->width || a->height != b->height) {
        message_print(
            stdout, "sizes differ: %s has %d x %d pixels, %s has %d x %d",
            o->path[0], a->width, a->height, o->path[1], b->width, b->height);
        putchar('\n');
        return STATUS_DIFFERENT;
    }
    const struct differences d = find_differences(p, o);
    const double allowed =
        o->is_percent ? (double)d.compared * o->allow / 100 : o->allow;
    if (d.count == 0)
        return STATUS_OK;
    const int x = d.first[0], y = d.first[1];
    printf("%ld of %ld pixels differ, worst by %d of 255, first at (%d, %d): ",
           d.count, d.compared, d.worst, x, y);
    print_color("", picture_row(a, y)[x]);
    print_color(", ", picture_row(b, y)[x]);
    putchar('\n');
    return (double)d.count <= allowed ? STATUS_OK : STATUS_DIFFERENT;
}

/* The mask, if there is one, which has the size of the first picture. */
static bool load_mask(struct pair *p, const struct compare_options *o)
{
    return !o->mask ||
           (texture_load(&p->mask, o->mask) &&
            ((p->mask.width == p->a.width && p->mask.height == p->a.height) ||
             message_error_at(o->mask, 0,
                              "the mask has %d x %d pixels: expected the %d x "
                              "%d of %s",
                              p->mask.width, p->mask.height, p->a.width,
                              p->a.height, o->path[0])));
}

static int compare(const struct compare_options *o)
{
    struct pair p = {.a = {0, 0, NULL}};
    int status = STATUS_ERROR;
    if (strcmp(o->path[0], "-") == 0 && strcmp(o->path[1], "-") == 0)
        message_error("two pictures from standard input: expected one");
    else if ((!o->diff || picture_path_check(o->diff)) &&
             texture_load(&p.a, o->path[0]) && texture_load(&p.b, o->path[1]) &&
             load_mask(&p, o) && write_diff(&p, o))
        status = report(&p, o);
    picture_free(&p.a);
    picture_free(&p.b);
    picture_free(&p.mask);
    return status;
}

int command_compare(int argc, char **argv)
{
    struct compare_options o = {.tolerance = 0};
    const struct command_line line = {.arguments = "A B",
                                      .most = 2,
                                      .about = about,
                                      .tables = {{options, &o, NULL}}};
    o.path = arguments_parse(&line, argc, argv);
    const int count = !o.path[0] ? 0 : !o.path[1] ? 1 : 2;
    if (count == 2 && !o.shrink && !o.command && !o.output)
        return compare(&o);
    if (count == 0 && o.shrink && o.command && !o.diff && !o.tolerance &&
        !o.mask && !o.ignored && o.allow <= 0)
        return script_shrink(o.shrink, o.command, o.output ? o.output : "-")
                   ? STATUS_OK
                   : STATUS_ERROR;
    message_error("%d argument%s: expected A B [--tolerance N --diff FILE], or "
                  "--shrink SCRIPT --command COMMAND [--output FILE]",
                  count, count == 1 ? "" : "s");
    return STATUS_ERROR;
}
