/* Pictures of which only the dirty areas are drawn and sent, by a display that
 * is busy for a random time, against pictures that are drawn whole. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include <string.h>

#include "core/pel.h"
#include "drivers/dirty.h"
#include "drivers/display_memory.h"
#include "tests/support/display_dma.h"

enum { WIDTH = 61, HEIGHT = 47, PIXELS = WIDTH * HEIGHT, FIGURES = 5 };

static uint32_t screen_memory[PIXELS], whole_memory[PIXELS], memory[2][PIXELS];

struct fixture {
    struct display_dma dma;
    struct pel_display display;
    struct pel_surface whole;
    struct figure {
        struct pel_point at;
        int32_t radius;
        struct pel_flat paint;
    } figure[FIGURES];
};

static const struct pel_format *const formats[] = {&pel_rgb565_be, &pel_rgb888,
                                                   &pel_xrgb8888,  &pel_gray8,
                                                   &pel_gray4,     &pel_mono1};

static void set_up(struct fixture *f, struct random *r)
{
    const struct pel_format *format = formats[random_word(r) % 6];
    memset(f, 0, sizeof(*f));
    f->dma.screen =
        surface_of(format, screen_memory, sizeof screen_memory, WIDTH, HEIGHT);
    f->whole =
        surface_of(format, whole_memory, sizeof whole_memory, WIDTH, HEIGHT);
    f->dma.random.state = random_word(r);
    f->dma.most_steps = random_between(r, 1, 30);
    f->dma.window = 1 << random_between(r, 0, 3);
    display_dma_init(&f->display, &f->dma);
}

static void draw(void *context, const struct pel_surface *s)
{
    static const struct pel_point corners[3] = {PEL_AT(0, 0), PEL_AT(61, 5),
                                                PEL_AT(9, 47)};
    static const pel_color colors[3] = {PEL_RGB(250, 9, 9), PEL_RGB(0, 200, 90),
                                        PEL_RGB(30, 40, 250)};
    struct fixture *f = context;
    pel_clear(s, PEL_RGB(20, 30, 40));
    pel_triangle_gouraud(s, corners, colors);
    for (int i = 0; i < FIGURES; i++) {
        display_dma_step(&f->dma);
        pel_circle(s, f->figure[i].at, f->figure[i].radius,
                   &f->figure[i].paint.paint);
    }
}

static void add(const struct fixture *f, const struct figure *figure,
                struct pel_dirty_areas *dirty)
{
    struct pel_dirty box;
    pel_dirty_begin(&box, NULL);
    pel_circle(&f->whole, figure->at, figure->radius, &box.paint);
    pel_dirty_areas_add(dirty, &box.box);
}

/* Some figures change; where they were and are is dirty. */
static void move(struct fixture *f, struct random *r,
                 struct pel_dirty_areas *dirty)
{
    for (int32_t i = random_between(r, 0, 3); i > 0; i--) {
        struct figure *figure = &f->figure[random_word(r) % FIGURES];
        const struct pel_flat paint = PEL_FLAT(random_word(r));
        add(f, figure, dirty);
        figure->at.x = random_between(r, -2000, 256 * WIDTH + 2000);
        figure->at.y = random_between(r, -2000, 256 * HEIGHT + 2000);
        figure->radius = random_between(r, 0, 256 * random_between(r, 1, 12));
        figure->paint = paint;
        add(f, figure, dirty);
    }
}

/* What the areas are to cost, by themselves. */
static uint32_t bytes_of(const struct fixture *f,
                         const struct pel_dirty_areas *dirty)
{
    uint32_t bytes = 0;
    for (int32_t i = 0; i < dirty->count; i++) {
        struct pel_rect a = dirty->area[i];
        pel_display_align(&f->display, &a);
        bytes += (uint32_t)((a.y1 - a.y0) *
                            pel_stride(f->display.format, a.x1 - a.x0));
    }
    return bytes;
}

static void check_screen(const struct fixture *f,
                         const struct pel_surface *screen)
{
    for (int32_t y = 0; y < HEIGHT; y++) {
        pel_color shown[WIDTH], whole[WIDTH];
        screen->format->load(screen, 0, y, WIDTH, shown);
        screen->format->load(&f->whole, 0, y, WIDTH, whole);
        assert_memory_equal(shown, whole, sizeof whole);
    }
}

static void show(struct fixture *f, struct random *r,
                 struct pel_dirty_areas *dirty)
{
    const uint32_t before = f->dma.bytes, expected = bytes_of(f, dirty);
    struct pel_dirty_work work = {
        {memory[0], memory[1]}, sizeof memory[0], draw, f};
    work.size = (size_t)random_between(r, 4 * 8 * WIDTH, sizeof memory[0]);
    if (random_word(r) % 4 == 0)
        work.memory[1] = NULL;
    assert_true(dirty->count <= PEL_DIRTY_AREAS);
    assert_int_equal(pel_dirty_areas_show(dirty, &f->display, &work), PEL_OK);
    assert_int_equal(dirty->count, 0);
    assert_int_equal(f->dma.bytes - before, expected);
    draw(f, &f->whole);
    assert_int_equal(f->dma.touched, 0);
    check_screen(f, &f->dma.screen);
}

TEST(dirty_frames_equal_whole_ones)
{
    static struct fixture f;
    uint64_t sent = 0, whole = 0;
    for (struct cases c = cases_of(200); cases_next(&c);) {
        struct pel_dirty_areas dirty = {.window =
                                            random_between(&c.random, 0, 100)};
        set_up(&f, &c.random);
        pel_dirty_areas_add(&dirty, &f.whole.bounds);
        for (int frame = 0; frame < 50; frame++) {
            show(&f, &c.random, &dirty);
            move(&f, &c.random, &dirty);
            whole += (uint32_t)f.whole.stride * HEIGHT;
        }
        sent += f.dma.bytes;
    }
    assert_true(sent < whole / 2);
}

