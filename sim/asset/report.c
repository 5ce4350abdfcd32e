#include "sim/asset/report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/asset/icon_asset.h"
#include "core/asset/outline_font_asset.h"
#include "core/format/argb8888.h"
#include "core/format/formats.h"
#include "core/base/surface.h"
#include "sim/asset/measure.h"
#include "sim/image/format_names.h"

static bool is_silent(const struct import_options *options)
{
    return strcmp(options->output, "-") == 0;
}

/* Of its palette. */
static size_t colors_of(const struct pel_format *format)
{
    return import_has_palette(format) ? (size_t)4 << format->bits : 0;
}

/* Pixels, and the colours of a palette. */
static size_t bytes_of(const struct pel_format *format, int width, int height)
{
    const int lines =
        format->id == PEL_FORMAT_MONO1_PAGES ? (height + 7) / 8 : height;
    return (size_t)pel_stride(format, width) * (size_t)lines +
           colors_of(format);
}

static void put(size_t bytes, const char *what)
{
    printf("%10zu  %s\n", bytes, what);
}

/* Of all pictures. */
static size_t sum_of(const struct pel_format *format,
                     const struct picture *const *picture, size_t n)
{
    size_t sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += bytes_of(format, picture[i]->width, picture[i]->height);
    return sum;
}

/* What they would be in other formats, each size once, with the first format
 * that has it. */
static void put_others(const struct pel_format *own,
                       const struct picture *const *picture, size_t n)
{
    const struct format_name more[] = {{"palette4", &import_palettes[0].format},
                                       {"palette8", &import_palettes[1].format},
                                       {NULL, NULL}};
    size_t seen[32] = {sum_of(own, picture, n)}, count = 1;
    printf("            in others: ");
    for (int list = 0; list < 2; list++)
        for (const struct format_name *f = list ? more : format_names; f->name;
             f++) {
            const size_t bytes = sum_of(f->format, picture, n);
            size_t i = 0;
            while (i < count && seen[i] != bytes)
                i++;
            if (i < count || count == 32)
                continue;
            printf("%s%s %zu", count > 1 ? ", " : "", f->name, bytes);
            seen[count++] = bytes;
        }
    printf("\n");
}

void report_picture(const struct import_options *options,
                    const struct picture *picture,
                    const struct pel_format *format, size_t in_runs)
{
    const bool compress = options->changes.compress;
    const size_t own = bytes_of(format, picture->width, picture->height);
    const size_t runs = in_runs + colors_of(format);
    char what[80];
    if (is_silent(options))
        return;
    snprintf(what, sizeof(what), "bytes in flash: %d x %d pixels%s%s",
             picture->width, picture->height,
             colors_of(format) ? " and their palette" : "",
             compress ? ", in runs" : "");
    put(compress ? runs : own, what);
    if (in_runs)
        printf("            %s --compress: %zu\n",
               compress ? "without" : "with", compress ? own : runs);
    put_others(format, &(const struct picture *){picture}, 1);
}

/* What the arrays of a font take, bytes, and what they are. */
struct font_arrays {
    size_t data, pairs, glyphs, ranges;
    const char *of_data, *of_glyphs, *summary;
};

static void put_font(const struct font_arrays *font)
{
    enum { STRUCT = 48 };
    put(font->data, font->of_data);
    if (font->pairs)
        put(font->pairs, "pairs of glyphs that are closer or further apart");
    put(font->glyphs, font->of_glyphs);
    put(font->ranges, "ranges of characters");
    put(STRUCT, "the struct, on a 32-bit CPU");
    put(font->data + font->pairs + font->glyphs + font->ranges + STRUCT,
        font->summary);
}

/* Of a font of a desktop: more than most firmware has letters for. */
static void put_less(const struct import_options *options, uint32_t glyphs)
{
    if (glyphs > 256 && !options->codes && !options->chars)
        printf("            --codes 32-126 would keep ASCII alone\n");
}

void report_font(const struct import_options *options,
                 const struct pel_font_asset *font)
{
    char what[64];
    if (is_silent(options))
        return;
    snprintf(what, sizeof(what), "bytes in flash: %u glyphs, lines of %d px",
             font->glyphs, font->ascent + font->descent);
    put_font(&(struct font_arrays){
        font->size, font->pairs * sizeof *font->pair,
        font->glyphs * sizeof *font->glyph, font->ranges * sizeof *font->range,
        font->kind ? "runs of coverage, equal glyphs once"
                   : "rows of glyphs, equal ones once",
        "places and sizes of glyphs", what});
    put_less(options, font->glyphs);
}

void report_outlines(const struct import_options *options,
                     const struct pel_outline_font_asset *font)
{
    char what[64];
    if (is_silent(options))
        return;
    snprintf(what, sizeof(what), "bytes in flash: %u glyphs, an em of %u units",
             font->glyphs, font->em);
    put_font(&(struct font_arrays){font->size, font->pairs * sizeof *font->pair,
                                   font->glyphs * sizeof *font->glyph,
                                   font->ranges * sizeof *font->range,
                                   "points of glyphs, equal ones once",
                                   "places and advances of glyphs", what});
    put_less(options, font->glyphs);
}

