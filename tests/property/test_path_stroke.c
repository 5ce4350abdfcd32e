/* Strokes against the area of their outline. */
#include <math.h>
#include <string.h>

#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_area.h"

enum { SIZE = STROKE_AREA_SIZE, POINTS = 8, SCANLINES = 256 };

static uint8_t pixels[SIZE * SIZE];
static struct pel_surface window;
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
static uint64_t scratch[1 << 16];
static double area[SIZE][SIZE];

static void open_window(const struct pel_rect *bounds)
{
    memset(pixels, 0, sizeof pixels);
    assert_int_equal(
        pel_surface_init(&window, &pel_gray8, pixels, sizeof pixels, bounds),
        PEL_OK);
}

/* How long parts are: as long as the window, a few pixels, short, tiny. */
static struct pel_polyline_shape random_line(struct random *r,
                                             struct pel_point *v)
{
    static const int32_t reaches[4] = {6000, 1500, 300, 20};
    const int32_t reach = reaches[random_word(r) % 4];
    const struct pel_polyline_shape line = {
        v,
        random_between(r, 1, POINTS),
        random_word(r) % 4 == 0,
        {.width = random_between(r, 1, 1 << random_between(r, 4, 12)),
         .cap = (enum pel_cap)(random_word(r) % 3),
         .join = (enum pel_join)(random_word(r) % 3),
         .miter_limit = random_word(r) % 2 ? 0 : random_between(r, 256, 4096)}};
    v[0] = (struct pel_point){random_between(r, 512, 5632),
                              random_between(r, 512, 5632)};
    for (int i = 1; i < line.n; i++) {
        v[i].x = v[i - 1].x + random_between(r, -reach, reach);
        v[i].y = v[i - 1].y + random_between(r, -reach, reach);
        if (random_word(r) % 8 == 0)
            v[i] = v[i - 1]; /* doubled */
        else if (i > 1 && random_word(r) % 8 == 0)
            v[i] = v[i - 2]; /* straight back */
        else if (random_word(r) % 8 == 0)
            v[i].y = v[i - 1].y;
    }
    shape_keep(v, line.n);
    cases_keep(stroke_print, &line, sizeof line);
    return line;
}

/* Within .5, .02 for each piece of the border in the pixel, and what corners
 * that are rounded to 1/256 px and circles of 1/128 px leave: of 10^5 lines 259
 * of 57.6 million pixels are 2 to 4 off. */
TEST(smooth_strokes_are_their_area)
{
    enum { MOST = 4 };
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        struct pel_point v[POINTS];
        const struct pel_polyline_shape line = random_line(&c.random, v);
        open_window(&bounds);
        assert_int_equal(pel_smooth_polyline(&window, &line, &white.paint,
                                             scratch, sizeof scratch),
                         PEL_OK);
        if (!stroke_area(&line, 0, 0, SCANLINES, area))
            continue;
        for (int y = 0; y < SIZE; y++)
            for (int x = 0; x < SIZE; x++) {
                const double off = pixels[y * SIZE + x] - 255 * area[y][x];
                if (off < -MOST || off > MOST)
                    fail_msg("(%d, %d): %d, not %.2f: %s", x, y,
                             pixels[y * SIZE + x], 255 * area[y][x],
                             cases_replay());
            }
    }
}

/* Each pixel once, and those that the hit test says; what is covered as a whole
 * is filled, what is not covered is not. */
TEST(strokes_cover_pixels_once)
{
    static struct hits hits;
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct pel_point v[POINTS];
        const struct pel_polyline_shape line = random_line(&c.random, v);
        hits_open(&hits, &bounds);
        assert_int_equal(pel_polyline(&hits.surface, &line, &hits.paint,
                                      scratch, sizeof scratch),
                         PEL_OK);
        const bool sure = stroke_area(&line, 0, 0, 16, area) &&
                          line.stroke.width >= 64; /* scanlines meet it */
        for (int y = 0; y < SIZE; y++)
            for (int x = 0; x < SIZE; x++) {
                const int hit = hits_at(&hits, x, y);
                if (hit != pel_hit_polyline(&line, x, y) ||
                    (sure && (hit ? area[y][x] < .001 : area[y][x] > .999)))
                    fail_msg("(%d, %d): %d, area %.3f: %s", x, y, hit,
                             area[y][x], cases_replay());
            }
    }
}

/* A disc that a pixel's centre is surely in, or not: by how far its border may
 * be from the circle, and what rounding to 1/256 px adds. */
