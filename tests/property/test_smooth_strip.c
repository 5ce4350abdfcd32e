/* How far an arc is from one axis at a distance from the other, against roots
 * of long doubles; and circles where these are whole numbers. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/smooth/smooth_arc.h"
#include "core/smooth/smooth_circle.h"
#include "core/smooth/smooth_ellipse.h"
#include "core/smooth/smooth_ring.h"
#include "core/smooth/smooth_rounded_rectangle.h"
#include "core/smooth/smooth_thick_line.h"
#include "core/smooth/strip.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/round_area.h"

static void print_place(const void *place)
{
    const int32_t *const v = place;
    fprintf(stderr, "radius %d distance %d\n", v[0], v[1]);
}

/* A root is short by less than 3 where it has 26 binary digits, and by less
 * than 1 more where the last ones of these are cut off. It is too large by as
 * little as its square is rounded. */
static void check_place(const int32_t v[2])
{
    const long double r = v[0], d = v[1];
    const long double exact = d < r ? 256 * sqrtl(r * r - d * d) : 0;
    struct pel_smooth_circle circle;
    int digits;
    pel_smooth_circle_set(&circle, v[0]);
    frexpl(exact, &digits);
    const long double short_by = exact - pel_smooth_arc_at(&circle, v[1], true);
    const long double unit = ldexpl(1, digits - 26);
    if (short_by < -unit / 16 ||
        short_by >= (unit < 1 ? 3 * unit + 1 : 3 * unit))
        fail_msg("short by %.3Lf of %.3Lf; %s", short_by, exact,
                 cases_replay());
}

/* A distance from anywhere; or one at which the arc is anywhere, or about where
 * the first guess of a root becomes another, which is worst there: the square
 * is a multiple of 2^29 then, and the root of a circle of 1,024 px has all
 * digits. */
static void random_place(struct random *r, int32_t v[2])
{
    const bool large = random_word(r) % 4;
    v[0] =
        large ? PEL_PX(1024)
              : random_between(r, 0, PEL_PX(32767) >> random_between(r, 0, 23));
    v[1] = random_between(r, 0, v[0]);
    if (random_word(r) % 2)
        return;
    const long double radius = v[0];
    const long double at = v[1], step = random_between(r, 32, 127);
    const long double square =
        large && random_word(r) % 2 ? ldexpl(step, 29) : at * at;
    v[1] = (int32_t)sqrtl(radius * radius - square);
    v[1] = pel_max(v[1] + random_between(r, -64, 64), 0);
}

TEST(roots)
{
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        int32_t v[2];
        random_place(&c.random, v);
        cases_keep(print_place, v, sizeof v);
        check_place(v);
    }
}

/* From where on a square has more than 32 bits. */
TEST(roots_of_256_px)
{
    for (int32_t i = 0; i < 6; i++)
        check_place((const int32_t[2]){65535 + i % 3, i / 3});
}

/* What a function finds in its memory: a byte that it forgets shows. */
static PEL_NOINLINE void spoil_stack(void)
{
    volatile uint8_t bytes[8192];
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = 0x55;
}

/* Pixels about (x, y) of a circle around a whole pixel, or half a one below. */
static void check_circle(int32_t radius, int32_t x, int32_t y, int32_t below)
{
    enum { SIDE = 8 };
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct round s = {.center = {0, below}, .radius = PEL_PX(radius)};
    const struct pel_rect b = {x - SIDE / 2, y - SIDE / 2, x + SIDE / 2,
                               y + SIDE / 2};
    uint8_t pixels[SIDE * SIDE] = {0};
    struct pel_surface surface;
    pel_surface_init(&surface, &pel_gray8, pixels, sizeof pixels, &b);
    spoil_stack();
    pel_smooth_circle(&surface, s.center, s.radius, &white.paint);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const real area =
            255 * round_area_at(&s, b.x0 + i % SIDE, b.y0 + i / SIDE);
        if (real_abs(pixels[i] - area) > 0.55L)
            fail_msg("radius %d, about (%d, %d), %d below: pixel %d is %d",
                     radius, x, y, below, i, pixels[i]);
    }
}

/* Where the border goes through the corner of four pixels: the columns that it
 * crosses in a row end there. Half a pixel below it is a root of 4^n. */
TEST(whole_numbers)
{
    for (int32_t r = 17; r < 256; r++)
        for (int32_t x = 1, y = r; x < r; x++) {
            while (x * x + y * y > r * r)
                y--;
            if (x * x + y * y == r * r)
                for (int i = 0; i < 8; i++)
                    check_circle(r, i & 1 ? x : -x, i & 2 ? y : -y,
                                 i & 4 ? 128 : 0);
        }
}

enum { RECTANGLE = 4, SHAPES = 7 };

