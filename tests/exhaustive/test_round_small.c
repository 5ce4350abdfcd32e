/* Small shapes at places in a pixel: circles and ellipses of radii around all
 * the limits of their walk, squares with round corners of any radius. Fill,
 * outline and hit test on every pixel around. */
#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"

static struct hits hits;

static void check(const struct any_shape *s)
{
    static const struct pel_rect window = {-3, -3, 4, 4};
    hits_open(&hits, &window);
    any_draw(&hits.surface, s, &hits.paint);
    hits_check(&hits, any_fill_expected, s, any_name(s));
    hits_open(&hits, &window);
    any_draw_outline(&hits.surface, s, &hits.paint);
    hits_check(&hits, any_outline_expected, s, any_name(s));
}

static const int32_t places[] = {0, 1, 63, 127, 128, 129, 200, 255};
static const int32_t radii[] = {0,   1,   2,   64,  127, 128, 129, 130, 139,
                                160, 181, 182, 255, 256, 257, 300, 384, 512};
enum {
    PLACES = sizeof places / sizeof *places,
    RADII = sizeof radii / sizeof *radii
};

TEST(circles_and_ellipses)
{
    struct any_shape s = {.n = 0};
    for (int a = 0; a < RADII; a++)
        for (int b = 0; b < RADII; b++)
            for (int x = 0; x < PLACES; x++)
                for (int y = 0; y < PLACES; y++) {
                    s.radius = radii[a];
                    s.inner = radii[b];
                    s.v[0] = (struct pel_point){places[x], places[y]};
                    s.kind = ANY_ELLIPSE;
                    check(&s);
                    s.kind = ANY_CIRCLE;
                    if (a == b)
                        check(&s);
                }
}

/* One pixel centre is enough for shapes smaller than a pixel: every square of
 * up to 40 sub-pixels that holds it, with every radius that matters. */
TEST(tiny_round_corners)
{
    struct any_shape s = {.kind = ANY_ROUNDED_RECTANGLE};
    for (int32_t side = 1; side <= 40; side++)
        for (int32_t x = 0; x <= side; x++)
            for (int32_t y = 0; y <= x; y++)
                for (int32_t r = 0; r <= side; r += 1 + r / 4 * 3) {
                    s.v[0] = (struct pel_point){128 - x, 128 - y};
                    s.v[1] = (struct pel_point){128 - x + side, 128 - y + side};
                    s.radius = side - r;
                    if (any_hit(&s, 0, 0) != any_reference_at(&s, 0, 0))
                        fail_msg("hit: side %d at %d, %d", side, x, y);
                    hits_open(&hits, &(struct pel_rect){0, 0, 1, 1});
                    any_draw(&hits.surface, &s, &hits.paint);
                    hits_check(&hits, any_fill_expected, &s, "round corners");
                }
}

TEST(round_corners)
{
    struct any_shape s = {.kind = ANY_ROUNDED_RECTANGLE};
    for (int w = 0; w < RADII; w++)
        for (int h = 0; h < RADII; h++)
            for (int r = 0; r < RADII; r++)
                for (int p = 0; p < PLACES; p++) {
                    const int32_t x = places[p] - 256;
                    const int32_t y = places[(p + r) % PLACES] - 256;
                    s.v[0] = (struct pel_point){x, y};
                    s.v[1] = (struct pel_point){x + 2 * radii[w],
                                                y + 2 * radii[h] + 1};
                    s.radius = radii[r];
                    check(&s);
                }
}
