/* Triangles at the limits of the range: right up to it, and nothing drawn one
 * sub-pixel past it. */
#include "cases.h"
#include "generate.h"
#include "sheet.h"

enum { WINDOW = 96 };

/* Corners of the range, and the sub-pixels next to them. */
static void limit_triangle(struct random *r, int32_t past,
                           struct pel_point v[3])
{
    for (int i = 0; i < 3; i++) {
        const int32_t x = random_between(r, 0, 2), y = random_between(r, 0, 2);
        v[i].x = random_between(r, 0, 1) ? PEL_COORDINATE_MIN + x
                                         : PEL_COORDINATE_MAX - x;
        v[i].y = random_between(r, 0, 1) ? PEL_COORDINATE_MIN + y
                                         : PEL_COORDINATE_MAX - y;
    }
    int32_t *const one = random_between(r, 0, 1) ? &v[0].x : &v[0].y;
    if (past)
        *one = *one < 0 ? PEL_COORDINATE_MIN - past : PEL_COORDINATE_MAX + past;
}

/* A window in the middle, or at a corner. */
static void move_window(struct random *r, struct sheet *s)
{
    static const int32_t at[] = {-32768, -WINDOW / 2, 32768 - WINDOW};
    sheet_move(s, at[random_between(r, 0, 2)], at[random_between(r, 0, 2)]);
}

static bool is_empty(const struct sheet *s)
{
    for (int i = 0; i < WINDOW * WINDOW; i++)
        if (s->pixels[i])
            return false;
    return true;
}

static void put_inside(struct atlas *a, struct sheet *s)
{
    struct random r = atlas_random(a, 0);
    struct tally t = {0};
    struct pel_point v[3];
    for (int n = atlas_samples(a, 100000, 3000); n > 0; n--) {
        limit_triangle(&r, 0, v);
        move_window(&r, s);
        sheet_judge(s, &fill_pel, v, &t);
    }
    tally_put(a, &fill_pel, &t, (struct figure){.metric = "wrong_ppm"});
}

static void put_past(struct atlas *a, struct sheet *s, int32_t past)
{
    struct random r = atlas_random(a, (uint32_t)past);
    struct pel_point v[3];
    double drawn = 0;
    for (int n = atlas_samples(a, 100000, 3000); n > 0; n--) {
        limit_triangle(&r, past, v);
        move_window(&r, s);
        fill_pel.draw(&s->surface, v, UINT32_MAX);
        drawn += !is_empty(s);
    }
    const struct figure f = figure_of("pel", past, "drawn", drawn, "triangles");
    atlas_put(a, f);
    atlas_promise(a, drawn == 0, &f);
}

void atlas_limits(struct atlas *a)
{
    struct sheet s;
    sheet_open(&s, a, (struct pel_rect){0, 0, WINDOW, WINDOW});
    put_inside(a, &s);
    for (int32_t past = 1; past <= 1 << 22; past *= 256)
        put_past(a, &s, past);
    sheet_close(&s);
}
