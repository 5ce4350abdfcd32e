/* Wrong pixels in the regimes where methods fail: slivers, long edges, places
 * far from the origin, coarse sub-pixels. */
#include "cases.h"
#include "generate.h"
#include "sheet.h"

/* n slivers of a length and thickness. */
static struct tally judge_thin(struct atlas *a, const struct fill_method *m,
                               const struct thin *thin, int n)
{
    enum { MARGIN = 4 };
    const struct square p = {0, 0, thin->length + MARGIN};
    struct random r =
        atlas_random(a, (uint32_t)(thin->length * 65536 + thin->thickness));
    struct tally t = {0};
    struct pel_point v[3];
    struct sheet s;
    sheet_open(&s, a, (struct pel_rect){0, 0, p.edge, p.edge});
    for (; n > 0; n--) {
        thin_triangle(&r, &p, thin, v);
        sheet_judge(&s, m, v, &t);
    }
    sheet_close(&s);
    return t;
}

void atlas_thinness(struct atlas *a)
{
    for (const struct fill_method *const *m = fill_methods; *m; m++)
        for (int32_t thickness = 1; thickness <= PEL_PX(16); thickness *= 2) {
            const struct thin thin = {512, thickness};
            const struct tally t =
                judge_thin(a, *m, &thin, atlas_samples(a, 1500, 20));
            tally_put(
                a, *m, &t,
                (struct figure){.x = thickness / 256.0, .metric = "wrong_ppm"});
        }
}

void atlas_map_sliver(struct atlas *a)
{
    static const struct fill_method *const shown[] = {
        &fill_pel, &fill_fixed_rounded, &fill_float_scanline,
        &fill_float_stepped, &fill_barycentric};
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
        for (int32_t length = 8; length <= 1024; length *= 2)
            for (int32_t thickness = 1; thickness <= PEL_PX(4);
                 thickness *= 2) {
                const struct thin thin = {length, thickness};
                const int n = atlas_samples(a, 400000, 2000) / length;
                const struct tally t =
                    judge_thin(a, shown[i], &thin, n < 4 ? 4 : n);
                tally_put(a, shown[i], &t,
                          (struct figure){.x = thickness / 256.0,
                                          .y = length,
                                          .has_y = true,
                                          .metric = "wrong_ppm"});
            }
}

enum { WINDOW = 128 };

static int32_t window_at(int32_t v)
{
    return pel_max(-32768, pel_min(v - WINDOW / 2, 32767 - WINDOW));
}

/* Long edges, seen through a window on one of them. */
static void put_far(struct atlas *a, const struct fill_method *m, int32_t edge)
{
    struct random r = atlas_random(a, (uint32_t)edge);
    struct tally t = {0};
    struct pel_point v[3];
    struct sheet s;
    sheet_open(&s, a, (struct pel_rect){0, 0, WINDOW, WINDOW});
    for (int n = atlas_samples(a, 4000, 60); n > 0; n--) {
        const struct pel_point at = far_triangle(&r, edge, v);
        sheet_move(&s, window_at(at.x), window_at(at.y));
        sheet_judge(&s, m, v, &t);
    }
    tally_put(a, m, &t, (struct figure){.x = edge, .metric = "wrong_ppm"});
    sheet_close(&s);
}

/* Triangles of 64 px, so many px from the origin. */
static void put_offset(struct atlas *a, const struct fill_method *m,
                       int32_t offset)
{
    const struct square p = {offset, offset, 64};
    struct random r = atlas_random(a, (uint32_t)offset);
    struct tally t = {0};
    struct pel_point v[3];
    struct sheet s;
    sheet_open(&s, a,
               (struct pel_rect){offset, offset, offset + 64, offset + 64});
    for (int n = atlas_samples(a, 20000, 500); n > 0; n--) {
        any_triangle(&r, &p, v);
        sheet_judge(&s, m, v, &t);
    }
    tally_put(a, m, &t,
              (struct figure){.x = offset, .metric = "wrong_ppm_offset"});
    sheet_close(&s);
}

void atlas_overflow(struct atlas *a)
{
    static const int32_t offsets[] = {0, 1000, 4000, 16000, 32000};
    for (const struct fill_method *const *m = fill_methods; *m; m++) {
        for (int32_t edge = 64; edge <= 65536; edge *= 2)
            put_far(a, *m, edge < 65536 ? edge : 65535);
        for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++)
            put_offset(a, *m, offsets[i]);
    }
}

static double length_of(struct pel_span s)
{
    return s.x1 > s.x0 ? s.x1 - s.x0 : 0;
}

/* Pixels that only one of two spans holds. */
static double different(struct pel_span a, struct pel_span b)
{
    const struct pel_span both = {pel_max(a.x0, b.x0), pel_min(a.x1, b.x1)};
    return length_of(a) + length_of(b) - 2 * length_of(both);
}

/* Vertices in 2^-16 px, rounded to 2^-bits px, against themselves. */
static void put_snapped(struct atlas *a, int32_t edge, int bits)
{
    static const char *const names[] = {"S=0", "S=2",  "S=4", "S=6",
                                        "S=8", "S=10", "S=12"};
    struct random r = atlas_random(a, (uint32_t)edge);
    const int32_t unit = 1 << (16 - bits);
    double wrong = 0, covered = 0;
    for (int n = atlas_samples(a, 10000000, 300000) / edge; n > 0; n--) {
        struct pel_point v[3], snapped[3];
        for (int i = 0; i < 3; i++) {
            v[i].x = random_between(&r, 0, edge * 65536 - 1);
            v[i].y = random_between(&r, 0, edge * 65536 - 1);
            snapped[i].x = (v[i].x + unit / 2) / unit * unit;
            snapped[i].y = (v[i].y + unit / 2) / unit * unit;
        }
        for (int32_t y = 0; y < edge; y++) {
            const struct pel_span exact = exact_row(v, y, 16);
            wrong += different(exact, exact_row(snapped, y, 16));
            covered += length_of(exact);
        }
    }
    struct figure f = figure_of(names[bits / 2], edge, "wrong_ppm",
                                1e6 * wrong / covered, "ppm");
    f.y = bits;
    f.has_y = true;
    atlas_put(a, f);
    f.method = "law";
    f.value = 4.0e6 / (1 << bits) / edge;
    atlas_put(a, f);
}

void atlas_snapping(struct atlas *a)
{
    for (int bits = 0; bits <= 12; bits += 2)
        for (int32_t edge = 4; edge <= 1024; edge *= 4)
            put_snapped(a, edge, bits);
}