TEST(dots_are_discs)
{
    for (struct cases c = cases_of(200000); cases_next(&c);) {
        struct random *const r = &c.random;
        const int32_t half =
            random_between(r, 2, 1 << random_between(r, 4, 21));
        const double off = 256 / 96. + half / 8192. + 2;
        const double turn = random_between(r, 0, 1 << 24) * 3.7450703e-7;
        const double far = half + (random_word(r) % 2 ? off : -off);
        const struct pel_point v = {(int32_t)lround(128 + far * cos(turn)),
                                    (int32_t)lround(128 + far * sin(turn))};
        const struct pel_polyline_shape dot = {
            .v = &v,
            .n = 1,
            .stroke = {.width = 2 * half, .cap = PEL_CAP_ROUND}};
        if (far > 0 && pel_hit_polyline(&dot, 0, 0) != (far < half))
            fail_msg("radius %d, (%d, %d): %s", half, v.x, v.y, cases_replay());
    }
}

/* A polyline as a path of lines, now and then of curves. */
struct line_path {
    uint8_t verbs[POINTS + 2];
    struct pel_path path;
    struct pel_path_shape shape;
};

static void path_of(const struct pel_polyline_shape *line, bool curves,
                    struct line_path *p)
{
    int32_t n = 0, points = 0;
    while (points < line->n) {
        const int32_t left = line->n - points;
        const int32_t take = !curves || points == 0 ? 1 : pel_min(left, 3);
        p->verbs[n++] = points == 0 ? PEL_MOVE : (uint8_t)take;
        points += take;
    }
    if (line->closed || line->n == 1)
        p->verbs[n++] = PEL_CLOSE;
    p->path = (struct pel_path){.verbs = p->verbs,
                                .points32 = &line->v->x,
                                .verb_count = n,
                                .point_count = points};
    p->shape =
        (struct pel_path_shape){.path = &p->path, .stroke = line->stroke};
}

static struct canvas whole, other;
static const struct pel_flat ink = PEL_FLAT(PEL_RGBA(200, 40, 90, 120));

/* Kinds: polyline, path of lines, path with curves; each smooth or not. */
static enum pel_status draw(const struct pel_surface *surface, uint32_t kind,
                            const struct pel_polyline_shape *line, size_t size)
{
    const bool smooth = kind % 2;
    struct line_path p;
    if (kind < 2)
        return (smooth ? pel_smooth_polyline : pel_polyline)(
            surface, line, &ink.paint, scratch, size);
    path_of(line, kind >= 4, &p);
    return (smooth ? pel_smooth_path_stroke : pel_path_stroke)(
        surface, &p.shape, &ink.paint, scratch, size);
}

TEST(polylines_are_paths_of_lines)
{
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct pel_point v[POINTS];
        const uint32_t smooth = random_word(&c.random) % 2;
        const struct pel_polyline_shape line = random_line(&c.random, v);
        canvas_open(&whole, &pel_rgb888, &bounds, 0);
        canvas_open(&other, &pel_rgb888, &bounds, 0);
        assert_int_equal(draw(&whole.surface, smooth, &line, sizeof scratch),
                         PEL_OK);
        assert_int_equal(
            draw(&other.surface, smooth + 2, &line, sizeof scratch), PEL_OK);
        canvas_check_same(&whole, &other);
    }
}

/* With dashes, too, and as little memory as one row needs. */
TEST(tiles_and_memory_change_nothing)
{
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[POINTS];
        struct pel_polyline_shape line = random_line(r, v);
        const int32_t dash[3] = {random_between(r, 0, 900), 300,
                                 random_between(r, 0, 900)};
        const int32_t count = random_between(r, 0, 3);
        const struct pel_dashes dashes = {&pel_dashed, dash, count,
                                          random_between(r, 0, 3000)};
        if (count > 1 || (count == 1 && dash[0] >= 128))
            line.stroke.dashes = &dashes;
        const uint32_t kind = random_word(r) % 6;
        const struct layout *const l = &layouts[random_word(r) % LAYOUT_COUNT];
        canvas_open(&whole, l->format, &bounds, 0);
        assert_int_equal(draw(&whole.surface, kind, &line, sizeof scratch),
                         PEL_OK);
        canvas_check(&whole);
        struct pel_rect t = {0, 0, 0, 0};
        for (t.y0 = 0; t.y0 < SIZE; t.y0 = t.y1) {
            const bool cut = l->bits < 8 || random_word(r) % 2;
            t.y1 = cut ? pel_min((t.y0 + 8), SIZE)
                       : random_between(r, t.y0 + 1, SIZE);
            for (t.x0 = 0; t.x0 < SIZE; t.x0 = t.x1) {
                t.x1 = random_between(r, t.x0 / 8 + 1, SIZE / 8) * 8;
                canvas_open(&other, l->format, &t, random_word(r) % 8);
                size_t size = (size_t)random_between(r, 1, 99) * 52;
                while (draw(&other.surface, kind, &line, size) != PEL_OK) {
                    size *= 2;
                    canvas_open(&other, l->format, &t, random_word(r) % 8);
                }
                canvas_check_part(&whole, &other);
            }
        }
    }
}
