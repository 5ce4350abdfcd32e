#include "sim/view/inspect.h"

#include "core/format/formats.h"
#include "core/image/glyph_text.h"
#include "core/outline/outline.h"
#include "core/raster/line.h"
#include "core/raster/rectangle.h"
#include "core/raster/thick_line.h"
#include "core/round/circle.h"
#include "sim/script/commands.h"

const struct inspect_format inspect_formats[INSPECT_FORMATS] = {
    {&pel_xrgb8888, false, "xrgb8888"},
    {&pel_rgb565_le, false, "rgb565_le"},
    {&pel_rgb565_le, true, "rgb565_le, dithered"},
    {&pel_gray8, false, "gray8"},
    {&pel_mono1, true, "mono1, dithered"},
};

void inspect_bands(const struct pel_surface *surface,
                   const struct pel_rect *picture, int rows, int zoom)
{
    const int32_t height = rows * zoom;
    for (int32_t y = picture->y0; y < picture->y1; y += 2 * height) {
        const struct pel_rect band = {picture->x0, y, picture->x1,
                                      pel_min(y + height, picture->y1)};
        pel_inspect_tint(surface, &band);
    }
}

void inspect_text(const struct pel_surface *surface,
                  const struct pel_font_asset *font, const char *text,
                  bool below)
{
    enum { MARGIN = 4 };
    static const struct pel_flat ink = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_flat dark = PEL_FLAT(PEL_RGBA(0, 0, 0, 176));
    const struct pel_text_size size = pel_text_measure(font, text);
    const int32_t x = surface->clip.x0, height = size.height + 2 * MARGIN;
    const int32_t y = below ? surface->clip.y1 - height : surface->clip.y0;
    const struct pel_rect box = {x, y, x + size.width + 2 * MARGIN, y + height};
    const struct pel_text_block block = {font, text, x + MARGIN, y + MARGIN};
    pel_box(surface, &box, &dark.paint);
    pel_text(surface, &block, &ink.paint);
}

/* The magnified place of a point of the picture. */
static bool enlarge(const struct pel_lens *l, const int32_t *v,
                    struct pel_point *p)
{
    enum { ZOOM = PEL_LENS_ZOOM };
    const int64_t x = (v[0] - (int64_t)PEL_PX(l->x)) * ZOOM + PEL_PX(l->left);
    const int64_t y = (v[1] - (int64_t)PEL_PX(l->y)) * ZOOM + PEL_PX(l->top);
    *p = (struct pel_point){(int32_t)x, (int32_t)y};
    return x > -PEL_PX(32000) && x < PEL_PX(32000) && y > -PEL_PX(32000) &&
           y < PEL_PX(32000);
}

/* The sides of what has corners, and circles. */
static void draw_shape(const struct pel_lens *l, const struct script *script,
                       const struct script_item *item)
{
    static const struct pel_flat line = PEL_FLAT(PEL_RGB(255, 0, 128));
    const enum script_form form = item->command->form;
    const int32_t *v = script->values + item->first;
    const bool has_corners = form == FORM_TRIANGLE || form == FORM_POLYGON;
    const bool is_circle = form == FORM_ROUND && item->count == 3;
    struct pel_point a, b;
    if (is_circle && enlarge(l, v, &a) && v[2] < PEL_PX(32000) / PEL_LENS_ZOOM)
        pel_circle_outline(&l->surface, a, v[2] * PEL_LENS_ZOOM, &line.paint);
    for (size_t i = 0; has_corners && i < item->count; i += 2)
        if (enlarge(l, v + i, &a) && enlarge(l, v + (i + 2) % item->count, &b))
            pel_line(&l->surface, a, b, &line.paint);
}

void inspect_magnifier(const struct pel_surface *surface,
                       const struct pel_surface *picture,
                       const struct script *script, int x, int y)
{
    struct pel_lens lens;
    pel_lens_draw(&lens, surface, picture, x, y);
    for (size_t i = 0; i < script->item_count; i++)
        draw_shape(&lens, script, &script->items[i]);
}