/* A picture of each size, of pixels in that format. */
static void put_sizes(const struct pel_icon_asset *icon, const char *name,
                      const struct pel_format *format)
{
    static const int sizes[] = {16, 24, 32, 48, 64};
    const int side = icon->width > icon->height ? icon->width : icon->height;
    printf("            %-10s", name);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const int w = (icon->width * sizes[i] + side - 1) / side;
        const int h = (icon->height * sizes[i] + side - 1) / side;
        printf("  %2d px %5zu", sizes[i], bytes_of(format, w, h));
    }
    printf("\n");
}

void report_icon(const struct import_options *options,
                 const struct pel_icon_asset *icon)
{
    enum { STRUCT = 56, STOP = 8 };
    const size_t parts = icon->parts * sizeof *icon->part;
    const size_t gradients =
        icon->gradients * sizeof *icon->gradient + icon->stops * (size_t)STOP;
    const size_t path = icon->verbs + icon->points * (size_t)4;
    if (is_silent(options))
        return;
    put(path, "verbs and points");
    put(parts, "parts");
    if (gradients)
        put(gradients, "gradients and their stops");
    put(STRUCT, "the struct, on a 32-bit CPU");
    put(path + parts + gradients + STRUCT,
        icon->strokes
            ? "bytes in flash, for pel_icon_smooth_strokes at any size"
            : "bytes in flash, for pel_icon_smooth at any size");
    printf("            as pictures (--icon-size; masks with --symbolic), of "
           "one size each:\n");
    put_sizes(icon, "4-bit mask", &pel_gray4);
    put_sizes(icon, "palette4", &import_palettes[0].format);
    put_sizes(icon, "palette8", &import_palettes[1].format);
    put_sizes(icon, "argb8888", &pel_argb8888);
}

static void put_textures(const struct model *model,
                         const struct pel_format *format)
{
    const struct picture **all = malloc((model->textures + 1) * sizeof(*all));
    for (size_t i = 0; all && i < model->textures; i++)
        all[i] = &model->texture[i].picture;
    if (all)
        put_others(format, all, model->textures);
    free(all);
}

void report_mesh(const struct import_options *options,
                 const struct model *model, const struct pel_format *format)
{
    const struct pel_mesh *m = &model->mesh;
    const size_t n = m->vertices;
    const size_t normals = n * (m->normals16 ? 6 : 3);
    const size_t indices = (size_t)m->triangles * (m->indices16 ? 6 : 12);
    size_t all = n * 9 + normals + (m->uv ? n * 4 : 0) + indices;
    char what[80];
    if (is_silent(options))
        return;
    put(n * 6, "positions");
    put(normals, m->normals16 ? "normals of 16 bits (8 bits: half of it)"
                              : "normals of 8 bits (16 bits: twice that)");
    if (m->uv)
        put(n * 4, "texture coordinates");
    put(n * 3, "colours");
    put(indices, m->indices16 ? "indices of 16 bits" : "indices of 32 bits");
    for (size_t i = 0; format && i < model->textures; i++) {
        const struct picture *p = &model->texture[i].picture;
        const struct pel_format *own =
            model->texture[i].opaque ? format : &pel_argb8888;
        snprintf(what, sizeof(what), "texture %zu, %d x %d", i + 1, p->width,
                 p->height);
        put(bytes_of(own, p->width, p->height), what);
        all += bytes_of(own, p->width, p->height);
    }
    if (format)
        put_textures(model, format);
    snprintf(what, sizeof(what), "bytes in flash: %zu vertices, %u triangles",
             n, m->triangles);
    put(all, what);
}

/* The errors of all ways of one part or texture; the line goes on. */
static void put_errors(const char *what, size_t number, const int *error,
                       const char *const *ways)
{
    printf("%s %zu: ", what, number);
    if (error[0] < 0)
        printf("no view shows it");
    for (int i = 0; ways[i] && error[0] >= 0; i++)
        printf("%s%s %d", i ? ", " : "", ways[i], error[i]);
    printf(": ");
}

static void report_mappings(const struct measure *m)
{
    static const char *const ways[] = {
        "of vertices", "affine", "divided every 64 px",
        "32 px",       "16 px",  "8 px",
        "4 px",        "2 px",   "every pixel",
        NULL};
    for (size_t i = 0; i < m->textures; i++) {
        const int taken = m->mapping[i];
        put_errors("texture", i + 1, m->mapping_error[i], ways);
        printf("%s, span %d\n", measure_mapping_name(taken),
               measure_mapping_span(taken));
    }
}

void report_measure(const struct import_options *options)
{
    static const char *const ways[] = {"flat",
                                       "Gouraud",
                                       "Gouraud in perspective",
                                       "Phong",
                                       "Phong in perspective",
                                       NULL};
    static const char *const unlit[] = {"flat", "Gouraud",
                                        "Gouraud in perspective", NULL};
    const struct measure *m = options->measure;
    if (!m || is_silent(options))
        return;
    printf("errors in %d views of %d x %d px, steps of 255; %g are asked\n",
           m->count, m->width, m->height, m->tolerance);
    report_mappings(m);
    for (size_t i = 0; i < m->parts; i++) {
        put_errors("part", i + 1, m->shading_error[i], m->lit ? ways : unlit);
        printf("%s\n", measure_shading_name(m, m->shading[i]));
    }
}
