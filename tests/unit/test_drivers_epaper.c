/* E-paper: what is flushed is on the glass after the refresh, in every
 * rotation, kind of refresh and panel, with sleep between; and buses that fail.
 */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include <string.h>

#include "drivers/epaper.h"
#include "tests/support/cases.h"
#include "tests/support/paper_glass.h"

/* 50h of a UC8151's registers: any will do here. */
static const uint8_t ssd_waveform[] = {3, 0x32, 1, 2, 0};
static const uint8_t uc_waveform[] = {2, 0x00, 0x3F, 3, 0x20, 1, 2, 0};

static const struct module {
    const char *name;
    const struct pel_epaper_chip *chip;
    enum paper_family family;
    int width, height;
    enum { MONO, INKS, GRAYS } kind;
    const uint8_t *waveform;
} modules[] = {
    {"ssd1680", &pel_epaper_ssd1680, PAPER_SSD, 122, 250, MONO, NULL},
    {"ssd1680, color", &pel_epaper_ssd1680, PAPER_SSD, 128, 296, INKS, NULL},
    {"ssd1681", &pel_epaper_ssd1681, PAPER_SSD, 200, 200, MONO, NULL},
    {"il3897", &pel_epaper_il3897, PAPER_SSD, 122, 250, MONO, ssd_waveform},
    {"uc8151", &pel_epaper_uc8151, PAPER_UC8151, 128, 296, MONO, uc_waveform},
    {"uc8151, color", &pel_epaper_uc8151, PAPER_UC8151, 104, 212, INKS, NULL},
    {"uc8179", &pel_epaper_uc8179, PAPER_UC8179, 800, 480, MONO, NULL},
    {"uc8179, color", &pel_epaper_uc8179, PAPER_UC8179, 400, 300, INKS, NULL},
    {"ssd1680, greys", &pel_epaper_ssd1680_gray2, PAPER_SSD, 122, 250, GRAYS,
     NULL},
    {"uc8151, greys", &pel_epaper_uc8151_gray2, PAPER_UC8151, 128, 296, GRAYS,
     pel_epaper_uc8151_grays},
    {"uc8179, greys", &pel_epaper_uc8179_gray2, PAPER_UC8179, 400, 300, GRAYS,
     NULL},
};
enum { MODULES = sizeof modules / sizeof *modules };

static const struct pel_format *const formats[] = {&pel_mono1, &pel_inks2,
                                                   &pel_gray2};
static struct paper_glass glass;
static uint8_t frame[2 * PAPER_BYTES], memory[PAPER_BYTES * 2];
static uint8_t wanted[PAPER_BYTES * 8], flushed[PAPER_BYTES * 8];

struct fixture {
    const struct module *module;
    struct pel_epaper paper;
    struct pel_display display;
};

static bool read_busy(const struct pel_epaper *paper)
{
    (void)paper;
    return paper_glass_busy(&glass);
}

static enum pel_status set_up(struct fixture *f, const struct module *m,
                              int rotation)
{
    glass.family = m->family;
    glass.width = m->width;
    glass.height = m->height;
    glass.color = m->kind == INKS;
    glass.gray = m->kind == GRAYS;
    paper_glass_init(&glass);
    memset(wanted, glass.white, sizeof wanted);
    memset(flushed, glass.white, sizeof flushed);
    f->module = m;
    f->paper = (struct pel_epaper){.chip = m->chip,
                                   .bus = &glass.bus,
                                   .busy = read_busy,
                                   .format = formats[m->kind],
                                   .frame = frame,
                                   .width = (uint16_t)m->width,
                                   .height = (uint16_t)m->height,
                                   .rotation = (uint8_t)rotation,
                                   .waveform = m->waveform};
    return pel_epaper_init(&f->display, &f->paper);
}

/* Where the picture's pixel is on the glass. */
static uint8_t *at(const struct fixture *f, uint8_t *inks, int x, int y)
{
    const int w = f->module->width, h = f->module->height;
    const int turned[4][2] = {
        {x, y}, {w - 1 - y, x}, {w - 1 - x, h - 1 - y}, {y, h - 1 - x}};
    const int *p = turned[f->paper.rotation & 3];
    return &inks[p[1] * w + p[0]];
}

