/* Every shape, random and adversarial, through clip windows anywhere: fill,
 * outline and hit test against 128-bit arithmetic, each pixel painted once. */
#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

enum { WINDOW = 20 };

static struct hits hits;

static bool fill_at(const void *s, int32_t x, int32_t y)
{
    bool covered = any_reference_at(s, x, y);
    if (covered != any_hit(s, x, y))
        fail_msg("%s: hit test of %d, %d: expected %d, got %d; %s", any_name(s),
                 x, y, covered, !covered, cases_replay());
    return covered;
}

static bool outline_at(const void *s, int32_t x, int32_t y)
{
    return any_reference_outline_at(s, x, y);
}

static void open_window(struct random *r, const struct any_shape *s)
{
    const struct pel_rect window = any_window(r, s, WINDOW);
    const struct pel_rect clip = shape_clip(r, &window);
    hits_open(&hits, &window);
    pel_surface_clip(&hits.surface, &clip);
}

static uint64_t check_fills(enum any_kind kind, bool adversarial)
{
    uint64_t covered = 0;
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct any_shape s;
        any_random(&c.random, &s, kind, adversarial);
        open_window(&c.random, &s);
        any_draw(&hits.surface, &s, &hits.paint);
        hits_check(&hits, fill_at, &s, any_name(&s));
        covered += hits.pixels;
    }
    return covered;
}

static uint64_t check_outlines(enum any_kind kind, bool adversarial)
{
    uint64_t covered = 0;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct any_shape s;
        any_random(&c.random, &s, kind, adversarial);
        open_window(&c.random, &s);
        any_draw_outline(&hits.surface, &s, &hits.paint);
        hits_check(&hits, outline_at, &s, any_name(&s));
        covered += hits.pixels;
    }
    return covered;
}

static void test_fills(void **state)
{
    (void)state;
    for (int kind = 0; kind < ANY_KINDS; kind++) {
        const struct any_shape s = {.kind = (enum any_kind)kind};
        uint64_t usual = check_fills(s.kind, false);
        uint64_t hard = check_fills(s.kind, true);
        assert_true(usual > 0 && hard > 0);
        print_message("%s: %llu + %llu pixels\n", any_name(&s),
                      (unsigned long long)usual, (unsigned long long)hard);
    }
}

static void test_outlines(void **state)
{
    (void)state;
    for (int kind = 0; kind < ANY_KINDS; kind++) {
        const struct any_shape s = {.kind = (enum any_kind)kind};
        uint64_t usual = check_outlines(s.kind, false);
        uint64_t hard = check_outlines(s.kind, true);
        assert_true(usual > 0 && hard > 0);
        print_message("%s: %llu + %llu pixels\n", any_name(&s),
                      (unsigned long long)usual, (unsigned long long)hard);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fills),
        cmocka_unit_test(test_outlines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
