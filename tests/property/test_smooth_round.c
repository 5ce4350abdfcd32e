/* Smooth discs and what is made of them against their exact area; tiles,
 * mirrored pictures and complements. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/raster/dirty.h"
#include "core/smooth/smooth_arc.h"
#include "core/smooth/smooth_circle.h"
#include "core/smooth/smooth_ellipse.h"
#include "core/smooth/smooth_ring.h"
#include "core/smooth/smooth_rounded_rectangle.h"
#include "core/smooth/smooth_thick_line.h"
#include "drivers/crc.h"
#include "tests/support/check.h"
#include "tests/support/round_area.h"
#include "tests/support/shapes.h"

enum { SIZE = 24 };

static uint8_t pixels[SIZE * SIZE], others[SIZE * SIZE];
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));

static const char *text_of(const struct round *s)
{
    static char text[200];
    snprintf(text, sizeof text,
             "kind %d center %d %d to %d %d radius %d inner %d angles %d + %d; "
             "%s",
             s->kind, s->center.x, s->center.y, s->to.x, s->to.y, s->radius,
             s->inner, s->from, s->turn, cases_replay());
    return text;
}

static struct pel_surface window_of(const struct pel_rect *bounds, uint8_t *to)
{
    struct pel_surface s;
    memset(to, 0, SIZE * SIZE);
    assert_int_equal(pel_surface_init(&s, &pel_gray8, to, SIZE * SIZE, bounds),
                     PEL_OK);
    return s;
}

static void paint(const struct pel_surface *surface, const struct round *s,
                  const struct pel_paint *paint)
{
    const struct pel_ring_shape ring = {s->center, s->inner, s->radius};
    const struct pel_rounded_shape rounded = {s->center, s->to, s->radius};
    const bool turned = s->from & 1; /* by so many turns that they overflow */
    const int32_t from = s->from + (turned ? 65536 * 1000 : 0);
    const int32_t to = s->from + s->turn - (turned ? 65536 * 32000 : 0);
    const struct pel_sector_shape sector = {s->center, s->radius, from, to};
    const struct pel_arc_shape arc = {s->center, s->inner, s->radius, from, to};
    const struct pel_thick_line_shape line = {s->center, s->to, s->radius};
    const struct pel_ellipse_shape ellipse = {s->center, {s->radius, s->inner}};
    switch (s->kind) {
    case RING:
        pel_smooth_ring(surface, &ring, paint);
        break;
    case ROUNDED:
        pel_smooth_rounded_rectangle(surface, &rounded, paint);
        break;
    case SECTOR:
        pel_smooth_sector(surface, &sector, paint);
        break;
    case ARC:
        pel_smooth_arc(surface, &arc, paint);
        break;
    case LINE:
        pel_smooth_thick_line_round(surface, &line, paint);
        break;
    case ELLIPSE:
        pel_smooth_ellipse(surface, &ellipse, paint);
        break;
    case ARC_ROUND:
        pel_smooth_arc_round(surface, &arc, paint);
        break;
    default:
        pel_smooth_circle(surface, s->center, s->radius, paint);
    }
}

