#include "sim/icon/icon.h"
#include "sim/asset/import.h"
#include "sim/asset/report.h"
#include "sim/asset/text.h"
#include "sim/cli/message.h"
#include "sim/image/texture.h"

const struct option_row import_icon_options[] = {
    {.help = "Icons:", .kind = OPTION_HEADING},
    {"icon-size", "PX",
     "a picture with alpha whose longer side has so many pixels, "
     "in " IMPORT_ALPHA_FORMAT " or as the options of pictures say, instead of "
     "paths for any size (pel/image/icon.h)",
     OPTION_INTEGER, .offset = offsetof(struct import_options, icon_size),
     .low = 1, .high = ICON_SIZE_MAX},
    {"symbolic", NULL,
     "its shapes of one colour take the program's, each with its own opacity, "
     "as those with currentColor do; with --icon-size a mask for "
     "pel_masked_init, in gray4 (default), gray8 or mono1",
     OPTION_FLAG, .offset = offsetof(struct import_options, symbolic)},
    {.help = NULL},
};

static void write_parts(struct import_text *text,
                        const struct pel_icon_asset *icon)
{
    import_array_begin(text, "struct pel_icon_part", "parts", icon->parts, 1);
    for (uint32_t i = 0; i < icon->parts; i++) {
        const struct pel_icon_part *p = &icon->part[i];
        import_item(text, "{0x%08lx, %u, %u, %u, %u, %u, %u, %u, %u},",
                    (unsigned long)p->color, p->verbs, p->points, p->kind,
                    p->gradient, p->cap, p->join, p->width, p->miter_limit);
    }
    import_array_end(text);
}

static void write_gradients(struct import_text *text,
                            const struct pel_icon_asset *icon)
{
    import_array_begin(text, "struct pel_icon_gradient", "gradients",
                       icon->gradients, 1);
    for (uint32_t i = 0; i < icon->gradients; i++) {
        const struct pel_icon_gradient *g = &icon->gradient[i];
        const struct pel_point *p = g->frame;
        import_item(text, "{{{%ld, %ld}, {%ld, %ld}, {%ld, %ld}},", (long)p->x,
                    (long)p->y, (long)p[1].x, (long)p[1].y, (long)p[2].x,
                    (long)p[2].y);
        import_item(text, "%u, %u, %u, %u, %u},", g->focus, g->radial,
                    g->spread, g->stop, g->stops);
    }
    import_array_end(text);
    import_array_begin(text, "struct pel_icon_stop", "stops", icon->stops, 1);
    for (uint32_t i = 0; i < icon->stops; i++)
        import_item(text, "{%u, 0x%08lx},", icon->stop[i].at,
                    (unsigned long)icon->stop[i].color);
    import_array_end(text);
}

static void write_struct(const struct import_text *text,
                         const struct pel_icon_asset *icon)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    const bool has = icon->gradients > 0;
    fprintf(out, "    PEL_ICON_MAGIC,\n    PEL_ICON_VERSION,\n");
    fprintf(out, "    %u, /* are there strokes? */\n", icon->strokes);
    fprintf(out, "    %u,\n    %u, /* units of its box */\n", icon->width,
            icon->height);
    fprintf(out, "    %d,\n    %d,\n    %d,\n    %d,\n", icon->left, icon->top,
            icon->right, icon->bottom);
    fprintf(out, "    %u,\n    %u,\n    %u,\n    %lu,\n    %lu,\n", icon->parts,
            icon->gradients, icon->stops, (unsigned long)icon->verbs,
            (unsigned long)icon->points);
    fprintf(out, "    %s_parts,\n", name);
    fprintf(out, "    %s%s,\n    %s%s,\n", has ? name : "NULL",
            has ? "_gradients" : "", has ? name : "NULL", has ? "_stops" : "");
    fprintf(out, "    %s_verbs,\n    %s_points,\n", name, name);
    fprintf(out, "    %s,\n};\n", has ? "&pel_icon_gradients" : "NULL");
}

static void write_icon(struct import_text *text,
                       const struct pel_icon_asset *icon)
{
    const struct import_array verbs = {"uint8_t", "verbs", icon->verbs, 1,
                                       icon->verb};
    const struct import_array points = {"int16_t", "points", 2 * icon->points,
                                        1, icon->point};
    write_parts(text, icon);
    if (icon->gradients)
        write_gradients(text, icon);
    import_array(text, &verbs);
    import_array(text, &points);
    import_struct_begin(text);
    write_struct(text, icon);
}

static void take_program_color(const struct pel_icon_asset *icon)
{
    struct pel_icon_part *const parts =
        (struct pel_icon_part *)(uintptr_t)icon->part;
    for (uint32_t i = 0; i < icon->parts; i++)
        if (parts[i].gradient == PEL_ICON_FLAT)
            parts[i].gradient = PEL_ICON_PROGRAM;
}

bool import_icon(const struct import_options *options)
{
    struct pel_icon_asset icon;
    struct icon_need need;
    struct import_text text;
    bool done = icon_load(&icon, options->source);
    if (!done)
        return false;
    if (options->symbolic)
        take_program_color(&icon);
    done = icon_need(&need, &icon) && import_text_open(&text, options, "icon");
    if (done) {
        text.scratch[0] = need.sides;
        text.scratch[1] = need.width;
        write_icon(&text, &icon);
        done = import_text_commit(&text);
    }
    if (done)
        report_icon(options, &icon);
    icon_free(&icon);
    return done;
}

/* Its alpha as grey. */
static void make_mask(struct picture *picture)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < n; i++) {
        const uint32_t a = pel_alpha(picture->pixels[i]);
        picture->pixels[i] = PEL_RGB(a, a, a);
    }
}

bool import_picture_load(struct picture *picture,
                         const struct import_options *options)
{
    struct pel_icon_asset icon;
    if (!options->icon_size)
        return texture_load(picture, options->source);
    *picture = (struct picture){0, 0, NULL};
    if (!icon_load(&icon, options->source))
        return false;
    const bool done = icon_picture(picture, &icon, options->icon_size);
    icon_free(&icon);
    if (done && options->symbolic)
        make_mask(picture);
    return done;
}