static void draw_kind(const struct pel_surface *surface, int kind,
                      struct pel_point c, int32_t wider,
                      const struct pel_paint *paint)
{
    const struct pel_ring_shape ring = {c, PEL_PX(22), PEL_PX(30)};
    const struct pel_arc_shape arc = {c, PEL_PX(22), PEL_PX(30), 9000, 0};
    const struct pel_ellipse_shape ellipse = {c, {PEL_PX(40), PEL_PX(30)}};
    const struct pel_point up = {c.x - 3000, c.y - 6000};
    const struct pel_point down = {c.x + 3000 + wider, c.y + 6000};
    const struct pel_rounded_shape rounded = {up, down, PEL_PX(9)};
    const struct pel_thick_line_shape line = {up, down, PEL_PX(12)};
    switch (kind) {
    case 0:
        pel_smooth_circle(surface, c, PEL_PX(30), paint);
        break;
    case 1:
        pel_smooth_circle(surface, c, PEL_PX(45), paint);
        break;
    case 2:
        pel_smooth_ring(surface, &ring, paint);
        break;
    case 3:
        pel_smooth_ellipse(surface, &ellipse, paint);
        break;
    case RECTANGLE:
        pel_smooth_rounded_rectangle(surface, &rounded, paint);
        break;
    case 5:
        pel_smooth_thick_line_round(surface, &line, paint);
        break;
    default:
        pel_smooth_arc(surface, &arc, paint);
    }
}

/* Left and right halves of bands of shapes that are nearly their own mirror
 * images are the same as in the whole, where one is made of the other. */
TEST(halves)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_rect bounds = {0, 0, 96, 96};
    static uint8_t whole[96 * 96], part[96 * 96];
    struct pel_surface surface;
    for (struct cases c = cases_of(600); cases_next(&c);) {
        struct random *const r = &c.random;
        const int kind = random_between(r, 0, SHAPES - 1);
        const struct pel_point center = {
            PEL_PX(48) + 128 * random_between(r, 0, 2) +
                random_between(r, -1, 1),
            PEL_PX(48) + 64 * random_between(r, -4, 4)};
        const int32_t wider = random_between(r, 0, 1);
        memset(whole, 0, sizeof whole);
        memset(part, 0, sizeof part);
        pel_surface_init(&surface, &pel_gray8, whole, sizeof whole, &bounds);
        draw_kind(&surface, kind, center, wider, &white.paint);
        surface.pixels = part;
        for (int32_t i = 0; i < 32; i++) {
            const int32_t x = i % 2 * 48, y = i / 2 * 6;
            surface.clip = (struct pel_rect){x, y, x + 48, y + 6};
            draw_kind(&surface, kind, center, wider, &white.paint);
        }
        if (memcmp(whole, part, sizeof whole) != 0)
            fail_msg("shape %d at %d %d, wider by %d; %s", kind, center.x,
                     center.y, wider, cases_replay());
        if (kind == RECTANGLE &&
            memcmp(whole + 47 * 96, whole + 48 * 96, 96) != 0)
            fail_msg("the middle row is another; %s", cases_replay());
    }
}

/* So are rows at the side of large circles, where an arc moves by less from row
 * to row than its places are exact. */
TEST(rows)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_rect bounds = {0, -12, 8, 12};
    static uint8_t whole[24 * 8], part[24 * 8];
    struct pel_surface surface;
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *const r = &c.random;
        const int32_t radius = random_between(r, PEL_PX(1000), PEL_PX(32767));
        const struct pel_point center = {random_between(r, 0, 2047) - radius,
                                         random_between(r, -999, 999)};
        memset(whole, 0, sizeof whole);
        memset(part, 0, sizeof part);
        pel_surface_init(&surface, &pel_gray8, whole, sizeof whole, &bounds);
        pel_smooth_circle(&surface, center, radius, &white.paint);
        surface.pixels = part;
        for (int32_t y = -12; y < 12; y++) {
            surface.clip = (struct pel_rect){0, y, 8, y + 1};
            pel_smooth_circle(&surface, center, radius, &white.paint);
        }
        if (memcmp(whole, part, sizeof whole) != 0)
            fail_msg("radius %d at %d %d; %s", radius, center.x, center.y,
                     cases_replay());
    }
}

/* Some of the pixels of a surface 8 px wide. */
static void check_line(const struct pel_thick_line_shape *line,
                       const struct pel_rect *b, const uint8_t *pixels)
{
    const struct round s = {LINE, line->from, line->to, line->width, 0, 0, 0};
    for (int32_t i = 0; i < 24 * 8; i += 7) {
        const real area = 255 * round_area_at(&s, b->x0 + i % 8, b->y0 + i / 8);
        if (real_abs(pixels[i] - area) > 1.1L)
            fail_msg("pixel %d: %d, not %.3Lf; from %d %d to %d %d, %d wide; "
                     "%s",
                     i, pixels[i], area, line->from.x, line->from.y, line->to.x,
                     line->to.y, line->width, cases_replay());
    }
}

/* And of round lines, short ones and those that are wider than a strip, up to
 * the widest, level ones and others, far from row 0, too. */
