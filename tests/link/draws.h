/* Every shape, each on the little screen: programs take one, or all of them. */
#ifndef TESTS_LINK_DRAWS_H
#define TESTS_LINK_DRAWS_H

#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le);

static const struct pel_point center = PEL_AT(30, 30);
static const struct pel_point star[5] = {PEL_AT(32, -5), PEL_AT(51, 60),
                                         PEL_AT(2, 20), PEL_AT(69, 20),
                                         PEL_AT(12, 60)};
static const struct pel_polygon_shape polygon = {star, 5, PEL_EVEN_ODD};
static const struct pel_ring_shape ring = {PEL_AT(30, 30), PEL_PX(9),
                                           PEL_PX(40)};
static const struct pel_sector_shape sector = {PEL_AT(30, 30), PEL_PX(40), 7000,
                                               3000};
static const struct pel_arc_shape arc = {PEL_AT(30, 30), PEL_PX(9), PEL_PX(40),
                                         7000, 3000};
static const struct pel_ellipse_shape ellipse = {PEL_AT(30, 30),
                                                 PEL_AT(40, 25)};
static const struct pel_rounded_shape rounded = {PEL_AT(3, -5), PEL_AT(60, 50),
                                                 PEL_PX(12)};
static const struct pel_thick_line_shape thick = {PEL_AT(3, 5), PEL_AT(50, 60),
                                                  PEL_PX(6)};

/* Of smooth shapes: between pixels. */
static const struct pel_point between[4] = {{PEL_PX(32) + 7, PEL_PX(-5) + 9},
                                            {PEL_PX(51) + 5, PEL_PX(60) + 2},
                                            {PEL_PX(2) + 77, PEL_PX(20) + 99},
                                            {PEL_PX(30) + 37, PEL_PX(31) + 81}};
static const struct pel_ring_shape smooth_ring = {
    {PEL_PX(30) + 37, PEL_PX(31) + 81}, PEL_PX(9) + 33, PEL_PX(30)};

typedef void draw_function(const struct pel_paint *paint);

/* draw_NAME, which calls pel_NAME with the numbers of a shape. */
#define SHAPE(name, ...)                                          \
    static inline void draw_##name(const struct pel_paint *paint) \
    {                                                             \
        pel_##name(&screen, __VA_ARGS__, paint);                  \
    }
SHAPE(triangle, star)
SHAPE(triangle_or_line, star)
SHAPE(rectangle, star[2], star[1])
SHAPE(line, star[0], star[3])
SHAPE(thick_line, &thick)
SHAPE(circle, center, PEL_PX(40))
SHAPE(ring, &ring)
SHAPE(sector, &sector)
SHAPE(arc, &arc)
SHAPE(ellipse, &ellipse)
SHAPE(rounded_rectangle, &rounded)
SHAPE(triangle_outline, star)
SHAPE(rectangle_outline, star[2], star[1])
SHAPE(rounded_rectangle_outline, &rounded)
SHAPE(circle_outline, center, PEL_PX(30))
SHAPE(ellipse_outline, &ellipse)
SHAPE(arc_outline, &sector)
SHAPE(smooth_triangle, between)
SHAPE(smooth_rectangle, between[2], between[1])
SHAPE(smooth_thick_line, &thick)
SHAPE(smooth_thick_line_round, &thick)
SHAPE(smooth_circle, between[3], PEL_PX(30))
SHAPE(smooth_ring, &smooth_ring)
SHAPE(smooth_sector, &sector)
SHAPE(smooth_arc, &arc)
SHAPE(smooth_arc_round, &arc)
SHAPE(smooth_ellipse, &ellipse)
SHAPE(smooth_rounded_rectangle, &rounded)

static inline void draw_polygon(const struct pel_paint *paint)
{
    static uint32_t scratch[64];
    pel_polygon(&screen, &polygon, paint, scratch, sizeof scratch);
}

static inline void draw_smooth_polygon(const struct pel_paint *paint)
{
    static uint64_t
        scratch[PEL_SMOOTH_POLYGON_SCRATCH_SIZE(5, SCREEN_SIDE) / 8 + 1];
    pel_smooth_polygon(&screen, &polygon, paint, scratch, sizeof scratch);
}

/* A curve and lines, twice the size, and the way along it. */
static const uint8_t leaf_verbs[4] = {PEL_MOVE, PEL_CUBIC, PEL_LINE, PEL_CLOSE};
static const int16_t leaf_points[10] = {1, 2, 0, 25, 30, 25, 28, 0, 15, -4};
static const struct pel_path leaf = {leaf_verbs, leaf_points, NULL, 4, 5};
static const struct pel_transform twice = {PEL_SCALE(2), 0, 0, PEL_SCALE(2),
                                           PEL_AT(2, 5)};