static int ink_of(const struct fixture *f, const struct pel_surface *s, int x,
                  int y)
{
    static const int inks[] = {PAPER_WHITE, PAPER_BLACK, PAPER_COLOR,
                               PAPER_COLOR};
    const uint8_t *row =
        (const uint8_t *)s->pixels + (y - s->bounds.y0) * s->stride;
    x -= s->bounds.x0;
    const int two = row[x / 4] >> (6 - 2 * (x % 4)) & 3;
    return f->module->kind == INKS         ? inks[two]
           : f->module->kind == GRAYS      ? PAPER_GRAY + two
           : row[x / 8] >> (7 - x % 8) & 1 ? PAPER_WHITE
                                           : PAPER_BLACK;
}

/* Random pixels, in a surface of the part alone or in a part of one. */
static enum pel_status flush_any(struct fixture *f, struct random *r)
{
    const int width = f->display.width, height = f->display.height;
    struct pel_rect area, bounds = {0, 0, width, height};
    struct pel_surface s;
    area.x0 = random_between(r, 0, width - 1);
    area.y0 = random_between(r, 0, height - 1);
    area.x1 = random_between(r, area.x0 + 1, width);
    area.y1 = random_between(r, area.y0 + 1, height);
    if (random_word(r) % 2)
        bounds = (struct pel_rect){area.x0 & ~7, area.y0, area.x1, area.y1};
    assert_int_equal(
        pel_surface_init(&s, f->paper.format, memory, sizeof memory, &bounds),
        PEL_OK);
    pel_surface_clip(&s, &area);
    for (size_t i = 0; i < sizeof memory; i++)
        memory[i] = (uint8_t)random_word(r);
    const enum pel_status status = pel_display_flush(&f->display, &s);
    for (int y = area.y0; y < area.y1 && status == PEL_OK; y++)
        for (int x = area.x0; x < area.x1; x++)
            *at(f, flushed, x, y) = (uint8_t)ink_of(f, &s, x, y);
    return status;
}

static enum pel_status flip(struct fixture *f)
{
    const enum pel_status status = pel_display_flip(&f->display);
    if (status == PEL_OK)
        memcpy(wanted, flushed, sizeof wanted);
    return status;
}

static void check_glass(const struct fixture *f)
{
    const int pixels = f->module->width * f->module->height;
    for (int i = 0; i < pixels; i++)
        if (glass.shown[i] != wanted[i])
            fail_msg("%s, rotation %d, refresh %d: pixel %d, %d is %d; %s",
                     f->module->name, f->paper.rotation, f->paper.refresh,
                     i % f->module->width, i / f->module->width, glass.shown[i],
                     cases_replay());
}

TEST(glass_shows_the_picture)
{
    static struct fixture f;
    for (struct cases c = cases_of(MODULES * 8); cases_next(&c);) {
        struct random *r = &c.random;
        const uint64_t i = c.next - 1;
        glass.dma = i % 2;
        assert_int_equal(
            set_up(&f, &modules[i / 8 % MODULES], (int)(i / 2 % 4)), PEL_OK);
        for (int n = 0; n < 6; n++) {
            for (int k = random_between(r, 0, 3); k > 0; k--)
                assert_int_equal(flush_any(&f, r), PEL_OK);
            check_glass(&f);
            f.paper.refresh =
                (uint8_t)(n == 0 || f.module->kind ? PEL_EPAPER_FULL
                                                   : random_word(r) % 3);
            assert_int_equal(flip(&f), PEL_OK);
            assert_true(pel_epaper_busy(&f.paper));
            assert_int_equal(glass.refreshes, n + 1);
            if (random_word(r) % 3 == 0)
                assert_int_equal(pel_epaper_sleep(&f.paper), PEL_OK);
            check_glass(&f);
        }
    }
}

