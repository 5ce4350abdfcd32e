/* Paths and strokes of any bytes, in little or much scratch memory. */
#include "api.h"

enum { DASHES = 3, VERBS = 8, POINTS = 3 * VERBS, MEMORY = 8192 };

struct any_path {
    uint8_t verbs[VERBS];
    int16_t points16[2 * POINTS];
    struct pel_point points[POINTS];
    int32_t dash[DASHES];
    struct pel_dashes dashes;
    struct pel_path path;
    struct pel_transform transform;
    struct pel_path_shape shape;
    struct pel_polyline_shape line;
};

static struct pel_stroke any_stroke(struct api *a, struct any_path *p)
{
    struct pel_stroke stroke;
    stroke.width = input_number(&a->in);
    stroke.cap = (enum pel_cap)input_below(&a->in, 4);
    stroke.join = (enum pel_join)input_below(&a->in, 4);
    stroke.miter_limit = input_number(&a->in);
    for (int i = 0; i < DASHES; i++)
        p->dash[i] = input_number(&a->in);
    p->dashes = (struct pel_dashes){
        &pel_dashed, p->dash, (int32_t)input_below(&a->in, DASHES + 3) - 2, 0};
    p->dashes.phase = input_number(&a->in);
    stroke.dashes = p->dashes.count < -1 ? NULL : &p->dashes;
    return stroke;
}

static void take_points(struct api *a, struct any_path *p, bool wide)
{
    for (int32_t i = 0; i < p->path.point_count; i++) {
        p->points[i] = api_point(a);
        p->points16[2 * i] = (int16_t)p->points[i].x;
        p->points16[2 * i + 1] = (int16_t)p->points[i].y;
    }
    if (wide)
        p->path.points32 = &p->points[0].x;
    else
        p->path.points16 = p->points16;
}

static void take_path(struct api *a, struct any_path *p)
{
    const uint32_t how = input_byte(&a->in);
    p->path = (struct pel_path){.verbs = p->verbs};
    p->path.verb_count = (int32_t)input_below(&a->in, VERBS + 1);
    p->path.point_count = (int32_t)input_below(&a->in, POINTS + 1);
    for (int32_t i = 0; i < p->path.verb_count; i++)
        p->verbs[i] = (uint8_t)input_below(&a->in, PEL_CLOSE + 2);
    take_points(a, p, how & 1);
    p->transform.xx = input_number(&a->in);
    p->transform.xy = input_number(&a->in);
    p->transform.yx = input_number(&a->in);
    p->transform.yy = input_number(&a->in);
    p->transform.at = api_point(a);
    p->shape = (struct pel_path_shape){
        .path = &p->path,
        .transform = how & 2 ? &p->transform : NULL,
        .rule = how & 4 ? PEL_EVEN_ODD : PEL_NON_ZERO,
        .stroke = any_stroke(a, p),
        .tolerance = how & 8 ? input_number(&a->in) : 0};
    p->line = (struct pel_polyline_shape){p->points, p->path.point_count,
                                          how & 16, p->shape.stroke};
}

/* Outlines of any bytes. */
static void any_text(struct api *a, const struct pel_surface *surface,
                     const struct pel_paint *paint, void *scratch, size_t size)
{
    static const struct pel_font_range range[2] = {{'A', 2, 0}, {0x80, 1, 2}};
    static const struct pel_outline_pair pair = {0, 1, -32768};
    struct pel_outline_glyph glyph[3];
    uint8_t bytes[64];
    char string[9] = {0};
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = input_byte(&a->in);
    for (size_t i = 0; i + 1 < sizeof string; i++)
        string[i] = (char)input_byte(&a->in);
    for (int i = 0; i < 3; i++)
        glyph[i] = (struct pel_outline_glyph){
            input_below(&a->in, sizeof bytes + 2),
            (uint16_t)input_below(&a->in, sizeof bytes),
            (uint16_t)input_word(&a->in)};
    const struct pel_outline_font_asset font = {
        .magic = PEL_OUTLINE_FONT_MAGIC,
        .version = PEL_OUTLINE_FONT_VERSION,
        .em = (uint16_t)input_word(&a->in),
        .ascent = (uint16_t)input_word(&a->in),
        .left = (int16_t)input_word(&a->in),
        .bottom = (int16_t)input_word(&a->in),
        .right = (int16_t)input_word(&a->in),
        .top = (int16_t)input_word(&a->in),
        .ranges = 2,
        .glyphs = 3,
        .pairs = 1,
        .missing = input_byte(&a->in) & 1 ? 1 : PEL_FONT_NONE,
        .size = sizeof bytes,
        .range = range,
        .glyph = glyph,
        .points = bytes,
        .pair = &pair};
    const uint32_t how = input_byte(&a->in);
    struct pel_outline_text_block text = {
        .font = &font,
        .string = string,
        .align = (enum pel_text_align)(how % 3),
        .tolerance = how & 8 ? input_number(&a->in) : 0};
    if (pel_outline_font_asset_check(&font) != PEL_OK)
        return;
    text.transform = pel_outline_transform(
        &font, (int32_t)(input_word(&a->in) & 0x7FFFFF) % PEL_PX(32767),
        input_number(&a->in), api_point(a));
    if (how & 16)
        text.transform.xy = input_number(&a->in);
    (how & 32 ? pel_smooth_outline_text
              : pel_outline_text)(surface, &text, paint, scratch, size);
    pel_hit_outline_text(&text, (int32_t)(how % 8), 3);
}