TEST(rows_of_lines)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static uint8_t whole[24 * 8], part[24 * 8];
    struct pel_surface surface;
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *const r = &c.random;
        const int32_t most = random_word(r) % 8 ? 9999 : 1;
        const int32_t y0 = 20000 * random_between(r, -1, 1);
        const int32_t far = random_word(r) % 2 ? PEL_PX(32768) : 2000;
        const int32_t rise = far > 2000 && random_word(r) % 2
                                 ? random_between(r, -3000000, 3000000)
                                 : 0;
        const struct pel_rect bounds = {-4, y0 - 12, 4, y0 + 12};
        const struct pel_thick_line_shape line = {
            {random_between(r, 0, most) - far,
             PEL_PX(y0) - rise + random_between(r, -2999, 2999)},
            {far - 1 - random_between(r, 0, most),
             PEL_PX(y0) + rise + random_between(r, -2999, 2999)},
            random_between(r, 2, 2047)};
        memset(whole, 0, sizeof whole);
        memset(part, 0, sizeof part);
        pel_surface_init(&surface, &pel_gray8, whole, sizeof whole, &bounds);
        pel_smooth_thick_line_round(&surface, &line, &white.paint);
        check_line(&line, &bounds, whole);
        surface.pixels = part;
        for (int32_t y = y0 - 12; y < y0 + 12; y++) {
            surface.clip = (struct pel_rect){-4, y, 4, y + 1};
            pel_smooth_thick_line_round(&surface, &line, &white.paint);
        }
        if (memcmp(whole, part, sizeof whole) != 0)
            fail_msg("from %d %d to %d %d, %d wide; %s", line.from.x,
                     line.from.y, line.to.x, line.to.y, line.width,
                     cases_replay());
    }
}

/* The longest line is what one that is a sub-pixel shorter is in its middle. */
TEST(longest_line)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_rect bounds = {-10, -2, 10, 8};
    static uint8_t pixels[2][10 * 20];
    for (int32_t i = 0; i < 2; i++) {
        const struct pel_thick_line_shape line = {
            {-PEL_PX(32768), 0}, {PEL_PX(32768) - 1 - i, 255}, 8};
        struct pel_surface surface;
        memset(pixels[i], 0, sizeof pixels[i]);
        pel_surface_init(&surface, &pel_gray8, pixels[i], sizeof pixels[i],
                         &bounds);
        pel_smooth_thick_line_round(&surface, &line, &white.paint);
    }
    assert_memory_equal(pixels[0], pixels[1], sizeof pixels[0]);
}

/* The outermost columns of the largest circles, whose far sides lie beyond the
 * range of distances: no undefined behaviour. */
TEST(largest_radius)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static const struct pel_rect bounds = {0, 0, 20, 2};
    static uint8_t circle[2 * 20], other[2 * 20];
    const int32_t radius = PEL_PX(32767);
    const struct pel_point center = {PEL_PX(10) - radius, 1};
    const struct pel_arc_shape arc = {center, 0, radius, 49152, 81920};
    const struct pel_ellipse_shape ellipse = {center, {radius, radius}};
    struct pel_surface surface;
    pel_surface_init(&surface, &pel_gray8, circle, sizeof circle, &bounds);
    pel_smooth_circle(&surface, center, radius, &white.paint);
    surface.pixels = other;
    pel_smooth_arc(&surface, &arc, &white.paint);
    assert_memory_equal(circle, other, sizeof circle);
    memset(other, 0, sizeof other);
    pel_smooth_ellipse(&surface, &ellipse, &white.paint);
    assert_memory_equal(circle, other, sizeof circle);
    assert_int_equal(circle[9], 255);
    assert_int_equal(circle[10], 0);
}

static int calls;

static void count_call(const struct pel_paint *paint,
                       const struct pel_spans *spans)
{
    (void)paint;
    for (int32_t i = 0; i < spans->n; i++)
        assert_true(spans->span[i].x0 < spans->span[i].x1);
    calls++;
}

/* One call of the paint for a row or more, where the other way takes three; up
 * to twice as many on 32-bit CPUs, whose batches are smaller; and none for no
 * pixels. */
TEST(rows_come_in_batches)
{
    static const struct pel_paint paint = {.fill = count_call};
    static const int most[SHAPES] = {19, 25, 44, 21, 24, 45, 48};
    static const struct pel_rect bounds = {0, 0, 96, 96};
    static uint8_t pixels[96 * 96];
    struct pel_surface surface;
    pel_surface_init(&surface, &pel_gray8, pixels, sizeof pixels, &bounds);
    for (int i = 0; i < 4 * SHAPES; i++) {
        const struct pel_point center = {PEL_PX(48) + (i & 1 ? 128 : 37),
                                         PEL_PX(48) + (i & 2 ? 128 : 99)};
        calls = 0;
        draw_kind(&surface, i / 4, center, 0, &paint);
        if (!PEL_SMOOTH_TINY && calls > most[i / 4] * (PEL_64BIT ? 1 : 2))
            fail_msg("kind %d at %d %d: %d calls", i / 4, center.x, center.y,
                     calls);
    }
}
