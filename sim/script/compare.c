/* pel compare: where two pictures differ. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/image/picture.h"
#include "sim/image/texture.h"
#include "sim/script/script.h"

struct compare_options {
    char **path;
    const char *diff, *shrink, *command, *output;
    int tolerance;
};

struct differences {
    long count; /* pixels beyond the tolerance */
    int worst;  /* of any channel */
    long first; /* the first such pixel, in reading order */
};

static const struct option_row options[] = {
    {"tolerance", "N",
     "equal when no channel differs by more than N steps of 255 (0)",
     OPTION_INTEGER, .offset = offsetof(struct compare_options, tolerance),
     .low = 0, .high = 255},
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
    "the first such pixel.\n\nThe smallest script whose bands are not as the "
    "whole:\n  pel compare --shrink BAD.pel --command 'pel run $1 -o a.ppm\n"
    "  pel run $1 --bands 8 -o b.ppm; pel compare a.ppm b.ppm'";

/* Of the channel that differs most. */
static int pixel_difference(pel_color a, pel_color b)
{
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const int d = abs((int)(a >> shift & 255) - (int)(b >> shift & 255));
        most = d > most ? d : most;
    }
    return most;
}

static struct differences count_differences(const struct picture p[2],
                                            int tolerance)
{
    struct differences d = {.count = 0};
    const long n = (long)p[0].width * p[0].height;
    for (long i = 0; i < n; i++) {
        const int difference = pixel_difference(p[0].pixels[i], p[1].pixels[i]);
        d.worst = difference > d.worst ? difference : d.worst;
        if (difference > tolerance && d.count++ == 0)
            d.first = i;
    }
    return d;
}

static bool has_pixel(const struct picture *p, int x, int y)
{
    return x < p->width && y < p->height;
}

static pel_color diff_color(const struct picture p[2], int x, int y,
                            int tolerance)
{
    if (!has_pixel(&p[0], x, y) || !has_pixel(&p[1], x, y))
        return PEL_RGB(0, 0, 255);
    const pel_color a = picture_row(&p[0], y)[x];
    const int difference = pixel_difference(a, picture_row(&p[1], y)[x]);
    const uint32_t gray = pel_gray(a) / 3;
    return difference > tolerance ? PEL_RGB(127 + (difference + 1) / 2, 0, 0)
                                  : PEL_RGB(gray, gray, gray);
}

static bool write_diff(const struct picture p[2],
                       const struct compare_options *o)
{
    struct picture diff;
    const int width = p[0].width > p[1].width ? p[0].width : p[1].width;
    const int height = p[0].height > p[1].height ? p[0].height : p[1].height;
    if (!o->diff)
        return true;
    if (!picture_init(&diff, width, height, 0))
        return false;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            picture_row(&diff, y)[x] = diff_color(p, x, y, o->tolerance);
    const bool done = picture_save(&diff, o->diff);
    picture_free(&diff);
    return done;
}

static int report(const struct picture p[2], const struct compare_options *o)
{
    const int width = p[0].width, height = p[0].height;
    if (width != p[1].width || height != p[1].height) {
        message_print(
            stdout, "sizes differ: %s has %d x %d pixels, %s has %d x %d",
            o->path[0], width, height, o->path[1], p[1].width, p[1].height);
        putchar('\n');
        return STATUS_DIFFERENT;
    }
    const struct differences d = count_differences(p, o->tolerance);
    if (d.count == 0)
        return STATUS_OK;
    printf("%ld of %ld pixels differ, worst by %d of 255, first at (%d, %d): "
           "#%06x, #%06x\n",
           d.count, (long)width * height, d.worst, (int)(d.first % width),
           (int)(d.first / width), p[0].pixels[d.first] & 0xFFFFFFu,
           p[1].pixels[d.first] & 0xFFFFFFu);
    return STATUS_DIFFERENT;
}

static int compare(const struct compare_options *o)
{
    struct picture p[2] = {{0, 0, NULL}, {0, 0, NULL}};
    int status = STATUS_ERROR;
    if (strcmp(o->path[0], "-") == 0 && strcmp(o->path[1], "-") == 0)
        message_error("two pictures from standard input: expected one");
    else if ((!o->diff || picture_path_check(o->diff)) &&
             texture_load(&p[0], o->path[0]) &&
             texture_load(&p[1], o->path[1]) && write_diff(p, o))
        status = report(p, o);
    picture_free(&p[0]);
    picture_free(&p[1]);
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
    if (count == 0 && o.shrink && o.command && !o.diff && !o.tolerance)
        return script_shrink(o.shrink, o.command, o.output ? o.output : "-")
                   ? STATUS_OK
                   : STATUS_ERROR;
    message_error("%d argument%s: expected A B [--tolerance N --diff FILE], or "
                  "--shrink SCRIPT --command COMMAND [--output FILE]",
                  count, count == 1 ? "" : "s");
    return STATUS_ERROR;
}
