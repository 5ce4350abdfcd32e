/* The seam of displays against a display that is busy for a random time: who
 * may touch the pixels, and when. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include <string.h>

#include "core/pel.h"
#include "tests/support/display_dma.h"

enum { WIDTH = 40, HEIGHT = 35, ROWS = 8, PIXELS = WIDTH * HEIGHT };

static uint32_t screen_memory[PIXELS], whole_memory[PIXELS], memory[2][PIXELS];

struct fixture {
    struct display_dma dma;
    struct pel_display display;
    struct pel_surface whole; /* what the screen must show in the end */
};

static void set_up(struct fixture *f, const struct pel_format *format,
                   struct cases *c)
{
    memset(f, 0, sizeof(*f));
    memset(screen_memory, 0, sizeof(screen_memory));
    memset(memory, 0, sizeof(memory));
    memset(whole_memory, 0, sizeof(whole_memory));
    f->dma.screen =
        surface_of(format, screen_memory, sizeof screen_memory, WIDTH, HEIGHT);
    f->whole =
        surface_of(format, whole_memory, sizeof whole_memory, WIDTH, HEIGHT);
    f->dma.random.state = random_word(&c->random);
    f->dma.most_steps = random_between(&c->random, 1, 12);
    display_dma_init(&f->display, &f->dma);
}

/* Shapes that read what is there, and time that passes between them. */
static void draw(const struct pel_surface *s, struct display_dma *dma)
{
    static const struct pel_point corners[3] = {PEL_AT(2, 1), PEL_AT(37, 9),
                                                PEL_AT(12, 33)};
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(250, 60, 10, 130));
    static const struct pel_flat smoke = PEL_FLAT(PEL_RGBA(20, 90, 240, 77));
    const struct pel_point center = PEL_AT(25, 20);
    for (int i = 0; i < 3; i++) {
        pel_triangle(s, corners, &glass.paint);
        display_dma_step(dma);
        pel_circle(s, center, PEL_PX(14), &smoke.paint);
        display_dma_step(dma);
    }
}

static void draw_whole(struct fixture *f)
{
    struct display_dma nothing = {.steps_left = 0};
    pel_clear(&f->whole, PEL_RGB(0, 0, 0));
    draw(&f->whole, &nothing);
}

static void check_screen(const struct fixture *f)
{
    assert_int_equal(f->dma.steps_left, 0);
    assert_int_equal(f->dma.touched, 0);
    assert_memory_equal(screen_memory, whole_memory,
                        (size_t)f->whole.stride * HEIGHT);
}

/* A frame in bands, in `buffers` pieces of memory in turn; those that found the
 * display busy when they began. */
static int draw_bands(struct fixture *f, int buffers, bool waits)
{
    int overlapping = 0, turn = 0;
    for (int32_t y = 0; y < HEIGHT; y += ROWS, turn++) {
        const struct pel_rect band = {0, y, WIDTH, pel_min(y + ROWS, HEIGHT)};
        struct pel_surface s;
        pel_surface_init_rect(&s, f->display.format, memory[turn % buffers],
                              pel_stride(f->display.format, WIDTH), &band);
        assert_int_equal(pel_display_begin(&f->display, &band, &s), PEL_OK);
        overlapping += f->dma.steps_left > 0;
        pel_clear(&s, PEL_RGB(0, 0, 0));
        draw(&s, &f->dma);
        assert_int_equal(pel_display_flush(&f->display, &s), PEL_OK);
        if (waits)
            assert_int_equal(pel_display_wait(&f->display), PEL_OK);
    }
    return overlapping;
}

static const struct pel_format *const formats[] = {&pel_rgb565_be, &pel_rgb888,
                                                   &pel_xrgb8888};

TEST(one_buffer_waits)
{
    struct fixture f;
    for (struct cases c = cases_of(300); cases_next(&c);) {
        set_up(&f, formats[random_word(&c.random) % 3], &c);
        draw_whole(&f);
        assert_int_equal(draw_bands(&f, 1, true), 0);
        assert_int_equal(pel_display_flip(&f.display), PEL_OK);
        check_screen(&f);
    }
}