static const int32_t dash_lengths[2] = {PEL_PX(5), PEL_PX(3)};
static const struct pel_dashes dashes = {&pel_dashed, dash_lengths, 2, 99};
#define LEAF(...)                                                     \
    {                                                                 \
        .path = &leaf, .transform = &twice, .stroke = { __VA_ARGS__ } \
    }
#define ROUND .width = PEL_PX(3), .cap = PEL_CAP_ROUND, .join = PEL_JOIN_ROUND
static const struct pel_path_shape stroked = LEAF(ROUND),
                                   dashed = LEAF(ROUND, .dashes = &dashes);
static const struct pel_polyline_shape zigzag = {star, 5, false, {ROUND}};

static uint64_t stroke_memory[256];

/* draw_NAME, which calls pel_FUNCTION with a shape and memory. */
#define STROKE(name, function, shape)                             \
    static inline void draw_##name(const struct pel_paint *paint) \
    {                                                             \
        pel_##function(&screen, shape, paint, stroke_memory,      \
                       sizeof stroke_memory);                     \
    }
STROKE(path, path_fill, &stroked)
STROKE(path_stroke, path_stroke, &stroked)
STROKE(path_dashes, path_stroke, &dashed)
STROKE(polyline, polyline, &zigzag)
STROKE(smooth_path, smooth_path_fill, &stroked)
STROKE(smooth_path_stroke, smooth_path_stroke, &stroked)
STROKE(smooth_path_dashes, smooth_path_stroke, &dashed)
STROKE(smooth_polyline, smooth_polyline, &zigzag)