static void draw(const struct pel_surface *surface, const struct round *s)
{
    paint(surface, s, &white.paint);
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
    int64_t x = s->center.x + (int64_t)s->radius * d.x / 32768,
            y = s->center.y + (int64_t)s->radius * d.y / 32768;
    if (s->kind == ELLIPSE)
        y = s->center.y + (int64_t)s->inner * d.y / 32768;
    if (s->kind > ROUNDED && s->kind < LINE && random_word(r) % 2) {
        const struct pel_point ray = pel_direction(
            (uint16_t)(s->from + (random_word(r) % 2 ? s->turn : 0)));
        const int32_t at = random_between(
            r, s->kind == SECTOR ? 0 : pel_min(s->inner, s->radius), s->radius);
        x = s->center.x + (int64_t)at * ray.x / 32768;
        y = s->center.y + (int64_t)at * ray.y / 32768;
    }
    if (s->kind == LINE) {
        const int32_t most = random_between(r, 0, 256);
        const int32_t at = most & (int32_t)random_word(r);
        x = s->center.x + ((int64_t)s->to.x - s->center.x) * at / 256 +
            (int64_t)s->radius * d.x / 65536;
        y = s->center.y + ((int64_t)s->to.y - s->center.y) * at / 256 +
            (int64_t)s->radius * d.y / 65536;
    }
    if (s->kind == ROUNDED) {
        const int32_t side =
            pel_min(s->to.x - s->center.x, s->to.y - s->center.y);
        const int32_t radius = pel_min(s->radius, side / 2);
        x = (d.x < 0 ? s->center.x + radius : s->to.x - radius) +
            (int64_t)radius * d.x / 32768;
        y = (d.y < 0 ? s->center.y + radius : s->to.y - radius) +
            (int64_t)radius * d.y / 32768;
    }
    const int32_t x0 = (int32_t)(x >> 8) - random_between(r, 0, SIZE - 1),
                  y0 = (int32_t)(y >> 8) - random_between(r, 0, SIZE - 1);
    const int32_t x1 = pel_max(-32768, pel_min(x0, 32767 - SIZE)),
                  y1 = pel_max(-32768, pel_min(y0, 32767 - SIZE));
    return (struct pel_rect){x1, y1, x1 + SIZE, y1 + SIZE};
}

/* A side for a radius in corners. */
static int32_t random_size(struct random *r, int32_t radius)
{
    const int32_t size = random_word(r) % 3 ? 2 * radius : random_radius(r);
    const int32_t times = random_between(r, 0, 3);
    return pel_min(size + times * random_between(r, 0, 2000), PEL_PX(32700));
}

/* Angles of many or of few binary digits. */
static int32_t random_mask(struct random *r)
{
    return random_word(r) % 2 ? -1 : -(1 << random_between(r, 10, 14));
}

static struct round random_round(struct random *r)
{
    struct round s = {DISC, {0, 0}, {0, 0}, 0, 0, 0, 0};
    s.center.x = random_place(r);
    s.center.y = random_place(r);
    s.kind = random_word(r) % KINDS;
    s.radius = random_radius(r);
    s.inner = s.kind == ELLIPSE    ? random_radius(r)
              : random_word(r) % 2 ? random_between(r, 0, s.radius)
                                   : pel_max(s.radius - random_radius(r), 0);
    s.from = random_between(r, -70000, 70000);
    s.from &= random_mask(r);
    s.turn = random_between(r, 1, s.kind == ARC_ROUND ? 32768 : 65535);
    s.turn = pel_max(s.turn & random_mask(r), 1);
    s.to.x = s.center.x + random_size(r, s.radius);
    s.to.y = s.center.y + random_size(r, s.radius);
    if (s.kind == LINE) {
        s.to.x = s.center.x + random_radius(r);
        s.to.x -= random_radius(r);
        s.to.y = s.center.y + random_radius(r);
        s.to.y -= random_radius(r);
    }
    s.to.x = pel_max(s.to.x, -PEL_PX(32700));
    s.to.y = pel_max(s.to.y, -PEL_PX(32700));
    shape_keep_circle(s.center, s.radius);
    return s;
}

/* Small circles, and those of more than 2,048 px, are less exact; the ends of
 * arcs are rounded to 1/256 px, and the width of a line to 2^-22 of it. */
static real bound_of(const struct round *s)
{
    const bool two = s->kind == RING || s->kind == ARC || s->kind == ELLIPSE;
    const int32_t other = two && s->inner ? s->inner : s->radius;
    const int32_t most = pel_max(other, s->radius);
    const bool good = pel_min(other, s->radius) >= PEL_PX(16) &&
                      most <= PEL_PX(2048) && s->kind != ROUNDED &&
                      s->kind != ARC_ROUND && s->kind != LINE;
    return good ? 0.55L : s->kind == LINE && most > PEL_PX(4096) ? 2 : 1;
}

