/* Scenes in every format, in bands and tiles, opaque and not, sorted and with a
 * depth buffer: bands equal the whole, and formats the 24-bit picture packed.
 */
#include <string.h>

#include "core/scene/select.h"
#include "tests/support/any_scene.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"

enum { SIDE = 64 };

struct drawing {
    struct any_scene s;
    struct pel_frame frame;
    int depth_bits; /* 0: sorted */
};

static void any_drawing(struct random *r, struct drawing *d)
{
    static const struct pel_shading *const shading[] = {
        &pel_shade_flat,          &pel_shade_gouraud,
        &pel_shade_lit_flat,      &pel_shade_lit_gouraud,
        &pel_shade_phong,         &pel_shade_chosen,
        &pel_perspective_gouraud, &pel_perspective_lit_gouraud,
        &pel_perspective_phong,   &pel_perspective_chosen};
    static const struct pel_mapping *const mapping[] = {
        &pel_map_affine, &pel_map_perspective, &pel_map_vertices,
        &pel_map_chosen};
    struct pel_scene *scene = &d->s.scene;
    any_scene(r, &d->s, SIDE);
    any_scene_light(r, &d->s);
    if (random_word(r) % 2) {
        any_scene_noise(r, &d->s, 4);
        d->s.texture.mapping = mapping[random_word(r) % 4];
        d->s.texture.span = (int32_t)(UINT32_C(1) << random_word(r) % 7);
        if (random_word(r) % 2)
            d->s.texture.sampler = pel_texture_init_nearest;
    }
    scene->shading = shading[random_word(r) % 10];
    scene->tolerance = scene->texel_tolerance = random_between(r, 0, 2048);
    scene->cull = (enum pel_cull)(random_word(r) % 3);
    scene->transparency = random_word(r) % 2 ? 0 : (uint8_t)random_word(r);
    d->depth_bits = (int)(random_word(r) % 3) * 16;
    if (d->depth_bits)
        scene->sort = NULL;
}

static void draw(struct drawing *d, struct canvas *canvas)
{
    static uint32_t memory[SIDE * SIDE];
    struct pel_depth depth;
    if (!d->depth_bits) {
        pel_scene_draw(&d->frame, &canvas->surface);
        return;
    }
    assert_int_equal(pel_depth_init(&depth, &canvas->surface.bounds,
                                    d->depth_bits, memory, sizeof memory),
                     PEL_OK);
    pel_scene_draw_depth(&d->frame, &canvas->surface, &depth);
}

static void check_part(struct drawing *d, const struct canvas *whole,
                       const struct pel_rect *part, unsigned style)
{
    static struct canvas band;
    canvas_open(&band, whole->surface.format, part, style);
    draw(d, &band);
    canvas_check_part(whole, &band);
}

/* The middle of [a, b), where a tile of any format may begin. */
static int32_t cut(struct random *r, int32_t a, int32_t b)
{
    return a + (b - a < 16 ? 8 : random_between(r, 8, b - a - 8) & ~7);
}

TEST(bands_equal_the_whole)
{
    static struct drawing d;
    static struct canvas whole;
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct layout *l = &layouts[random_word(r) % LAYOUT_COUNT];
        any_drawing(r, &d);
        any_scene_prepare(&d.s, &d.frame);
        const struct pel_rect *v = &d.s.scene.viewport;
        canvas_open(&whole, l->format, v, random_word(r) % CANVAS_STYLES);
        draw(&d, &whole);
        canvas_check(&whole);
        const int32_t x = cut(r, v->x0, v->x1), y = cut(r, v->y0, v->y1);
        for (int i = 0; i < 4; i++) {
            struct pel_rect part = *v;
            *(i & 1 ? &part.x0 : &part.x1) = i & 1 ? x : pel_min(x, v->x1);
            *(i & 2 ? &part.y0 : &part.y1) = i & 2 ? y : pel_min(y, v->y1);
            if (!pel_rect_empty(&part))
                check_part(&d, &whole, &part, random_word(r) % CANVAS_STYLES);
        }
    }
}

/* Alpha 0 where nothing is drawn. */
static pel_color color_at(const void *exact, int32_t x, int32_t y)
{
    const pel_color color = canvas_pixel(exact, x, y);
    return color ? color | 0xFF000000 : 0;
}

TEST(formats_pack_one_picture)
{
    static struct drawing d;
    static struct canvas exact, packed;
    for (struct cases c = cases_of(1500); cases_next(&c);) {
        const struct layout *l =
            &layouts[random_word(&c.random) % LAYOUT_COUNT];
        any_drawing(&c.random, &d);
        d.s.scene.transparency = 0;
        any_scene_prepare(&d.s, &d.frame);
        const struct pel_rect *v = &d.s.scene.viewport;
        canvas_open(&exact, &pel_xrgb8888, v, 0);
        memset(exact.surface.pixels, 0, exact.size);
        draw(&d, &exact);
        canvas_open(&packed, l->format, v, 0);
        draw(&d, &packed);
        canvas_check_drawn(&packed, NULL, color_at, &exact);
    }
}