static void check_areas(const struct pel_rect *add, int n, int32_t window,
                        const struct pel_rect *expected, int count)
{
    struct pel_dirty_areas dirty = {.window = window};
    for (int i = 0; i < n; i++)
        pel_dirty_areas_add(&dirty, &add[i]);
    assert_int_equal(dirty.count, count);
    assert_memory_equal(dirty.area, expected, (size_t)count * sizeof *expected);
}

/* A round that ends with an error leaves a band in flight. */
TEST(round_after_an_error)
{
    static struct fixture f;
    struct random r = {3};
    struct pel_dirty_areas dirty = {.window = 0};
    struct pel_dirty_work work = {{memory[0], memory[1]}, 64, draw, &f};
    set_up(&f, &r);
    f.dma.window = 0;
    f.dma.most_steps = 1000;
    pel_dirty_areas_add(&dirty, &(struct pel_rect){0, 0, 8, 1});
    pel_dirty_areas_add(&dirty, &(struct pel_rect){0, 20, WIDTH, 21});
    work.size = (size_t)f.whole.stride - 1;
    assert_int_equal(pel_dirty_areas_show(&dirty, &f.display, &work),
                     PEL_ERROR_SCRATCH);
    assert_true(f.dma.steps_left > FIGURES);
    work.size = sizeof memory[0];
    assert_int_equal(pel_dirty_areas_show(&dirty, &f.display, &work), PEL_OK);
    assert_int_equal(f.dma.touched, 0);
}

/* Of odd places and sizes, on a display whose pixels share bytes. */
TEST(areas_of_pages)
{
    static struct fixture f;
    static struct pel_display_memory screen;
    struct pel_display display;
    for (struct cases c = cases_of(500); cases_next(&c);) {
        struct pel_dirty_work work = {{memory[0], memory[1]}, 0, draw, &f};
        struct pel_dirty_areas dirty = {.window = 0};
        const int32_t x = random_between(&c.random, 0, WIDTH - 1);
        const int32_t y = random_between(&c.random, 0, HEIGHT - 1);
        set_up(&f, &c.random);
        f.whole = surface_of(&pel_mono1_pages, whole_memory,
                             sizeof whole_memory, WIDTH, HEIGHT);
        screen.screen = surface_of(&pel_mono1_pages, screen_memory,
                                   sizeof screen_memory, WIDTH, HEIGHT);
        pel_display_memory_init(&display, &screen);
        draw(&f, &f.whole);
        draw(&f, &screen.screen);
        pel_dirty_areas_add(&dirty, &(struct pel_rect){x, y, x + 9, y + 1});
        work.size = (size_t)random_between(&c.random, WIDTH, 4 * WIDTH);
        assert_int_equal(pel_dirty_areas_show(&dirty, &display, &work), PEL_OK);
        assert_int_equal(dirty.count, 0);
        check_screen(&f, &screen.screen);
    }
}

TEST(areas_are_joined_where_that_costs_least)
{
    struct pel_rect row[PEL_DIRTY_AREAS + 1];
    const struct pel_rect apart[3] = {
        {0, 0, 4, 4}, {6, 0, 10, 4}, {0, 30, 4, 34}};
    const struct pel_rect one = {0, 0, 10, 4}, none = {5, 5, 5, 9};
    const struct pel_rect plane[2] = {
        {-32768, -32768, 32767, 32767},
        {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}};
    const struct pel_rect most = {0, 0, 32767, 32767};
    const struct pel_rect inner[2] = {{0, 0, 10, 10}, {2, 2, 5, 5}};
    check_areas(&none, 1, 50, NULL, 0);
    check_areas(plane, 2, 0, &most, 1);
    check_areas(inner, 2, 0, inner, 1);
    check_areas(apart, 3, 0, apart, 3);
    check_areas(apart, 3, 8, apart, 3); /* the gap is 2 x 4 */
    check_areas(apart, 2, 9, &one, 1);
    for (int32_t i = 0; i <= PEL_DIRTY_AREAS; i++)
        row[i] = (struct pel_rect){i * i * 10, 0, i * i * 10 + 1, 1};
    struct pel_rect joined[PEL_DIRTY_AREAS];
    memcpy(joined, row, sizeof joined);
    joined[0].x1 = 11; /* the nearest two, when there is one too many */
    joined[1] = row[PEL_DIRTY_AREAS];
    check_areas(row, PEL_DIRTY_AREAS + 1, 0, joined, PEL_DIRTY_AREAS);
}

/* An error ends the redraw, and the areas stay dirty. */
TEST(errors)
{
    static struct fixture f;
    struct random r = {1};
    struct pel_dirty_areas dirty = {.window = 0};
    struct pel_dirty_work work = {{memory[0], memory[1]}, 3, draw, &f};
    set_up(&f, &r);
    pel_dirty_areas_add(&dirty, &f.whole.bounds);
    assert_int_equal(pel_dirty_areas_show(&dirty, &f.display, &work),
                     PEL_ERROR_SCRATCH);
    f.dma.window = 8;
    work.size = 7 * (size_t)f.whole.stride;
    assert_int_equal(pel_dirty_areas_show(&dirty, &f.display, &work),
                     PEL_ERROR_SCRATCH);
    work.size = sizeof memory[0] / 4;
    f.dma.broken = true;
    assert_int_equal(pel_dirty_areas_show(&dirty, &f.display, &work),
                     PEL_ERROR_DEVICE);
    assert_int_equal(dirty.count, 1);
}
