/* How much closer or further apart than their advances two characters stand: by
 * the table GPOS of a font, which HarfBuzz reads, or by its older one, kern. */
#ifndef SIM_FONT_KERNING_H
#define SIM_FONT_KERNING_H

#include <ft2build.h>
#include FT_FREETYPE_H

#include "sim/font/font.h"

struct kerning {
    FT_Face face;
    struct hb_font_t *font; /* NULL: by kern */
    struct hb_buffer_t *text;
};

/* Of a face whose size is set, in that file; both must live as long. What a
 * build without HarfBuzz leaves out is told. */
void kerning_open(struct kerning *kerning, FT_Face face,
                  const struct font_file *file);
void kerning_close(struct kerning *kerning);

/* Of two code points, 1/64 px. */
int kerning_of(const struct kerning *kerning, uint32_t left, uint32_t right);

#endif
