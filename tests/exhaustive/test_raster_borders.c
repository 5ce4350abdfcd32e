/* Shapes on a 4 x 4 screen whose points lie on, next to and far beyond its
 * borders, in every combination: once through a paint that counts, and once
 * into 16 bytes that end at a guard page or begin after one. */
#include <string.h>

#include "tests/support/any_shape.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"

enum { SIDE = 4, PIXELS = SIDE * SIDE };

/* Both ends of the range, pixel edges and centres beside the borders. */
static const int32_t places[] = {
    PEL_COORDINATE_MIN, -256, -128, 0, 128, 129, 640, 896, 1024, 1025, 1152,
    PEL_COORDINATE_MAX};
enum { PLACES = sizeof places / sizeof places[0] };

/* The few that polygons, of more points, take. */
static const int32_t few_places[] = {PEL_COORDINATE_MIN, 0, 384, 896,
                                     PEL_COORDINATE_MAX};
enum { FEW = sizeof few_places / sizeof few_places[0] };

static struct hits hits;
static struct canvas canvas[2];
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

static void setup(void)
{
    const struct pel_rect screen = {0, 0, SIDE, SIDE};
    hits_open(&hits, &screen);
    canvas_open(&canvas[0], &pel_gray8, &screen, CANVAS_AT_END);
    canvas_open(&canvas[1], &pel_gray8, &screen, CANVAS_UP);
}

static void fail_at(const struct any_shape *s, int i)
{
    fail_msg("%s %d,%d %d,%d %d,%d %d,%d, radius %d: wrong at %d, %d",
             any_name(s), s->v[0].x, s->v[0].y, s->v[1].x, s->v[1].y, s->v[2].x,
             s->v[2].y, s->v[3].x, s->v[3].y, s->radius, i % SIDE, i / SIDE);
}

static void check_shape(const struct any_shape *s)
{
    memset(hits.count, 0, PIXELS);
    any_draw(&hits.surface, s, &hits.paint);
    for (int k = 0; k < 2; k++) {
        memset(canvas[k].memory, 0, PIXELS);
        any_draw(&canvas[k].surface, s, &white.paint);
    }
    for (int32_t i = 0; i < PIXELS; i++) {
        const int32_t x = i % SIDE, y = i / SIDE;
        const uint32_t want = any_reference_at(s, x, y) ? 255 : 0;
        if (hits.count[i] * 255u != want ||
            canvas_pixel(&canvas[0], x, y) != want ||
            canvas_pixel(&canvas[1], x, y) != want)
            fail_at(s, i);
    }
}

static struct pel_point place(int32_t i)
{
    return (struct pel_point){places[i % PLACES], places[i / PLACES]};
}

/* Triples that differ by more than the order of their points. */
TEST(triangles)
{
    struct any_shape s = {.kind = ANY_TRIANGLE};
    for (int32_t i = 0; i < PLACES * PLACES; i++)
        for (int32_t j = i; j < PLACES * PLACES; j++)
            for (int32_t k = j; k < PLACES * PLACES; k++) {
                s.v[(i + j) % 3] = place(i);
                s.v[(i + j + 1) % 3] = place(j);
                s.v[(i + j + 2) % 3] = place(k);
                check_shape(&s);
            }
}

/* Radii about which the disc reaches a border or the far side of the screen, or
 * takes in all of it. */
TEST(circles)
{
    static const int32_t radii[] = {0,   1,   127, 128,  129,  255,  256,
                                    257, 384, 512, 1024, 1280, 2048, 300000};
    struct any_shape s = {.kind = ANY_CIRCLE};
    for (int32_t i = 0; i < PLACES * PLACES; i++) {
        s.v[0] = place(i);
        for (size_t k = 0; k < sizeof radii / sizeof radii[0]; k++) {
            s.radius = radii[k];
            check_shape(&s);
        }
        for (int32_t k = 0; k <= 1024; k++) {
            s.radius = PEL_PX(32767) - k;
            check_shape(&s);
        }
    }
}

TEST(lines_and_rectangles)
{
    struct any_shape s = {.n = 0};
    for (int32_t i = 0; i < PLACES * PLACES; i++)
        for (int32_t j = 0; j < PLACES * PLACES; j++) {
            s.v[0] = place(i);
            s.v[1] = place(j);
            s.kind = ANY_LINE;
            check_shape(&s);
            s.kind = ANY_RECTANGLE;
            check_shape(&s);
        }
}

TEST(quadrilaterals)
{
    struct any_shape s = {.kind = ANY_POLYGON, .n = 4};
    for (int32_t i = 0; i < FEW * FEW * FEW * FEW * FEW * FEW * FEW * FEW;
         i++) {
        for (int32_t k = 0, rest = i; k < 4; k++, rest /= FEW * FEW)
            s.v[k] = (struct pel_point){few_places[rest % FEW],
                                        few_places[rest / FEW % FEW]};
        for (int rule = 0; rule < 2; rule++) {
            s.rule = (enum pel_fill_rule)rule;
            check_shape(&s);
        }
    }
}

int main(void)
{
    setup();
    return run_all_tests();
}