TEST(two_buffers_in_turn_need_no_wait)
{
    struct fixture f;
    int overlapping = 0;
    for (struct cases c = cases_of(300); cases_next(&c);) {
        set_up(&f, formats[random_word(&c.random) % 3], &c);
        draw_whole(&f);
        overlapping += draw_bands(&f, 2, false);
        assert_int_equal(pel_display_flip(&f.display), PEL_OK);
        assert_int_equal(f.dma.flips, 1);
        check_screen(&f);
    }
    assert_true(overlapping > 0);
}

/* This is what the two above would look like if they were wrong. */
TEST(one_buffer_without_wait_is_noticed)
{
    struct fixture f;
    int noticed = 0;
    for (struct cases c = cases_of(300); cases_next(&c);) {
        set_up(&f, &pel_rgb565_be, &c);
        draw_bands(&f, 1, false);
        pel_display_wait(&f.display);
        noticed += f.dma.touched > 0;
    }
    assert_true(noticed > 0);
}

/* A frame that is kept, of which only what changed is sent: what was drawn
 * before is still there after the transfer, and windows are rounded. */
TEST(parts_of_a_kept_frame)
{
    struct fixture f;
    struct pel_surface s;
    struct display_dma nothing = {.steps_left = 0};
    for (struct cases c = cases_of(300); cases_next(&c);) {
        set_up(&f, formats[random_word(&c.random) % 3], &c);
        f.dma.window = 4;
        s = surface_of(f.display.format, memory[0], sizeof memory[0], WIDTH,
                       HEIGHT);
        for (int part = 0; part < 4; part++) {
            struct pel_rect area = {random_between(&c.random, 0, 20),
                                    random_between(&c.random, 0, 20),
                                    random_between(&c.random, 21, WIDTH),
                                    random_between(&c.random, 21, HEIGHT)};
            pel_display_align(&f.display, &area);
            assert_int_equal(pel_display_wait(&f.display), PEL_OK);
            assert_int_equal(pel_display_begin(&f.display, &area, &s), PEL_OK);
            draw(&s, &f.dma);
            assert_int_equal(pel_display_flush(&f.display, &s), PEL_OK);
            pel_surface_clip(&f.whole, &area);
            draw(&f.whole, &nothing);
        }
        assert_int_equal(pel_display_flip(&f.display), PEL_OK);
        check_screen(&f);
    }
}

TEST(windows_that_are_not_rounded)
{
    struct fixture f;
    struct pel_surface s;
    struct cases c = cases_of(1);
    const struct pel_rect odd = {1, 4, 9, 8};
    struct pel_rect area = odd;
    cases_next(&c);
    set_up(&f, &pel_rgb565_be, &c);
    f.dma.window = 4;
    s = surface_of(&pel_rgb565_be, memory[0], sizeof memory[0], WIDTH, HEIGHT);
    assert_int_equal(pel_display_begin(&f.display, &odd, &s), PEL_OK);
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_SIZE);
    pel_display_align(&f.display, &area);
    assert_true(area.x0 <= odd.x0 && area.x1 >= odd.x1 && area.y0 <= odd.y0 &&
                area.y1 >= odd.y1);
    assert_int_equal(pel_display_begin(&f.display, &area, &s), PEL_OK);
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_OK);
    s.clip.x1 = s.clip.x0;
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_OK);
    assert_int_equal(f.dma.transfers, 1);
}

/* What went wrong in a transfer is told by the next call that waits for it, and
 * a frame that did not arrive is not flipped to. */
TEST(a_transfer_that_never_ends)
{
    struct fixture f;
    struct pel_surface s;
    struct cases c = cases_of(1);
    cases_next(&c);
    set_up(&f, &pel_rgb565_be, &c);
    f.dma.broken = true;
    s = surface_of(&pel_rgb565_be, memory[0], sizeof memory[0], WIDTH, HEIGHT);
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_OK);
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_DEVICE);
    assert_int_equal(pel_display_wait(&f.display), PEL_ERROR_DEVICE);
    assert_int_equal(pel_display_flip(&f.display), PEL_ERROR_DEVICE);
    assert_int_equal(f.dma.flips, 0);
    assert_int_equal(f.dma.transfers, 1);
}
