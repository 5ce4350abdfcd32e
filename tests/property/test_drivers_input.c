/* Buttons and encoders that bounce at random, queues that overflow, and random
 * calibrations, against references that remember every state so far. */
#include "tests/support/cases.h"
#include "tests/support/check.h"

#include "drivers/input_button.h"
#include "drivers/input_encoder.h"
#include "drivers/touch.h"

enum { TIMES = 400 };

/* Told is what has held for `hold` ms, at the least, at the time told. */
TEST(buttons)
{
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_button button = {.hold = (uint16_t)random_between(r, 0, 20)};
        const int noise = random_between(r, 2, 30);
        const uint32_t start = random_word(r);
        uint32_t times[TIMES], now = start;
        bool levels[TIMES], told = false;
        for (int i = 0; i < TIMES; i++) {
            struct pel_input e;
            now += (uint32_t)random_between(r, 0, 4);
            times[i] = now;
            levels[i] = i && random_between(r, 0, noise) ? levels[i - 1]
                                                         : random_word(r) & 1;
            int first = i;
            while (first > 0 && levels[first - 1] == levels[i])
                first--;
            const bool changes =
                levels[i] != told && now - times[first] >= button.hold;
            if (pel_button_update(&button, levels[i], now, &e) != changes)
                fail_msg("time %d: %s", i, cases_replay());
            if (!changes)
                continue;
            told = !told;
            assert_int_equal(e.state, told);
            assert_int_equal(e.time, times[first]);
        }
    }
}

/* The contacts at a place, in quarters of a turn from a detent. */
static int contacts(int place)
{
    static const int order[4] = {0, 2, 3, 1};
    return order[place & 3];
}

/* The knob bounces between two neighbouring states, any number of times. Then,
 * with states that are missed: whatever that did to the count, once the knob
 * rests at a detent the next one is told, and told once. */
TEST(encoders)
{
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *r = &c.random;
        const int states = random_word(r) & 1 ? 4 : 2;
        struct pel_encoder knob = {.states = (uint8_t)states};
        int place = 0, turned = 0, direction = 1;
        for (int i = 0; i < 200; i++) {
            direction = random_between(r, 0, 6) ? direction : -direction;
            for (int bounce = random_between(r, 0, 4) * 2 + 1; bounce;
                 bounce--) {
                place += bounce & 1 ? direction : -direction;
                const int now = contacts(place);
                turned += pel_encoder_update(&knob, now >> 1, now & 1);
            }
            if (place % states == 0 && turned != place / states)
                fail_msg("place %d, turned %d: %s", place, turned,
                         cases_replay());
        }
        for (int i = 0; i < 40; i++) {
            const int now = random_word(r) & 3;
            pel_encoder_update(&knob, now >> 1, now & 1);
        }
        pel_encoder_update(&knob, false, false);
        turned = 0;
        for (int i = 1; i <= states; i++) {
            const int now = contacts(direction * i);
            turned += pel_encoder_update(&knob, now >> 1, now & 1);
        }
        assert_int_equal(turned, direction);
    }
}

/* Events come out in the order in which they went in. Where some were lost, and
 * nowhere else, an event says so. */
TEST(queues)
{
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_input places[20], e;
        struct pel_input_queue queue = {
            .events = places, .size = (uint16_t)random_between(r, 3, 20)};
        int in = 0, out = 0, held = 0;
        bool lost = false;
        for (int i = 0; i < 300; i++) {
            if (random_word(r) & 1) {
                e = (struct pel_input){.kind = PEL_INPUT_KEY,
                                       .code = (uint16_t)in++};
                const int room = pel_input_room(&queue);
                const bool fits = pel_input_push(&queue, &e);
                assert_int_equal(fits, room > 0);
                held += fits;
                assert_true(held <= queue.size - 2);
                continue;
            }
            if (!pel_input_pop(&queue, &e)) {
                assert_int_equal(held, 0);
                assert_true(lost || out == in);
                continue;
            }
            if (e.kind != PEL_INPUT_LOST) {
                assert_true(lost ? e.code >= out : e.code == out);
                out = e.code + 1;
                held--;
            }
            lost = e.kind == PEL_INPUT_LOST;
        }
    }
}

static struct pel_touch_point random_point(struct random *r, int most)
{
    return (struct pel_touch_point){(int16_t)random_between(r, 0, most),
                                    (int16_t)random_between(r, 0, most)};
}

/* The same map with floating-point numbers. */
static double exact(const struct pel_touch_pair p[3], const double s[3],
                    struct pel_touch_point at)
{
    const double ax = p[0].read.x - p[2].read.x, ay = p[0].read.y - p[2].read.y;
    const double bx = p[1].read.x - p[2].read.x, by = p[1].read.y - p[2].read.y;
    const double x = at.x - p[2].read.x, y = at.y - p[2].read.y;
    const double d = ax * by - ay * bx;
    return s[2] + (x * by - y * bx) / d * (s[0] - s[2]) +
           (y * ax - x * ay) / d * (s[1] - s[2]);
}

static void check_coordinate(int got, double want, int size)
{
    const double inside = want < 0 ? 0 : want < size - 1 ? want : size - 1;
    const double error = 0.5 + 2.0 * PEL_TOUCH_MOST / 65536;
    if (got < inside - error || got > inside + error)
        fail_msg("got %d, expected %f: %s", got, want, cases_replay());
}

TEST(calibrations)
{
    int good = 0;
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        struct random *r = &c.random;
        const int width = random_between(r, 1, PEL_TOUCH_MOST + 1);
        const int height = random_between(r, 1, PEL_TOUCH_MOST + 1);
        struct pel_touch_pair p[3];
        struct pel_touch_map map;
        for (int i = 0; i < 3; i++) {
            p[i].shown = random_point(r, (width < height ? width : height) - 1);
            p[i].read = random_point(r, PEL_TOUCH_MOST);
        }
        if (pel_touch_calibrate(&map, p, width, height) != PEL_OK)
            continue;
        good++;
        for (int i = 0; i < 20; i++) {
            const struct pel_touch_point at = random_point(r, PEL_TOUCH_MOST);
            const struct pel_touch_point got = pel_touch_map_point(&map, at);
            const double x[3] = {p[0].shown.x, p[1].shown.x, p[2].shown.x};
            const double y[3] = {p[0].shown.y, p[1].shown.y, p[2].shown.y};
            check_coordinate(got.x, exact(p, x, at), width);
            check_coordinate(got.y, exact(p, y, at), height);
        }
    }
    assert_true(cases_alone() || good > 0);
}
