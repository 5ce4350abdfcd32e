#include "sim/asset/import.h"

#include "sim/image/canvas.h"
#include "core/asset/image_asset.h"
#include "core/paint/texture_contrast.h"
#include "sim/image/format_names.h"
#include "sim/image/resize.h"
#include "sim/image/texture.h"
#include "core/format/argb8888.h"
#include "core/format/formats.h"
#include "sim/asset/report.h"
#include "sim/asset/text.h"
#include "sim/cli/message.h"

const struct pel_palette import_palettes[2] = {PEL_PALETTE(4, NULL),
                                               PEL_PALETTE(8, NULL)};

/* The colors of a picture with a palette. */
struct table {
    pel_color color[256];
    size_t count;
};

static bool has_palette(const struct pel_format *format)
{
    return format->id > PEL_FORMAT_ARGB8888;
}

static const char *name_of(const struct pel_format *format)
{
    if (has_palette(format))
        return format->bits == 4 ? "palette4" : "palette8";
    const struct format_name *entry = format_names;
    while (entry->name && entry->format != format)
        entry++;
    return entry->name ? entry->name : IMPORT_ALPHA_FORMAT;
}

static void write_palette(struct import_text *text, const struct table *table,
                          int bits)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    const struct import_array array = {"pel_color", "colors", 1u << bits, 1,
                                       table->color};
    text->palette = true;
    import_array(text, &array);
    fprintf(out,
            "\nextern const struct pel_palette %s_palette;\n"
            "const struct pel_palette %s_palette = PEL_PALETTE(%d, "
            "%s_colors);\n",
            name, name, bits, name);
}

/* A palette's colors are those of the picture. */
static unsigned contrast_of(const struct pel_surface *surface,
                            const struct picture *picture)
{
    struct pel_texels texels = {.colors = picture->pixels,
                                .width = picture->width,
                                .height = picture->height};
    if (!has_palette(surface->format))
        texels.surface = surface;
    return pel_texels_contrast(&texels);
}

/* The union gives the bytes the alignment of a word. */
static void write_asset(struct import_text *text,
                        const struct pel_surface *surface,
                        const struct picture *picture)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    struct pel_image_asset image = {
        .format = surface->format->id,
        .width = (uint16_t)surface->bounds.x1,
        .height = (uint16_t)surface->bounds.y1,
        .stride = surface->stride,
    };
    image.size = pel_image_rows(&image) * (uint32_t)image.stride;
    fprintf(out, "\nstatic const union {\n    uint8_t bytes[%u];\n",
            image.size);
    fprintf(out, "    uint32_t word;\n} %s_pixels = {{", name);
    text->column = 80;
    for (uint32_t i = 0; i < image.size; i++)
        import_item(text, "%d,", ((const uint8_t *)surface->pixels)[i]);
    fprintf(out, "\n}};\n");
    import_struct_begin(text);
    fprintf(out, "    PEL_IMAGE_MAGIC,\n    PEL_IMAGE_VERSION,\n");
    fprintf(out, "    %u, /* %s */\n", image.format, name_of(surface->format));
    fprintf(out, "    %u,\n    %u,\n", image.width, image.height);
    fprintf(out, "    %ld,\n    %lu,\n    %s_pixels.bytes,\n",
            (long)image.stride, (unsigned long)image.size, name);
    fprintf(out, "    %u,\n};\n", contrast_of(surface, picture));
}

/* As pel_argb8888 loads them; nothing that is drawn there keeps its alpha. */
static void store_alpha(const struct pel_surface *surface, int y, int width,
                        const pel_color *color)
{
    uint8_t *to = pel_surface_line(surface, y);
    for (int x = 0; x < width; x++)
        for (int k = 0; k < 4; k++)
            *to++ = (uint8_t)(color[x] >> 8 * k);
}

static bool store_indices(const struct pel_surface *surface, int y, int width,
                          const pel_color *color, struct table *table)
{
    const int bits = surface->format->bits;
    for (int x = 0; x < width; x++) {
        size_t i = 0;
        while (i < table->count && table->color[i] != color[x])
            i++;
        if (i >> bits)
            return false;
        if (i == table->count)
            table->color[table->count++] = color[x];
        pel_surface_line(surface, y)[x * bits / 8] |=
            (uint8_t)(bits == 4 && x % 2 == 0 ? i << 4 : i);
    }
    return true;
}

