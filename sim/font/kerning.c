#include "sim/font/kerning.h"

#include <stdlib.h>

#include FT_TRUETYPE_TABLES_H
#ifdef HAVE_HARFBUZZ
#include <hb-ot.h>
#include <hb.h>
#endif

#include "sim/cli/message.h"

static bool has_table(FT_Face face, const char *name)
{
    FT_ULong size = 0;
    const FT_ULong tag = FT_MAKE_TAG(name[0], name[1], name[2], name[3]);
    return FT_Load_Sfnt_Table(face, tag, 0, NULL, &size) == 0 && size > 0;
}

#ifdef HAVE_HARFBUZZ

/* A table as FreeType has it, which unpacks WOFF. */
static hb_blob_t *table_of(hb_face_t *unused, hb_tag_t tag, void *data)
{
    FT_ULong size = 0;
    (void)unused;
    if (tag == 0 || FT_Load_Sfnt_Table(data, tag, 0, NULL, &size) != 0 ||
        size == 0 || size > UINT32_MAX)
        return NULL;
    FT_Byte *const bytes = malloc(size);
    if (!bytes || FT_Load_Sfnt_Table(data, tag, 0, bytes, &size) != 0) {
        free(bytes);
        return NULL;
    }
    return hb_blob_create((const char *)bytes, (unsigned)size,
                          HB_MEMORY_MODE_READONLY, bytes, free);
}

static void open_font(struct kerning *k, const struct font_file *file)
{
    const FT_Size_Metrics *m = &k->face->size->metrics;
    (void)file;
    hb_face_t *face = hb_face_create_for_tables(table_of, k->face, NULL);
    hb_face_set_upem(face, k->face->units_per_EM);
    k->font = hb_font_create(face);
    k->text = hb_buffer_create();
    hb_face_destroy(face);
    hb_font_set_scale(k->font,
                      (int)FT_MulFix(k->face->units_per_EM, m->x_scale),
                      (int)FT_MulFix(k->face->units_per_EM, m->y_scale));
}

void kerning_close(struct kerning *k)
{
    if (!k->font)
        return;
    hb_buffer_destroy(k->text);
    hb_font_destroy(k->font);
}

/* Of two characters, each by a glyph of its own; *is_pair: they are. */
static int width_of(const struct kerning *k, const uint32_t code[2],
                    uint32_t kern, bool *is_pair)
{
    hb_feature_t features[] = {{HB_TAG('k', 'e', 'r', 'n'), kern, 0, ~0u},
                               {HB_TAG('l', 'i', 'g', 'a'), 0, 0, ~0u},
                               {HB_TAG('c', 'l', 'i', 'g'), 0, 0, ~0u},
                               {HB_TAG('c', 'a', 'l', 't'), 0, 0, ~0u}};
    unsigned n;
    hb_buffer_clear_contents(k->text);
    hb_buffer_add_codepoints(k->text, code, 2, 0, 2);
    hb_buffer_set_direction(k->text, HB_DIRECTION_LTR);
    hb_buffer_guess_segment_properties(k->text);
    hb_shape(k->font, k->text, features, sizeof features / sizeof *features);
    const hb_glyph_position_t *at = hb_buffer_get_glyph_positions(k->text, &n);
    *is_pair = *is_pair && n == 2;
    return n == 2 ? at[0].x_advance + at[1].x_advance : 0;
}

static int by_font(const struct kerning *k, uint32_t left, uint32_t right)
{
    const uint32_t code[] = {left, right};
    bool is_pair = true;
    const int closer = width_of(k, code, 1, &is_pair);
    const int apart = width_of(k, code, 0, &is_pair);
    return is_pair ? closer - apart : 0;
}

#else

static void open_font(struct kerning *k, const struct font_file *file)
{
    (void)k;
    message_error_at(file->path, 0,
                     "has pairs in its table GPOS, which this pel, built "
                     "without HarfBuzz, leaves out: the package "
                     "libharfbuzz-dev brings it");
}

void kerning_close(struct kerning *k)
{
    (void)k;
}

static int by_font(const struct kerning *k, uint32_t left, uint32_t right)
{
    (void)k;
    (void)left;
    (void)right;
    return 0;
}

#endif

void kerning_open(struct kerning *k, FT_Face face, const struct font_file *file)
{
    *k = (struct kerning){.face = face};
    if (has_table(face, "GPOS"))
        open_font(k, file);
}

int kerning_of(const struct kerning *k, uint32_t left, uint32_t right)
{
    FT_Vector by = {0, 0};
    if (k->font)
        return by_font(k, left, right);
    if (FT_HAS_KERNING(k->face))
        FT_Get_Kerning(k->face, FT_Get_Char_Index(k->face, left),
                       FT_Get_Char_Index(k->face, right), FT_KERNING_UNFITTED,
                       &by);
    return (int)by.x;
}
