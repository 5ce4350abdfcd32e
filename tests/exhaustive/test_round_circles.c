/* Discs, rings and circle outlines of every whole radius from 0 to 1024 px, and
 * next to it, around several centres (the large ones around a third of them);
 * discs of every sub-pixel radius up to 16 px around a lattice of them. Each
 * row against an integer square root found by search, the hit tests at its
 * ends. */
#include "core/outline/outline.h"
#include "tests/support/any_shape.h"
#include "tests/support/check.h"

enum { RADIUS_MAX = 1025, SIDE = 2 * RADIUS_MAX + 8, LEFT = -RADIUS_MAX - 4 };

/* A row is `disc` without `hole`. */
struct row {
    struct pel_span disc, hole;
    int32_t end, pixels; /* of what is painted so far */
};

static struct row rows[SIDE];
static struct pel_surface surface;

static struct row *row_at(int32_t y)
{
    return &rows[y - LEFT];
}

static int32_t width_of(struct pel_span s)
{
    return s.x0 < s.x1 ? s.x1 - s.x0 : 0;
}

static struct pel_span common(struct pel_span a, struct pel_span b)
{
    return (struct pel_span){pel_max(a.x0, b.x0), pel_min(a.x1, b.x1)};
}

/* Painted from left to right, within the row, once. */
static void take_rows(const struct pel_paint *paint,
                      const struct pel_spans *spans)
{
    (void)paint;
    for (int32_t i = 0; i < spans->n; i++) {
        const int32_t y = spans->y + i * spans->step;
        const struct pel_span run = spans->span[i];
        struct row *row = row_at(y);
        if (run.x0 >= run.x1)
            continue;
        if (run.x0 < row->end ||
            width_of(common(run, row->disc)) != width_of(run) ||
            width_of(common(run, row->hole)))
            fail_msg("%d..%d of row %d is painted", run.x0, run.x1, y);
        row->end = run.x1;
        row->pixels += width_of(run);
    }
}

static void setup(void)
{
    static uint8_t nothing;
    const struct pel_rect bounds = {LEFT, LEFT, LEFT + SIDE, LEFT + SIDE};
    assert_int_equal(
        pel_surface_init_rect(&surface, &pel_gray8, &nothing, SIDE, &bounds),
        PEL_OK);
}

