#include "text_column.h"

/* Where a line ends, and where the next one begins: NULL if it is the last. */
struct line {
    const char *end, *next;
    int32_t width; /* px */
};

static struct line line_at(const struct pel_text_column *column,
                           const char *string)
{
    struct line fits = {NULL, NULL, 0}; /* up to the spaces seen last */
    const struct pel_font_glyph *last = NULL;
    int32_t x = 0, before;
    for (const char *at = string, *next = at;; at = next) {
        if (!*at || *at == '\n') {
            const bool wide = column->width > 0 && x > column->width;
            if (!wide || fits.next != at)
                fits = (struct line){at, NULL, x};
            fits.next = *at ? at + 1 : NULL;
            return fits;
        }
        const struct pel_font_asset *font = column->text.font;
        const struct pel_font_glyph *glyph =
            pel_glyph_find(&font, pel_utf8_next(&next));
        before = x;
        if (glyph) {
            x += pel_glyph_kerning(font, last, glyph) + glyph->advance;
            last = glyph;
        }
        if (*at == ' ')
            fits = fits.next == at ? (struct line){fits.end, next, fits.width}
                                   : (struct line){at, next, before};
        else if (column->width > 0 && x > column->width && at > string)
            return fits.end ? fits : (struct line){at, at, before};
    }
}

struct pel_text_size pel_text_column_draw(const struct pel_surface *surface,
                                          const struct pel_text_column *column,
                                          const struct pel_paint *paint)
{
    struct pel_text_block text = column->text;
    struct pel_text_size size = {0, 0};
    const bool legal = pel_offset_legal(text.x, text.y) &&
                       pel_offset_legal(column->width, 0) &&
                       column->width >= 0 && column->line_height >= -255 &&
                       column->line_height <= 255;
    const int32_t height = column->line_height
                               ? column->line_height
                               : text.font->ascent + text.font->descent;
    PEL_ASSERT(legal);
    while (legal && text.string) {
        const struct line line = line_at(column, text.string);
        text.x = column->text.x +
                 (column->width - line.width) * (int32_t)column->align / 2;
        if (surface && pel_offset_legal(text.x, text.y))
            pel_text_until(surface, &text, line.end, paint);
        text.string = line.next;
        text.y += height;
        size.width = pel_max(size.width, line.width);
        size.height += pel_magnitude(height);
    }
    return size;
}

struct pel_text_size pel_text_measure(const struct pel_font_asset *font,
                                      const char *string)
{
    const struct pel_text_column column = {.text = {font, string, 0, 0}};
    return pel_text_column_draw(NULL, &column, NULL);
}