static bool store(const struct pel_surface *surface,
                  const struct picture *picture,
                  const struct import_options *options, struct table *table)
{
    const struct pel_format *format = surface->format;
    const int width = picture->width;
    for (int y = 0; y < picture->height; y++) {
        pel_color *row = picture_row(picture, y);
        if (has_palette(format)) {
            if (!store_indices(surface, y, width, row, table))
                return message_error_at(options->source, 0,
                                        "has more than %d colours: expected a "
                                        "picture with fewer, --palette %d, or "
                                        "another --format than palette%d",
                                        1 << format->bits, 1 << format->bits,
                                        format->bits);
        } else if (format->id == PEL_FORMAT_ARGB8888)
            store_alpha(surface, y, width, row);
        else
            format->put(surface, 0, y, width, row);
    }
    return true;
}

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

/* Writes the asset with the name of text->options. */
static bool write_picture(struct import_text *text, struct picture *picture,
                          const struct pel_format *format, struct table *table)
{
    struct canvas canvas;
    /* In memory an index is as a grey. */
    const struct pel_format *memory = !has_palette(format) ? format
                                      : format->bits == 4  ? &pel_gray4
                                                           : &pel_gray8;
    if (!canvas_init(&canvas, memory, picture->width, picture->height))
        return false;
    canvas.surface.format = format;
    const bool done = store(&canvas.surface, picture, text->options, table);
    if (done && has_palette(format))
        write_palette(text, table, format->bits);
    if (done)
        write_asset(text, &canvas.surface, picture);
    canvas_free(&canvas);
    return done;
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
    struct table table = {.count = 0};
    if (format->id < PEL_FORMAT_ARGB8888)
        blend(picture, &own);
    const bool done = write_picture(text, picture, format, &table);
    text->options = mesh.options;
    text->kind = mesh.kind;
    return done;
}

/* What the changes make beside the picture. */
struct changed {
    struct table table;
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
                           const struct pel_format *format, struct table *table)
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

static bool check_changes(const struct import_changes *c,
                          const struct pel_format *format)
{
    const bool palette = has_palette(format);
    if ((c->colors || c->own_palette) && !palette)
        return message_error("--palette is for --format palette4 and palette8");
    if (c->alpha && format->id >= PEL_FORMAT_ARGB8888)
        return message_error("--alpha is for formats without alpha");
    if (palette && !check_colors(c->colors, format))
        return false;
    if (c->dither &&
        !(palette ? c->colors || c->own_palette : format->depth[0] > 0))
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
    const struct picture_levels format_levels = {.format = format};
    if (c->has_key)
        make_clear(picture, c->key);
    if (c->has_size && !picture_resize(picture, c->size[0], c->size[1]))
        return false;
    if (c->alpha && !take_alpha(picture, &to->alpha))
        return false;
    if (format->id < PEL_FORMAT_ARGB8888)
        blend(picture, o);
    if (has_palette(format)) {
        struct table *table = &to->table;
        if (!choose_palette(picture, o, format, table))
            return false;
        const struct picture_levels levels = {.palette = table->color,
                                              .colors = (int)table->count};
        return table->count == 0 || picture_reduce(picture, &levels, c->dither);
    }
    return !c->dither || picture_reduce(picture, &format_levels, c->dither);
}

static bool write_alpha(struct import_text *text, struct picture *alpha,
                        const struct pel_format *format)
{
    if (!format)
        return true;
    struct table none = {.count = 0};
    const struct import_options *const options = text->options;
    struct import_options own = *options;
    char name[IMPORT_NAME + 8];
    snprintf(name, sizeof(name), "%s_alpha", own.name);
    own.name = name;
    text->options = &own;
    const bool done = write_picture(text, alpha, format, &none);
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
    bool done = check_changes(&options->changes, format) &&
                change(picture, options, format, &to) &&
                import_text_open(&text, options, "image");
    if (done && !(write_picture(&text, picture, format, &to.table) &&
                  write_alpha(&text, &to.alpha, mask))) {
        output_abandon(&text.output);
        done = false;
    } else
        done = done && import_text_commit(&text);
    if (done)
        report_picture(options, picture, format);
    if (done && mask)
        report_picture(options, &to.alpha, mask);
    picture_free(&to.alpha);
    return done;
}