/* The largest s with s^2 <= square; square < 2^40. */
static int64_t root_of(int64_t square)
{
    int64_t low = 0, high = 1 << 20; /* low^2 <= square < high^2 */
    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (middle * middle <= square)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static int64_t ceil_256(int64_t v)
{
    int64_t q = v / 256;
    return q + (v % 256 > 0);
}

/* Pixels whose centre lies within `reach` of the disc's centre line. */
static struct pel_span disc_row(struct pel_point center, int32_t radius,
                                int32_t y)
{
    const int64_t v = (int64_t)y * 256 + 128 - center.y;
    const int64_t square = (int64_t)radius * radius - v * v;
    if (square < 0)
        return (struct pel_span){0, 0};
    const int64_t reach = root_of(square);
    return (struct pel_span){
        (int32_t)ceil_256(center.x - reach - 128),
        (int32_t)-ceil_256(-(center.x + reach - 128)) + 1,
    };
}

/* Sets the rows of the disc, without a hole. */
static int32_t set_rows(struct pel_point center, int32_t radius)
{
    const int32_t reach = radius / 256 + 3;
    for (int32_t y = -reach; y <= reach; y++)
        *row_at(y) =
            (struct row){.disc = disc_row(center, radius, y), .end = LEFT};
    return reach;
}

static void check_rows(const struct any_shape *s, int32_t reach)
{
    for (int32_t y = -reach; y <= reach; y++) {
        const struct row *row = row_at(y);
        if (row->pixels !=
            width_of(row->disc) - width_of(common(row->disc, row->hole)))
            fail_msg("%s %d, %d, radii %d and %d: %d pixels of row %d",
                     any_name(s), s->v[0].x, s->v[0].y, s->radius, s->inner,
                     row->pixels, y);
    }
}

/* Left and right of every end. */
static void check_hits(const struct any_shape *s, int32_t reach)
{
    for (int32_t y = -reach; y <= reach; y++) {
        const struct pel_span disc = row_at(y)->disc, hole = row_at(y)->hole;
        const int32_t ends[] = {disc.x0, disc.x1, hole.x0, hole.x1};
        for (int i = 0; i < 8; i++) {
            const int32_t x = ends[i / 2] - i % 2;
            const bool in =
                x >= disc.x0 && x < disc.x1 && !(x >= hole.x0 && x < hole.x1);
            if (any_hit(s, x, y) != in)
                fail_msg("%s: hit test at %d, %d", any_name(s), x, y);
        }
    }
}

static const struct pel_paint paint = {.fill = take_rows};

static void check_disc(struct pel_point center, int32_t radius)
{
    const struct any_shape s = {
        .kind = ANY_CIRCLE, .v = {center}, .radius = radius};
    const int32_t reach = set_rows(center, radius);
    any_draw(&surface, &s, &paint);
    check_rows(&s, reach);
}

static void check_ring(struct pel_point center, int32_t radius, int32_t inner)
{
    const struct any_shape s = {
        .kind = ANY_RING, .v = {center}, .radius = radius, .inner = inner};
    const int32_t reach = set_rows(center, radius);
    for (int32_t y = -reach; y <= reach; y++)
        row_at(y)->hole = disc_row(center, inner, y);
    any_draw(&surface, &s, &paint);
    check_rows(&s, reach);
    check_hits(&s, reach);
}

/* A pixel of the disc is no outline where its four neighbours are of it. */
static void check_outline(struct pel_point center, int32_t radius)
{
    const struct any_shape s = {
        .kind = ANY_CIRCLE, .v = {center}, .radius = radius};
    const int32_t reach = set_rows(center, radius);
    check_hits(&s, reach);
    for (int32_t y = 1 - reach; y < reach; y++) {
        const struct pel_span disc = row_at(y)->disc;
        row_at(y)->hole =
            common(common(row_at(y - 1)->disc, row_at(y + 1)->disc),
                   (struct pel_span){disc.x0 + 1, disc.x1 - 1});
    }
    pel_circle_outline(&surface, center, radius, &paint);
    check_rows(&s, reach);
}

TEST(root)
{
    for (int64_t s = 0; s < 1 << 19; s += s / 64 + 1) {
        assert_true(root_of(s * s) == s);
        assert_true(root_of(s * s + 2 * s) == s);
    }
    assert_true(ceil_256(-256) == -1 && ceil_256(-255) == 0);
    assert_true(ceil_256(0) == 0 && ceil_256(1) == 1 && ceil_256(256) == 1);
}

/* Half a pixel more or less makes discs of whole diameters. */
TEST(whole_radii)
{
    static const struct pel_point centers[] = {
        {128, 128}, {0, 0},   {128, 0},  {0, 128},    {127, 128},
        {129, 127}, {1, 255}, {37, 201}, {-100, -129}};
    static const int32_t offsets[] = {0, 1, -1, 128, 77};
    struct random r = {1};
    for (int32_t k = 0; k <= 1024 * 5; k++)
        for (size_t i = 0; i < sizeof centers / sizeof *centers; i++) {
            const int32_t radius = pel_max(PEL_PX(k / 5) + offsets[k % 5], 0);
            check_disc(centers[i], radius);
            if (radius > PEL_PX(64) && ((size_t)k + i) % 3)
                continue;
            check_outline(centers[i], radius);
            check_ring(centers[i], radius, random_between(&r, 0, radius));
            check_ring(centers[i], radius, pel_max(radius - 256, 0));
        }
}

TEST(subpixel_radii)
{
    for (int32_t radius = 0; radius <= PEL_PX(16); radius++)
        for (int32_t y = 0; y < 256; y += 32)
            for (int32_t x = 0; x < 256; x += 32)
                check_disc((struct pel_point){x, y}, radius);
}

/* Every centre in a pixel, every radius up to a pixel and a half. */
TEST(all_small)
{
    for (int32_t radius = 0; radius <= 384; radius += 1 + radius / 32)
        for (int32_t y = 0; y < 256; y++)
            for (int32_t x = 0; x < 256; x++)
                check_disc((struct pel_point){x, y}, radius);
}

int main(void)
{
    setup();
    return run_all_tests();
}