TEST(areas)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        const struct round s = random_round(&c.random);
        const struct pel_rect b = random_window(&c.random, &s);
        const struct pel_surface window = window_of(&b, pixels);
        if (s.kind == ARC_ROUND && (round_between_places(&s, s.from) ||
                                    round_between_places(&s, s.from + s.turn)))
            continue;
        draw(&window, &s);
        for (int32_t y = b.y0; y < b.y1; y++)
            for (int32_t x = b.x0; x < b.x1; x++) {
                const int got = pixels[(y - b.y0) * SIZE + x - b.x0];
                const real area = 255 * round_area_at(&s, x, y);
                if (real_abs(got - area) > bound_of(&s))
                    fail_msg("(%d, %d): %d, not %.3Lf; %s", x, y, got, area,
                             text_of(&s));
            }
    }
}

/* The worst that hill climbing found: radii of a pixel or two. */
TEST(worst_known)
{
    static const struct round worst[] = {
        {SECTOR, {-3334, -1290}, {0, 0}, 245, 0, 32334, 16801},
        {ARC, {-4098, -1538}, {0, 0}, 245, 0, 31386, 17749},
        {ARC_ROUND, {3079, -4349}, {0, 0}, 515, 24, 32757, 17960}};
    for (int i = 0; i < 3; i++) {
        const struct round *const s = &worst[i];
        const int32_t x0 = (s->center.x >> 8) - 4, y0 = (s->center.y >> 8) - 4;
        const struct pel_rect b = {x0, y0, x0 + SIZE, y0 + SIZE};
        const struct pel_surface window = window_of(&b, pixels);
        draw(&window, s);
        for (int k = 0; k < SIZE * SIZE; k++) {
            const real area =
                255 * round_area_at(s, x0 + k % SIZE, y0 + k / SIZE);
            if (real_abs(pixels[k] - area) > 1.2L)
                fail_msg("pixel %d: %d, not %.3Lf", k, pixels[k], area);
        }
    }
}

/* As in test_all_pictures.c: core shows the same whatever its knobs. */
TEST(every_build_draws_the_same)
{
    uint32_t crc = 0;
    for (uint64_t i = 0; i < 4000; i++) {
        struct random r = {i * i};
        struct round s = random_round(&r);
        s.kind = i % 3 ? LINE : s.kind;
        const struct pel_rect b = random_window(&r, &s);
        const struct pel_surface window = window_of(&b, pixels);
        draw(&window, &s);
        crc = pel_crc(crc, pixels, sizeof pixels);
    }
    assert_int_equal(crc, 0x9B9BF10F);
}

/* A disc and a ring around it are a disc. */
TEST(complements)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct round s = random_round(&c.random);
        const struct pel_rect b = random_window(&c.random, &s);
        static uint8_t disc[SIZE * SIZE];
        const struct pel_surface ring = window_of(&b, pixels),
                                 inner = window_of(&b, others),
                                 outer = window_of(&b, disc);
        s.kind = RING;
        s.inner = pel_min(s.inner, s.radius);
        draw(&ring, &s);
        pel_smooth_circle(&outer, s.center, s.radius, &white.paint);
        pel_smooth_circle(&inner, s.center, s.inner, &white.paint);
        for (int i = 0; i < SIZE * SIZE; i++) {
            const int off = pixels[i] + others[i] - disc[i];
            if (off < -1 || off > 1)
                fail_msg("pixel %d: %d, %d and %d; %s", i, others[i], pixels[i],
                         disc[i], text_of(&s));
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
                             pixels[i], text_of(&s));
            }
    }
}

/* The picture of a mirrored disc is mirrored, and inside a window, where rows
 * and columns that mirror each other are painted together, the same as through
 * its parts. */
