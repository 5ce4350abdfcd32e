/* The cases of the fill rule, y down and y up, against the rule as
 * exact arithmetic states it; and the two against each other. */

#include "tests/support/check.h"

#include "sim/demo/rules.h"

/* Twice the signed area of (a, b, p), all in 1/4 px. */
static int side(const int *a, const int *b, const int *p)
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* Is the centre p inside the edge a -> b of a triangle that runs clockwise on
 * screen, y down? On the edge: inside when the edge is a top one (horizontal,
 * to the right) or a left one (upwards). For y up, `bottom` takes the bottom
 * edges in place of the top ones. */
static bool inside_edge(const int *a, const int *b, const int *p, bool bottom)
{
    const int s = side(a, b, p);
    if (s != 0)
        return s > 0;
    if (a[1] == b[1])
        return bottom ? b[0] < a[0] : b[0] > a[0];
    return b[1] < a[1];
}

/* `v` in the picture as seen, y down, in 1/4 px. */
static bool covers(int v[3][2], int x, int y, bool bottom)
{
    const int p[2] = {4 * x + 2, 4 * y + 2};
    const int area = side(v[0], v[1], v[2]);
    const int second = area > 0 ? 1 : 2, third = 3 - second;
    return area != 0 && inside_edge(v[0], v[second], p, bottom) &&
           inside_edge(v[second], v[third], p, bottom) &&
           inside_edge(v[third], v[0], p, bottom);
}

static int count_covers(const struct rules_case *rules, int x, int y, bool y_up)
{
    int n = 0;
    for (int i = 0; i < rules->count; i++) {
        const uint8_t *q = &rules->v[6 * i];
        int v[3][2];
        for (int k = 0; k < 3; k++) {
            v[k][0] = q[2 * k];
            v[k][1] = y_up ? 4 * RULES_HEIGHT - q[2 * k + 1] : q[2 * k + 1];
        }
        n += covers(v, x, y, y_up);
    }
    return n;
}

static void check_case(int number, bool y_up)
{
    const struct rules_case *rules = &rules_cases[number];
    struct rules_pixels pixels;
    rules_draw(rules, y_up, &pixels);
    for (int y = 0; y < RULES_HEIGHT; y++) {
        for (int x = 0; x < RULES_WIDTH; x++) {
            const int want = count_covers(rules, x, y, y_up);
            if (pixels.hits[y][x] != want || want > 1)
                fail_msg("case %d, y %s, (%d, %d): %d hits, not %d", number + 1,
                         y_up ? "up" : "down", x, y, pixels.hits[y][x], want);
        }
    }
}

/* Top-left with y down, bottom-left with y up, no pixel twice. */
TEST(rule)
{
    for (int i = 0; rules_cases[i].caption; i++) {
        if (rules_cases[i].line)
            continue;
        check_case(i, false);
        check_case(i, true);
    }
}

/* What is seen with y up is what is seen with y down, turned over. */
TEST(turned_over)
{
    for (int i = 0; rules_cases[i].caption; i++) {
        struct rules_pixels down, up;
        rules_draw(&rules_cases[i], false, &down);
        rules_draw(&rules_cases[i], true, &up);
        for (int y = 0; y < RULES_HEIGHT; y++) {
            const int opposite = RULES_HEIGHT - 1 - y;
            assert_memory_equal(down.hits[y], up.hits[opposite], RULES_WIDTH);
            assert_memory_equal(down.color[y], up.color[opposite],
                                sizeof down.color[y]);
        }
    }
}

/* The option draws lines where the default draws nothing. */
TEST(collinear)
{
    int lines = 0, covered = 0;
    for (int i = 0; rules_cases[i].caption; i++) {
        struct rules_pixels pixels;
        if (!rules_cases[i].line)
            continue;
        lines++;
        rules_draw(&rules_cases[i], false, &pixels);
        for (int y = 0; y < RULES_HEIGHT; y++)
            for (int x = 0; x < RULES_WIDTH; x++)
                covered += pixels.hits[y][x];
    }
    assert_int_equal(lines, 1);
    /* Bresenham: one pixel for every step along the longer side, ends included:
     * 11 + 7 + 7 + 8 + 4 inside the canvas. */
    assert_int_equal(covered, 37);
}
