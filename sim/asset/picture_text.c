#include "sim/asset/picture_text.h"

#include "core/asset/image_asset.h"
#include "core/asset/runs_asset.h"
#include "core/format/argb8888.h"
#include "core/format/formats.h"
#include "sim/cli/message.h"
#include "sim/image/canvas.h"
#include "sim/image/format_names.h"
#include "sim/image/runs.h"

const char *picture_format_name(const struct pel_format *format)
{
    if (import_has_palette(format))
        return format->bits == 4 ? "palette4" : "palette8";
    const struct format_name *entry = format_names;
    while (entry->name && entry->format != format)
        entry++;
    return entry->name ? entry->name : IMPORT_ALPHA_FORMAT;
}

static void write_palette(struct import_text *text,
                          const struct picture_table *table, int bits)
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

/* The union gives the bytes the alignment of a word. */
static void write_bytes(struct import_text *text, const char *what,
                        const uint8_t *bytes, size_t n)
{
    FILE *out = text->output.stream;
    fprintf(out, "\nstatic const union {\n    uint8_t bytes[%zu];\n", n);
    fprintf(out, "    uint32_t word;\n} %s_%s = {{", text->options->name, what);
    text->column = 80;
    for (size_t i = 0; i < n; i++)
        import_item(text, "%d,", bytes[i]);
    fprintf(out, "\n}};\n");
}

/* The first members of an asset. */
static void write_head(struct import_text *text, const char *kind,
                       const struct pel_surface *surface)
{
    FILE *out = text->output.stream;
    import_struct_begin(text);
    fprintf(out, "    PEL_%s_MAGIC,\n    PEL_%s_VERSION,\n", kind, kind);
    fprintf(out, "    %u, /* %s */\n", surface->format->id,
            picture_format_name(surface->format));
    fprintf(out, "    %d,\n    %d,\n", (int)surface->bounds.x1,
            (int)surface->bounds.y1);
}

static void write_asset(struct import_text *text,
                        const struct pel_surface *surface)
{
    FILE *out = text->output.stream;
    const struct pel_image_asset image = {
        .format = surface->format->id, .height = (uint16_t)surface->bounds.y1};
    const uint32_t size = pel_image_rows(&image) * (uint32_t)surface->stride;
    write_bytes(text, "pixels", surface->pixels, size);
    write_head(text, "IMAGE", surface);
    fprintf(out, "    %ld,\n    %lu,\n    %s_pixels.bytes,\n};\n",
            (long)surface->stride, (unsigned long)size, text->options->name);
}

static void write_runs(struct import_text *text,
                       const struct pel_surface *surface,
                       const struct runs *runs)
{
    const char *name = text->options->name;
    const bool is_short = runs_are_short(runs);
    const uint32_t height = (uint32_t)surface->bounds.y1;
    write_bytes(text, "words", runs->words, runs->size * runs->bytes);
    import_array_begin(text, is_short ? "uint16_t" : "uint32_t", "rows", height,
                       1);
    for (uint32_t y = 0; y < height; y++)
        import_item(text, "%lu,", (unsigned long)runs->rows[y]);
    import_array_end(text);
    write_head(text, "RUNS", surface);
    fprintf(text->output.stream,
            "    %lu,\n    %s_words.bytes,\n    %s%s,\n    %s%s,\n};\n",
            (unsigned long)runs->size, name, is_short ? name : "",
            is_short ? "_rows" : "NULL", is_short ? "" : name,
            is_short ? "NULL" : "_rows");
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
                          const pel_color *color, struct picture_table *table)
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
                  const struct import_options *options,
                  struct picture_table *table)
{
    const struct pel_format *format = surface->format;
    const int width = picture->width;
    for (int y = 0; y < picture->height; y++) {
        pel_color *row = picture_row(picture, y);
        if (import_has_palette(format)) {
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

bool picture_write(struct import_text *text, const struct picture *picture,
                   const struct pel_format *format, struct picture_table *table,
                   size_t *in_runs)
{
    struct canvas canvas;
    /* In memory an index is as a grey. */
    const struct pel_format *memory = !import_has_palette(format) ? format
                                      : format->bits == 4         ? &pel_gray4
                                                                  : &pel_gray8;
    if (!canvas_init(&canvas, memory, picture->width, picture->height))
        return false;
    canvas.surface.format = format;
    bool done = store(&canvas.surface, picture, text->options, table);
    if (done && import_has_palette(format))
        write_palette(text, table, format->bits);
    if (done && in_runs) {
        struct runs runs;
        done = runs_make(&runs, &canvas.surface);
        *in_runs = runs.size * runs.bytes +
                   (size_t)picture->height * (runs_are_short(&runs) ? 2 : 4);
        if (done && text->options->changes.compress)
            write_runs(text, &canvas.surface, &runs);
        runs_free(&runs);
    }
    if (done && !text->options->changes.compress)
        write_asset(text, &canvas.surface);
    canvas_free(&canvas);
    return done;
}
