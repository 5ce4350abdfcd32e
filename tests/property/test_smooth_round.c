/* Smooth discs and what is made of them against their exact area; tiles,
 * mirrored pictures and complements. */
#include <string.h>

#include "core/smooth/smooth_circle.h"
#include "tests/support/check.h"
#include "tests/support/reference_area.h"
#include "tests/support/shapes.h"

enum { SIZE = 24 };

static uint8_t pixels[SIZE * SIZE], others[SIZE * SIZE];
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

/* A shape of random numbers. */
struct round {
    struct pel_point center;
    int32_t radius;
};

static struct pel_surface window_of(const struct pel_rect *bounds, uint8_t *to)
{
    struct pel_surface s;
    memset(to, 0, SIZE * SIZE);
    assert_int_equal(pel_surface_init(&s, &pel_gray8, to, SIZE * SIZE, bounds),
                     PEL_OK);
    return s;
}

static void draw(const struct pel_surface *surface, const struct round *s)
{
    pel_smooth_circle(surface, s->center, s->radius, &white.paint);
}

static real area_at(const struct round *s, int32_t x, int32_t y)
{
    const struct area_polygon pixel =
        area_pixel((real)s->center.x, (real)s->center.y, x, y);
    const real radius = (real)s->radius / 256;
    bool inside = true;
    for (int i = 0; i < 4; i++)
        inside &= pixel.v[i].x * pixel.v[i].x + pixel.v[i].y * pixel.v[i].y <=
                  radius * radius;
    return inside ? 1 : area_in_disc(&pixel, radius);
}

/* From 0 to 32,767 px, more often small, sometimes whole. */
static int32_t random_radius(struct random *r)
{
    const int32_t radius =
        random_between(r, 0, PEL_PX(32767) >> random_between(r, 0, 23));
    return random_word(r) % 4 ? radius : radius & ~127;
}

/* Also on half and whole pixels. */
static int32_t random_place(struct random *r)
{
    const int32_t at = random_between(r, -PEL_PX(40), PEL_PX(40));
    return at & (random_word(r) % 2 ? -1 : random_word(r) % 2 ? ~127 : ~255);
}

/* The edge of the shape passes through the window. */
static struct pel_rect random_window(struct random *r, const struct round *s)
{
    const struct pel_point d = pel_direction((uint16_t)random_word(r));
    const int64_t x = s->center.x + (int64_t)s->radius * d.x / 32768,
                  y = s->center.y + (int64_t)s->radius * d.y / 32768;
    const int32_t x0 = (int32_t)(x >> 8) - random_between(r, 0, SIZE - 1),
                  y0 = (int32_t)(y >> 8) - random_between(r, 0, SIZE - 1);
    return (struct pel_rect){x0, y0, x0 + SIZE, y0 + SIZE};
}

static struct round random_round(struct random *r)
{
    return (struct round){{random_place(r), random_place(r)}, random_radius(r)};
}

static real bound_of(const struct round *s)
{
    const int32_t r = s->radius;
    return r >= PEL_PX(16) && r <= PEL_PX(2048) ? 0.55L : 1;
}

TEST(areas)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        const struct round s = random_round(&c.random);
        const struct pel_rect b = random_window(&c.random, &s);
        const struct pel_surface window = window_of(&b, pixels);
        draw(&window, &s);
        for (int32_t y = b.y0; y < b.y1; y++)
            for (int32_t x = b.x0; x < b.x1; x++) {
                const int got = pixels[(y - b.y0) * SIZE + x - b.x0];
                const real area = 255 * area_at(&s, x, y);
                if (real_abs(got - area) > bound_of(&s))
                    fail_msg("(%d, %d): %d, not %.3Lf; center %d %d radius %d, "
                             "%s",
                             x, y, got, area, s.center.x, s.center.y, s.radius,
                             cases_replay());
            }
    }
}

/* Clipped to any rectangle the pixels in it are the same. */
TEST(clips)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        const struct round s = random_round(&c.random);
        const struct pel_rect b = random_window(&c.random, &s);
        const struct pel_rect clip = shape_clip(&c.random, &b);
        const struct pel_surface whole = window_of(&b, pixels);
        struct pel_surface part = window_of(&b, others);
        draw(&whole, &s);
        pel_surface_clip(&part, &clip);
        draw(&part, &s);
        for (int32_t y = b.y0; y < b.y1; y++)
            for (int32_t x = b.x0; x < b.x1; x++) {
                const int32_t i = (y - b.y0) * SIZE + x - b.x0;
                const bool seen = x >= part.clip.x0 && x < part.clip.x1 &&
                                  y >= part.clip.y0 && y < part.clip.y1;
                if (others[i] != (seen ? pixels[i] : 0))
                    fail_msg("(%d, %d): %d of %d; %s", x, y, others[i],
                             pixels[i], cases_replay());
            }
    }
}

/* The picture of a mirrored disc is mirrored, and inside a window, where twins
 * of rows and columns are painted together, the same as through its parts. */
TEST(mirrors)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct pel_rect b = {0, 0, SIZE, SIZE};
        const struct pel_surface window = window_of(&b, pixels);
        struct pel_surface other = window_of(&b, others);
        const int32_t side = random_between(&c.random, 1, PEL_PX(SIZE) / 2);
        struct round s = {{side, side}, 0}, mirror = s;
        s.radius = random_between(&c.random, 0, side);
        if (random_word(&c.random) % 2)
            s.center.x &= ~127;
        s.center.y =
            random_between(&c.random, s.radius, PEL_PX(SIZE) - s.radius);
        s.center.y &= random_word(&c.random) % 2 ? ~127 : -1;
        mirror.radius = s.radius;
        draw(&window, &s);
        mirror.center.x = PEL_PX(SIZE) - s.center.x;
        mirror.center.y = PEL_PX(SIZE) - s.center.y;
        for (int32_t y = 0; y < SIZE; y += 7) {
            other.clip =
                (struct pel_rect){0, y, SIZE / 3, pel_min(y + 7, SIZE)};
            draw(&other, &mirror);
            other.clip.x0 = SIZE / 3;
            other.clip.x1 = SIZE;
            draw(&other, &mirror);
        }
        for (int i = 0; i < SIZE * SIZE; i++)
            if (pixels[i] != others[SIZE * SIZE - 1 - i])
                fail_msg("pixel %d: %d and %d, %s", i, pixels[i],
                         others[SIZE * SIZE - 1 - i], cases_replay());
    }
}