TEST(mirrors)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct pel_rect b = {0, 0, SIZE, SIZE};
        const struct pel_surface window = window_of(&b, pixels);
        struct pel_surface other = window_of(&b, others);
        const int32_t side = random_between(&c.random, 1, PEL_PX(SIZE) / 2);
        struct round s = {DISC, {side, side}, {0, 0}, 0, 0, 0, 0}, mirror;
        s.kind = random_word(&c.random) % ROUNDED;
        s.kind = random_word(&c.random) % 3 ? s.kind : ELLIPSE;
        s.radius = random_between(&c.random, 0, side);
        s.inner = random_word(&c.random) % 4 ? s.radius : 400;
        s.inner = random_between(&c.random, 0, pel_min(s.inner, s.radius));
        s.center.x &= random_word(&c.random) % 2 ? ~127 : -1;
        s.center.y =
            random_between(&c.random, s.radius, PEL_PX(SIZE) - s.radius);
        s.center.y &= random_word(&c.random) % 2 ? ~127 : -1;
        mirror = s;
        draw(&window, &s);
        mirror.center.x = PEL_PX(SIZE) - s.center.x;
        mirror.center.y = PEL_PX(SIZE) - s.center.y;
        for (int32_t y = 0; y < SIZE; y += 7) {
            const int32_t y1 = pel_min(y + 7, SIZE);
            other.clip = (struct pel_rect){0, y, SIZE / 3, y1};
            draw(&other, &mirror);
            other.clip.x0 = SIZE / 3;
            other.clip.x1 = SIZE;
            draw(&other, &mirror);
        }
        for (int i = 0; i < SIZE * SIZE; i++)
            if (pixels[i] != others[SIZE * SIZE - 1 - i])
                fail_msg("pixel %d: %d and %d, %s", i, pixels[i],
                         others[SIZE * SIZE - 1 - i], text_of(&s));
    }
}

TEST(dirty_boxes_end_at_what_is_covered)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct round s = random_round(&c.random);
        const struct pel_rect bounds = random_window(&c.random, &s);
        const struct pel_surface window = window_of(&bounds, pixels);
        struct pel_dirty dirty;
        draw(&window, &s);
        pel_dirty_begin(&dirty, NULL);
        paint(&window, &s, &dirty.paint);
        const struct pel_rect box = shape_box(&window);
        if (memcmp(&dirty.box, &box, sizeof box) != 0)
            fail_msg("%d for %d, %s", dirty.box.x0, box.x0, text_of(&s));
    }
}

static void print(const void *value)
{
    fprintf(stderr, "%s\n", text_of(value));
}

/* Shapes that touch the sides of their surface, in memory of its own: the
 * address sanitizer sees a pixel beside it that is read, though nothing of it
 * changes. */
TEST(touches)
{
    static const struct pel_format *const formats[] = {
        &pel_rgb565_le, &pel_rgb565_be, &pel_bgr565_le};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const int32_t width = random_between(&c.random, 1, SIZE);
        const int32_t height = random_between(&c.random, 1, 8);
        const int32_t y = random_between(&c.random, -4, SIZE / 2);
        const struct pel_rect b = {0, y, width, y + height};
        struct round s = {DISC, {0, 0}, {0, 0}, 0, 0, 0, 0};
        s.kind = random_word(&c.random) % KINDS;
        s.radius = random_between(&c.random, 0, PEL_PX(width)) & ~127;
        s.inner = random_between(&c.random, 0, s.radius);
        s.center.x = s.kind == ROUNDED ? 0 : s.radius;
        s.center.y = random_between(&c.random, PEL_PX(y), PEL_PX(y + height));
        s.to.x = random_between(&c.random, 0, PEL_PX(width));
        s.to.y = s.center.y + random_between(&c.random, 0, PEL_PX(height));
        s.from = random_between(&c.random, 0, 65535);
        s.turn = random_between(&c.random, 0, 65536);
        const size_t size = (size_t)(2 * width * height);
        void *const memory = malloc(size);
        struct pel_surface surface;
        assert_non_null(memory);
        memset(memory, 0x55, size);
        cases_keep(print, &s, sizeof s);
        assert_int_equal(pel_surface_init(&surface,
                                          formats[random_word(&c.random) % 3],
                                          memory, size, &b),
                         PEL_OK);
        draw(&surface, &s);
        free(memory);
    }
}
