#include "sim/asset/import.h"

#include "sim/image/resize.h"
#include "sim/image/texture.h"
#include "core/format/formats.h"
#include "sim/asset/report.h"
#include "sim/asset/picture_text.h"
#include "sim/cli/message.h"

const struct pel_palette import_palettes[2] = {PEL_PALETTE(4, NULL),
                                               PEL_PALETTE(8, NULL)};

/* Blends what is not opaque onto the background, with a message. */
static void blend(struct picture *picture, const struct import_options *options)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    if (texture_opaque(picture))
        return;
    for (size_t i = 0; i < n; i++) {
        const pel_color c = picture->pixels[i];
        picture->pixels[i] =
            pel_mix(options->background, c | PEL_RGB(0, 0, 0), pel_alpha(c));
    }
    message_error_at(options->source, 0,
                     "what is transparent is blended onto #%06x; "
                     "--format " IMPORT_ALPHA_FORMAT " would keep it",
                     (unsigned)(options->background & 0xFFFFFF));
}

bool import_texture(struct import_text *text, unsigned number,
                    struct picture *picture, const struct pel_format *format)
{
    const struct import_text mesh = *text;
    struct import_options own = *text->options;
    char name[IMPORT_NAME + 24];
    snprintf(name, sizeof(name), "%s_texture_%u", own.name, number);
    own.name = name;
    text->options = &own;
    text->kind = "image";
    struct picture_table table = {.count = 0};
    if (!import_has_alpha(format))
        blend(picture, &own);
    const bool done = picture_write(text, picture, format, &table, NULL);
    text->options = mesh.options;
    text->kind = mesh.kind;
    return done;
}

/* What the changes make beside the picture. */
struct changed {
    struct picture_table table;
    struct picture alpha;
};

static void make_clear(struct picture *picture, pel_color key)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < n; i++)
        if (picture->pixels[i] == key)
            picture->pixels[i] = 0;
}

static bool check_colors(int n, const struct pel_format *format)
{
    const int most = 1 << format->bits;
    return n <= most ||
           message_error("a palette of %d colours: expected %d at most, or "
                         "another --format than palette%d",
                         n, most, format->bits);
}

/* The palette that the options choose, if any. */
static bool choose_palette(struct picture *picture,
                           const struct import_options *o,
                           const struct pel_format *format,
                           struct picture_table *table)
{
    const struct import_changes *c = &o->changes;
    if (c->own_palette)
        table->count = (size_t)texture_load_palette(o->source, table->color);
    else if (c->colors)
        table->count =
            (size_t)picture_palette(picture, c->colors, table->color);
    if ((c->own_palette || c->colors) && table->count == 0)
        return false;
    return check_colors((int)table->count, format);
}

static const pel_color inks[] = {PEL_RGB(255, 255, 255), PEL_RGB(0, 0, 0),
                                 PEL_RGB(255, 0, 0), PEL_RGB(255, 255, 0)};

static bool check_changes(const struct import_changes *c,
                          const struct pel_format *format)
{
    const bool palette = import_has_palette(format);
    if ((c->colors || c->own_palette) && !palette)
        return message_error("--palette is for --format palette4 and palette8");
    if (c->alpha && import_has_alpha(format))
        return message_error("--alpha is for formats without alpha");
    if (c->compress && format->id == PEL_FORMAT_MONO1_PAGES)
        return message_error("--compress is not for mono1_pages: expected "
                             "mono1, which is copied there, too");
    if (c->compress && c->alpha)
        return message_error("--compress is for pictures that are copied, "
                             "--alpha for those that pel_masked_init takes");
    if (palette && !check_colors(c->colors, format))
        return false;
    if (c->dither && !(palette ? c->colors || c->own_palette
                               : format->depth[0] > 0 || format == &pel_inks2))
        return message_error(palette ? "--dither of a palette needs --palette"
                                     : "--dither has no use in a format of 8 "
                                       "bits a channel");
    return true;
}

/* Its alpha as grey; what is left of the picture is opaque. */
static bool take_alpha(struct picture *picture, struct picture *alpha)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    if (!picture_init(alpha, picture->width, picture->height, 0))
        return false;
    for (size_t i = 0; i < n; i++) {
        const uint32_t a = pel_alpha(picture->pixels[i]);
        alpha->pixels[i] = PEL_RGB(a, a, a);
        picture->pixels[i] |= PEL_RGB(0, 0, 0);
    }
    return true;
}

/* Key, size, alpha or background, palette, dither. */
static bool change(struct picture *picture, const struct import_options *o,
                   const struct pel_format *format, struct changed *to)
{
    const struct import_changes *c = &o->changes;
    const struct picture_levels ink_levels = {.palette = inks, .colors = 4};
    const struct picture_levels format_levels = {.format = format};
    if (c->has_key)
        make_clear(picture, c->key);
    if (c->has_size && !picture_resize(picture, c->size[0], c->size[1]))
        return false;
    if (c->alpha && !take_alpha(picture, &to->alpha))
        return false;
    if (!import_has_alpha(format))
        blend(picture, o);
    if (import_has_palette(format)) {
        struct picture_table *table = &to->table;
        if (!choose_palette(picture, o, format, table))
            return false;
        const struct picture_levels levels = {.palette = table->color,
                                              .colors = (int)table->count};
        return table->count == 0 || picture_reduce(picture, &levels, c->dither);
    }
    return !c->dither ||
           picture_reduce(picture,
                          format == &pel_inks2 ? &ink_levels : &format_levels,
                          c->dither);
}

static bool write_alpha(struct import_text *text, struct picture *alpha,
                        const struct pel_format *format)
{
    if (!format)
        return true;
    struct picture_table none = {.count = 0};
    const struct import_options *const options = text->options;
    struct import_options own = *options;
    char name[IMPORT_NAME + 8];
    snprintf(name, sizeof(name), "%s_alpha", own.name);
    own.name = name;
    text->options = &own;
    const bool done = picture_write(text, alpha, format, &none, NULL);
    text->options = options;
    text->alpha = true;
    return done;
}

bool import_picture(const struct import_options *options,
                    struct picture *picture, const struct pel_format *format)
{
    const struct pel_format *const masks[] = {NULL, &pel_gray8, &pel_gray4,
                                              &pel_mono1};
    const struct pel_format *mask = masks[options->changes.alpha];
    struct import_text text;
    struct changed to = {.alpha = {0, 0, NULL}};
    size_t in_runs = 0;
    bool done = check_changes(&options->changes, format) &&
                change(picture, options, format, &to) &&
                import_text_open(&text, options,
                                 options->changes.compress ? "runs" : "image");
    text.format = picture_format_name(format);
    if (done && !(picture_write(
                      &text, picture, format, &to.table,
                      format->id == PEL_FORMAT_MONO1_PAGES ? NULL : &in_runs) &&
                  write_alpha(&text, &to.alpha, mask))) {
        output_abandon(&text.output);
        done = false;
    } else
        done = done && import_text_commit(&text);
    if (done)
        report_picture(options, picture, format, in_runs);
    if (done && mask)
        report_picture(options, &to.alpha, mask, 0);
    picture_free(&to.alpha);
    return done;
}
