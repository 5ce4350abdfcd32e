/* Rings, sectors and arcs tile a disc: every pixel is hit once. */
#include <stdlib.h>

#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

enum { WINDOW = 32, PARTS = 6 };

static struct hits hits;

static bool disc_at(const void *s, int32_t x, int32_t y)
{
    const struct any_shape *disc = s;
    return reference_disc_at(disc->v[0], disc->radius, x, y);
}

static int compare(const void *a, const void *b)
{
    int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

/* Ascending, from 0 to `last`. */
static void random_cuts(struct random *r, int32_t cut[PARTS + 1], int32_t last)
{
    for (int i = 1; i < PARTS; i++)
        cut[i] = random_between(r, 0, last);
    cut[0] = 0;
    cut[PARTS] = last;
    qsort(cut, PARTS + 1, sizeof *cut, compare);
}

static struct any_shape open_disc(struct random *r)
{
    struct any_shape disc;
    any_random(r, &disc, ANY_CIRCLE, random_word(r) & 1);
    const struct pel_rect window = any_window(r, &disc, WINDOW);
    hits_open(&hits, &window);
    return disc;
}

static void test_rings(void)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        const struct any_shape disc = open_disc(&c.random);
        int32_t cut[PARTS + 1];
        random_cuts(&c.random, cut, disc.radius);
        pel_circle(&hits.surface, disc.v[0], cut[0], &hits.paint);
        for (int i = 0; i < PARTS; i++) {
            const struct pel_ring_shape ring = {disc.v[0], cut[i], cut[i + 1]};
            pel_ring(&hits.surface, &ring, &hits.paint);
        }
        hits_check(&hits, disc_at, &disc, "rings");
    }
}

/* Angles that go once around; equal ones make empty parts. */
static void random_angles(struct random *r, uint16_t angle[PARTS + 1])
{
    int32_t cut[PARTS + 1];
    uint32_t start = random_word(r);
    random_cuts(r, cut, 65535);
    cut[PARTS] = 65536;
    if (random_word(r) & 1) {
        start &= 0xE000u;
        for (int i = 0; i <= PARTS; i++)
            cut[i] &= ~0x1FFF;
        cut[1] = 8192;
        qsort(cut, PARTS + 1, sizeof *cut, compare);
    }
    for (int i = 0; i <= PARTS; i++)
        angle[i] = (uint16_t)(start + (uint32_t)cut[i]);
}

static void test_sectors(void)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        const struct any_shape disc = open_disc(&c.random);
        const uint16_t a = (uint16_t)random_word(&c.random);
        const uint16_t b = (uint16_t)random_word(&c.random);
        const struct pel_sector_shape one = {disc.v[0], disc.radius, a, b};
        const struct pel_sector_shape rest = {disc.v[0], disc.radius, b, a};
        if (a == b)
            continue;
        pel_sector(&hits.surface, &one, &hits.paint);
        pel_sector(&hits.surface, &rest, &hits.paint);
        hits_check(&hits, disc_at, &disc, "sectors");
    }
}

static void test_arcs(void)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct any_shape disc = open_disc(&c.random);
        uint16_t angle[PARTS + 1];
        int32_t inner = random_between(&c.random, 0, disc.radius);
        random_angles(&c.random, angle);
        for (int i = 0; i < PARTS; i++) {
            const struct pel_arc_shape arc = {disc.v[0], inner, disc.radius,
                                              angle[i], angle[i + 1]};
            const struct pel_sector_shape sector = {disc.v[0], inner, angle[i],
                                                    angle[i + 1]};
            pel_arc(&hits.surface, &arc, &hits.paint);
            pel_sector(&hits.surface, &sector, &hits.paint);
        }
        hits_check(&hits, disc_at, &disc, "arcs");
    }
}

int main(void)
{
    return RUN_TESTS(test_rings, test_sectors, test_arcs);
}