static enum pel_status run(struct fixture *f, struct random *r)
{
    enum pel_status status = flush_any(f, r);
    if (status == PEL_OK)
        status = flip(f);
    if (status == PEL_OK)
        status = flush_any(f, r);
    f->paper.refresh =
        (uint8_t)(f->module->kind ? PEL_EPAPER_FULL : PEL_EPAPER_PARTIAL);
    if (status == PEL_OK)
        status = flip(f);
    return status == PEL_OK ? pel_epaper_sleep(&f->paper) : status;
}

/* The n-th call of the bus fails: its error comes out, nothing is sent after
 * it, and the same again shows the picture. */
TEST(every_call_that_fails)
{
    static struct fixture f;
    for (int i = 0; i < MODULES * 2; i++) {
        const struct module *m = &modules[i / 2];
        bool over = m->width > 400;
        glass.dma = i & 1;
        for (int n = 1; !over; n++) {
            struct random r = {(uint64_t)n};
            glass.fail_at = n;
            enum pel_status status = set_up(&f, m, n % 4);
            if (status == PEL_OK)
                status = run(&f, &r);
            over = status == PEL_OK;
            assert_true(over ? glass.calls < n : glass.calls == n);
            assert_true(over || status == PEL_ERROR_DEVICE);
            glass.fail_at = 0;
            if (n % 8 && !over)
                continue;
            glass.busy = 0;
            assert_int_equal(f.display.flush ? run(&f, &r) : PEL_OK, PEL_OK);
            if (f.display.flush)
                check_glass(&f);
        }
    }
}

/* A chip that stays busy is told, after a minute. */
TEST(busy_for_ever)
{
    static struct fixture f;
    struct random r = {1};
    glass.dma = false;
    assert_int_equal(set_up(&f, &modules[0], 0), PEL_OK);
    assert_int_equal(flush_any(&f, &r), PEL_OK);
    assert_int_equal(flip(&f), PEL_OK);
    glass.stuck = true;
    glass.ms = 0;
    assert_int_equal(flush_any(&f, &r), PEL_ERROR_DEVICE);
    assert_in_range(glass.ms, 60000, 61000);
    assert_int_equal(pel_epaper_sleep(&f.paper), PEL_ERROR_DEVICE);
    glass.stuck = false;
    assert_int_equal(set_up(&f, &modules[4], 0), PEL_OK);
    glass.stuck = true;
    assert_int_equal(set_up(&f, &modules[4], 0), PEL_ERROR_DEVICE);
    glass.stuck = false;
}

TEST(what_is_refused)
{
    static struct fixture f;
    struct pel_surface s;
    struct pel_display display;
    assert_int_equal(set_up(&f, &modules[1], 1), PEL_OK);
    struct pel_epaper paper = f.paper;
    paper.busy = NULL;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_NULL);
    paper = f.paper;
    paper.frame = NULL;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_NULL);
    paper = f.paper;
    paper.format = &pel_gray4;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_FORMAT);
    paper = f.paper;
    paper.width = 161;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_SIZE);
    paper.width = 0;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_SIZE);
    assert_int_equal(pel_epaper_init(NULL, &paper), PEL_ERROR_NULL);
    const int calls = glass.calls;
    paper = f.paper;
    paper.format = &pel_gray2; /* of a chip for inks, and the other way round */
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_FORMAT);
    paper.chip = &pel_epaper_ssd1680_gray2;
    paper.format = &pel_inks2;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_FORMAT);
    paper.format = &pel_mono1;
    assert_int_equal(pel_epaper_init(&display, &paper), PEL_ERROR_FORMAT);
    for (int how = PEL_EPAPER_FAST; how <= PEL_EPAPER_PARTIAL; how++) {
        f.paper.refresh = (uint8_t)how; /* of color */
        assert_int_equal(pel_display_flip(&f.display), PEL_ERROR_RANGE);
    }
    f.paper.refresh = 3;
    assert_int_equal(pel_display_flip(&f.display), PEL_ERROR_RANGE);
    s = surface_of(&pel_inks2, memory, sizeof memory, 300, 128);
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_SIZE);
    s.clip.x1 = 0;
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_OK);
    s = surface_of(&pel_mono1, memory, sizeof memory, 64, 64);
    assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_FORMAT);
    assert_int_equal(glass.calls, calls);
}