/* An icon of any bytes. */
struct any_icon {
    struct pel_icon_part part[2];
    struct pel_icon_gradient gradient;
    struct pel_icon_stop stop[2];
    uint8_t verbs[VERBS];
    int16_t points[2 * POINTS];
    struct pel_icon_asset asset;
};

static struct pel_icon_part any_part(struct api *a)
{
    const uint32_t how = input_byte(&a->in);
    struct pel_icon_part part = {.kind = (uint8_t)(how % 3),
                                 .gradient =
                                     how & 4 ? 0 : (uint8_t)(254 + (how >> 7)),
                                 .cap = (uint8_t)(how >> 3 & 3),
                                 .join = (uint8_t)(how >> 5 & 3)};
    part.color = (pel_color)input_number(&a->in);
    part.verbs = (uint16_t)input_below(&a->in, VERBS);
    part.points = (uint16_t)input_below(&a->in, POINTS);
    part.width = (uint16_t)input_word(&a->in);
    part.miter_limit = (uint16_t)input_word(&a->in);
    return part;
}

static void take_parts(struct api *a, struct any_icon *icon)
{
    struct pel_icon_gradient *const g = &icon->gradient;
    for (int i = 0; i < 2; i++) {
        icon->part[i] = any_part(a);
        icon->stop[i].at = (uint16_t)input_word(&a->in);
        icon->stop[i].color = (pel_color)input_number(&a->in);
    }
    for (int i = 0; i < 3; i++) {
        g->frame[i].x = input_number(&a->in);
        g->frame[i].y = input_number(&a->in);
    }
    g->focus = (uint16_t)input_word(&a->in);
    g->radial = input_byte(&a->in) & 1;
    g->spread = input_byte(&a->in) & 3;
    g->stops = 2;
    for (int i = 0; i < VERBS; i++)
        icon->verbs[i] = (uint8_t)input_below(&a->in, PEL_CLOSE + 2);
    for (int i = 0; i < 2 * POINTS; i++)
        icon->points[i] = (int16_t)input_word(&a->in);
}

static void take_icon(struct api *a, struct any_icon *icon, uint32_t how)
{
    struct pel_icon_asset *const asset = &icon->asset;
    *asset = (struct pel_icon_asset){.magic = PEL_ICON_MAGIC,
                                     .version = PEL_ICON_VERSION,
                                     .strokes = how & 1,
                                     .right = 32767,
                                     .bottom = 32767,
                                     .parts = 2,
                                     .gradients = 1,
                                     .stops = 2,
                                     .verbs = VERBS,
                                     .points = POINTS,
                                     .part = icon->part,
                                     .gradient = &icon->gradient,
                                     .stop = icon->stop,
                                     .verb = icon->verbs,
                                     .point = icon->points,
                                     .painter = &pel_icon_gradients};
    asset->width = (uint16_t)input_word(&a->in);
    asset->height = (uint16_t)input_word(&a->in);
    asset->left = (int16_t)(how & 2 ? 0x8000 : input_word(&a->in));
    asset->top = (int16_t)(how & 2 ? 0x8000 : input_word(&a->in));
}

static void draw_icon(struct api *a, const struct pel_surface *surface,
                      void *scratch, size_t size)
{
    static const struct pel_icon_kind *const kinds[2][2] = {
        {&pel_icon_aliased, &pel_icon_aliased_strokes},
        {&pel_icon_smooth, &pel_icon_smooth_strokes}};
    const uint32_t how = input_byte(&a->in);
    struct any_icon icon;
    struct pel_icon_shape shape = {.icon = &icon.asset,
                                   .kind = kinds[how >> 2 & 1][how & 1]};
    take_parts(a, &icon);
    take_icon(a, &icon, how);
    shape.color = (pel_color)input_number(&a->in);
    shape.tolerance = how & 8 ? input_number(&a->in) : 0;
    if (pel_icon_asset_check(&icon.asset) != PEL_OK)
        return;
    pel_icon_place(&shape, (int32_t)(input_word(&a->in) & 0x7FFFFF),
                   input_number(&a->in), api_point(a));
    if (how & 16) {
        shape.transform.xy = input_number(&a->in);
        shape.scale = input_number(&a->in);
    }
    pel_icon(surface, &shape, scratch, size);
}

void api_path(struct api *a, const struct pel_surface *surface,
              const struct pel_paint *paint)
{
    static uint64_t scratch[MEMORY / 8];
    const uint32_t kind = input_byte(&a->in);
    const size_t size = input_word(&a->in) % (MEMORY + 1);
    struct any_path p;
    if ((kind & 48) == 48) {
        draw_icon(a, surface, scratch, size);
        return;
    }
    if (kind & 8) {
        any_text(a, surface, paint, scratch, size);
        return;
    }
    take_path(a, &p);
    if (kind % 4 == 0)
        (kind & 4 ? pel_smooth_path_fill : pel_path_fill)(surface, &p.shape,
                                                          paint, scratch, size);
    else if (kind % 4 == 1)
        (kind & 4 ? pel_smooth_path_stroke
                  : pel_path_stroke)(surface, &p.shape, paint, scratch, size);
    else if (kind % 4 == 2)
        (kind & 4 ? pel_smooth_polyline : pel_polyline)(surface, &p.line, paint,
                                                        scratch, size);
    else if (kind & 4)
        pel_hit_path_fill(&p.shape, p.points[0].x, p.points[0].y);
    else
        pel_hit_path_stroke(&p.shape, p.line.n, (int32_t)size);
    pel_hit_polyline(&p.line, p.line.n, 3);
}