/* A rectangle where a path is hit. */
#define HIT(name, function, shape)                                    \
    static inline void draw_hit_##name(const struct pel_paint *paint) \
    {                                                                 \
        if (pel_hit_##function(shape, 9, 20))                         \
            draw_rectangle(paint);                                    \
    }
HIT(path, path_fill, &stroked)
HIT(path_stroke, path_stroke, &stroked)
HIT(path_dashes, path_stroke, &dashed)

static inline void draw_polygon_outline(const struct pel_paint *paint)
{
    static uint32_t scratch[128];
    pel_polygon_outline(&screen, &polygon, paint, scratch, sizeof scratch);
}

/* A font of the glyphs, the range and the bits at hand. */
#define TWO_GLYPHS                                                     \
    .magic = PEL_FONT_MAGIC, .version = PEL_FONT_VERSION, .ascent = 7, \
    .descent = 1, .ranges = 1, .glyphs = 2, .missing = 1, .size = 8,   \
    .range = &range, .glyph = glyph, .bits = bits

static inline void draw_text(const struct pel_paint *paint)
{
    static const uint8_t bits[8] = {0x3C, 0x42, 0xA5, 0x81,
                                    0xA5, 0x99, 0x42, 0x3C};
    static const struct pel_font_range range = {'a', 2, 0};
    static const struct pel_font_glyph glyph[2] = {{0, 8, 8, 0, 7, 9},
                                                   {0, 7, 6, 0, 6, 8}};
    static const struct pel_font_asset font = {TWO_GLYPHS};
    static const struct pel_text_block text = {&font, "ab?\na", 40, 50};
    pel_text(&screen, &text, paint);
}

/* The same characters, of 4 bits. */
static inline void draw_smooth_text(const struct pel_paint *paint)
{
    static const uint8_t bits[8] = {0x1F, 0x38, 0x0C, 0xF2,
                                    0x03, 0x4F, 0x30, 0x61};
    static const struct pel_font_range range = {'a', 2, 0};
    static const struct pel_font_glyph glyph[2] = {
        {0, 4, 4, 0, 7, 9}, {PEL_FONT_RAW, 4, 4, 0, 6, 8}};
    static const struct pel_font_asset font = {TWO_GLYPHS,
                                               .kind = &pel_font_smooth};
    static const struct pel_text_block text = {&font, "ab?\na", 40, 50};
    pel_text(&screen, &text, paint);
}

/* An a of two curves, at an angle. */
static inline void draw_smooth_outline_text(const struct pel_paint *paint)
{
    static const uint8_t points[] = {0x14, 4,  4,    0x15, 90, 90,   0x16,
                                     8,    90, 0x19, 60,   80, 0x27, 0x20,
                                     3,    40, 0x25, 9,    30};
    static const struct pel_font_range range = {'a', 1, 0};
    static const struct pel_outline_glyph glyph = {0, sizeof points, 120};
    static const struct pel_outline_font_asset font = {
        .magic = PEL_OUTLINE_FONT_MAGIC,
        .version = PEL_OUTLINE_FONT_VERSION,
        .em = 256,
        .ascent = 200,
        .right = 999,
        .top = 255,
        .ranges = 1,
        .glyphs = 1,
        .missing = PEL_FONT_NONE,
        .size = sizeof points,
        .range = &range,
        .glyph = &glyph,
        .points = points};
    static uint64_t
        scratch[PEL_SMOOTH_PATH_SCRATCH_SIZE(9, SCREEN_SIDE) / 8 + 1];
    struct pel_outline_text_block text = {.font = &font, .string = "aa\na"};
    text.transform = pel_outline_transform(
        &font, PEL_PX(20), 9000, (struct pel_point){PEL_PX(40), PEL_PX(20)});
    pel_smooth_outline_text(&screen, &text, paint, scratch, sizeof scratch);
}

/* A fill by a gradient and a stroke, whatever the paint, at an angle. */
static inline void draw_smooth_icon(const struct pel_paint *paint)
{
    static const uint8_t verbs[] = {PEL_MOVE, PEL_CUBIC, PEL_LINE,
                                    PEL_MOVE, PEL_LINE,  PEL_LINE};
    static const int16_t points[] = {100, 100, 100, 900, 900, 900, 900, 100,
                                     500, 300, 200, 200, 800, 300, 400, 800};
    static const struct pel_icon_stop stops[] = {{0, 0xFFFFFFFF},
                                                 {4096, 0xFF2050A0}};
    static const struct pel_icon_gradient gradient = {
        .frame = {{500, 400}, {900, 500}, {400, 900}}, .radial = 1, .stops = 2};
    static const struct pel_icon_part parts[] = {
        {.verbs = 3, .points = 5, .kind = PEL_ICON_NON_ZERO},
        {.color = 0xFF306030,
         .verbs = 3,
         .points = 3,
         .kind = PEL_ICON_STROKE,
         .gradient = PEL_ICON_FLAT,
         .cap = PEL_CAP_ROUND,
         .join = PEL_JOIN_ROUND,
         .width = 90}};
    static const struct pel_icon_asset icon = {.magic = PEL_ICON_MAGIC,
                                               .version = PEL_ICON_VERSION,
                                               .strokes = 1,
                                               .width = 1000,
                                               .height = 1000,
                                               .right = 1000,
                                               .bottom = 1000,
                                               .parts = 2,
                                               .gradients = 1,
                                               .stops = 2,
                                               .verbs = sizeof verbs,
                                               .points = 8,
                                               .part = parts,
                                               .gradient = &gradient,
                                               .stop = stops,
                                               .verb = verbs,
                                               .point = points,
                                               .painter = &pel_icon_gradients};
    static uint64_t scratch[PEL_ICON_SCRATCH_SIZE(48, SCREEN_SIDE) / 8 + 1];
    struct pel_icon_shape shape = {.icon = &icon,
                                   .kind = &pel_icon_smooth_strokes};
    (void)paint;
    pel_icon_place(&shape, PEL_PX(30), 5000,
                   (struct pel_point){PEL_PX(30), PEL_PX(25)});
    pel_icon(&screen, &shape, scratch, sizeof scratch);
}

/* All of them but smooth ones and paths, each as EACH(name). */
#define EVERY_DRAW(EACH)                                                      \
    EACH(triangle), EACH(triangle_or_line), EACH(polygon), EACH(rectangle),   \
        EACH(line), EACH(thick_line), EACH(circle), EACH(ring), EACH(sector), \
        EACH(arc), EACH(ellipse), EACH(rounded_rectangle),                    \
        EACH(triangle_outline), EACH(rectangle_outline),                      \
        EACH(rounded_rectangle_outline), EACH(circle_outline),                \
        EACH(ellipse_outline), EACH(arc_outline), EACH(polygon_outline),      \
        EACH(text)

#define EVERY_SMOOTH(EACH)                                               \
    EACH(smooth_triangle), EACH(smooth_polygon), EACH(smooth_rectangle), \
        EACH(smooth_thick_line), EACH(smooth_thick_line_round),          \
        EACH(smooth_circle), EACH(smooth_ring), EACH(smooth_sector),     \
        EACH(smooth_arc), EACH(smooth_arc_round), EACH(smooth_ellipse),  \
        EACH(smooth_rounded_rectangle)

/* Smooth ones, too; the two programs of every shape are without them. */
#define EVERY_PATH(EACH)                                              \
    EACH(path), EACH(path_stroke), EACH(polyline), EACH(smooth_path), \
        EACH(smooth_path_stroke), EACH(smooth_polyline)

#endif
