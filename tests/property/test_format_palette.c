/* Pictures with a palette: copied and textured, they show what a picture of
 * their colors shows. */
#include <string.h>

#include "core/pel.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

enum { SIDE = 30, WIDTH = 21, HEIGHT = 13 };

static uint8_t indices[WIDTH * HEIGHT];
static pel_color table[256];
static uint32_t colors[WIDTH * HEIGHT], memory[2][SIDE * SIDE];
static const struct pel_palette palettes[2] = {PEL_PALETTE(4, table),
                                               PEL_PALETTE(8, table)};

static uint32_t index_at(int32_t bits, int32_t x, int32_t y)
{
    if (bits == 8)
        return indices[y * WIDTH + x];
    return indices[y * ((WIDTH + 1) / 2) + x / 2] >> (x % 2 ? 0 : 4) & 15;
}

static void draw(const struct pel_surface *s, const struct pel_surface *picture,
                 struct random r)
{
    const struct pel_copy_part part = {
        picture,
        {random_between(&r, -4, 9), 2, random_between(&r, 9, 25), 40},
        random_between(&r, -9, SIDE),
        random_between(&r, -9, SIDE)};
    const struct pel_texels texels = {picture, NULL, 0, 0, false};
    const struct pel_point at[3] = {PEL_AT(1, 2), PEL_AT(28, 5), PEL_AT(4, 29)};
    const struct pel_texel_point shown[3] = {{0, 0}, {5000, 900}, {-77, 4000}};
    struct pel_texture_map map;
    struct pel_texture texture;
    switch (random_word(&r) % 5) {
    case 0:
        pel_copy(s, &part);
        return;
    case 1:
        pel_copy_alpha(s, &part, (uint8_t)random_word(&r));
        return;
    case 2: /* alpha is ignored, of a key too */
        pel_copy_keyed(s, &part, table[random_word(&r) % 16]);
        return;
    default:
        assert_int_equal(pel_texture_map_triangle(&map, at, shown), PEL_OK);
        assert_int_equal(
            random_word(&r) % 2
                ? pel_texture_init_nearest(&texture, &texels, &map)
                : pel_texture_init_bilinear(&texture, &texels, &map),
            PEL_OK);
        pel_triangle(s, at, &texture.base.paint);
    }
}

TEST(a_palette_is_its_colors)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_format *format =
            layouts[random_word(r) % LAYOUT_COUNT].format;
        const struct pel_palette *palette = &palettes[random_word(r) % 2];
        const int32_t bits = palette->format.bits;
        const pel_color solid = random_word(r) % 2 ? PEL_RGB(0, 0, 0) : 0;
        for (int i = 0; i < 256; i++)
            table[i] = random_word(r) | solid;
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            indices[i] = (uint8_t)random_word(r);
        const struct pel_surface picture = surface_of(
            &palette->format, indices, sizeof indices, WIDTH, HEIGHT);
        const struct pel_surface plain =
            surface_of(&pel_argb8888, colors, sizeof colors, WIDTH, HEIGHT);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const pel_color color = table[index_at(bits, i % WIDTH, i / WIDTH)];
            for (int k = 0; k < 4; k++)
                ((uint8_t *)colors)[4 * i + k] = (uint8_t)(color >> 8 * k);
        }
        for (int i = 0; i < SIDE * SIDE; i++)
            memory[0][i] = memory[1][i] = random_word(r);
        for (int i = 0; i < 2; i++) {
            const struct pel_surface s =
                surface_of(format, memory[i], sizeof memory[i], SIDE, SIDE);
            draw(&s, i ? &plain : &picture, *r);
        }
        if (memcmp(memory[0], memory[1], sizeof memory[0]) != 0)
            fail_msg("%d bits in format %d: %s", bits, format->id,
                     cases_replay());
    }
}
