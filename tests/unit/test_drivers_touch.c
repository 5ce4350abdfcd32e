/* Touch screens: what the controllers say, byte by byte, the map to pixels, and
 * a finger's way from its touch to its lift. */
#include "tests/support/check.h"

#include <string.h>

#include "drivers/touch.h"

/* A controller: the answers of an XPT2046 by its control byte, or the registers
 * of an FT6206; and when it fails. */
struct chip {
    int x, y, z1, z2;      /* 12 bits */
    const uint8_t *points; /* 13 registers from 0x02; NULL: an XPT2046 */
    int line;              /* -1; or all that is read, as of a broken wire */
    int fails_at;          /* the call that times out, from 1; 0: none */
    int calls;
};

static enum pel_status command(const struct pel_bus *bus, const uint8_t *bytes,
                               size_t n, uint8_t *answer, size_t answers)
{
    struct chip *chip = bus->context;
    assert_int_equal(n, 1);
    if (++chip->calls == chip->fails_at)
        return PEL_ERROR_DEVICE;
    if (chip->line >= 0) {
        memset(answer, chip->line, answers);
    } else if (chip->points) {
        assert_int_equal(bytes[0], 0x02);
        assert_int_equal(answers, 13);
        memcpy(answer, chip->points, answers);
    } else {
        const int value = bytes[0] == 0x90   ? chip->y
                          : bytes[0] == 0xB0 ? chip->z1
                          : bytes[0] == 0xC0 ? chip->z2
                                             : chip->x;
        assert_non_null(memchr("\x90\xB0\xC0\xD0", bytes[0], 4));
        assert_int_equal(answers, 2);
        answer[0] = (uint8_t)(value >> 5);
        answer[1] = (uint8_t)(value << 3);
    }
    return PEL_OK;
}

/* 320 x 240: raw (200, 300) is its pixel (20, 20), x and y change places, and y
 * is upside down. */
static const struct pel_touch_pair turned[3] = {{{20, 20}, {3700, 300}},
                                                {{300, 20}, {3700, 3800}},
                                                {{160, 220}, {200, 2050}}};

struct fixture {
    struct chip chip;
    struct pel_bus bus;
    struct pel_touch touch;
    struct pel_input places[12];
    struct pel_input_queue queue;
};

static void set_up(struct fixture *f, pel_touch_read *read)
{
    memset(f, 0, sizeof(*f));
    f->chip.line = -1;
    f->bus = (struct pel_bus){.context = &f->chip, .command = command};
    f->touch = (struct pel_touch){.bus = &f->bus, .read = read};
    f->queue = (struct pel_input_queue)PEL_INPUT_QUEUE(f->places);
    assert_int_equal(pel_touch_calibrate(&f->touch.map, turned, 320, 240),
                     PEL_OK);
}

/* The next event is this one; a finger of -1: there is none. */
static void expect(struct fixture *f, int finger, int state, int x, int y)
{
    struct pel_input e;
    if (!pel_input_pop(&f->queue, &e)) {
        assert_int_equal(finger, -1);
        return;
    }
    assert_int_equal(e.kind, PEL_INPUT_TOUCH);
    assert_int_equal(e.code, finger);
    assert_int_equal(e.state, state);
    assert_int_equal(e.x, x);
    assert_int_equal(e.y, y);
}

TEST(calibration)
{
    struct pel_touch_map map = {.width = 7};
    static const struct {
        struct pel_touch_pair pairs[3];
        int status;
    } rows[] = {
        {{{{0, 0}, {0, 0}}, {{99, 0}, {100, 100}}, {{0, 99}, {200, 200}}},
         PEL_ERROR_RANGE}, /* in a line */
        {{{{0, 0}, {5, 5}}, {{9, 9}, {5, 5}}, {{0, 9}, {80, 80}}},
         PEL_ERROR_RANGE}, /* two the same */
        {{{{0, 0}, {0, 0}}, {{200, 0}, {100, 0}}, {{0, 99}, {0, 100}}},
         PEL_ERROR_RANGE}, /* 2 px a unit */
        {{{{0, 0}, {0, 0}}, {{99, 0}, {4096, 0}}, {{0, 99}, {0, 100}}},
         PEL_ERROR_RANGE},
        {{{{0, 0}, {0, 0}}, {{99, -1}, {100, 0}}, {{0, 99}, {0, 100}}},
         PEL_ERROR_RANGE},
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        assert_int_equal(pel_touch_calibrate(&map, rows[i].pairs, 320, 240),
                         rows[i].status);
        assert_int_equal(map.width, 7);
    }
    assert_int_equal(pel_touch_calibrate(&map, turned, 0, 240), PEL_ERROR_SIZE);
    assert_int_equal(pel_touch_calibrate(&map, turned, 320, 4097),
                     PEL_ERROR_SIZE);
    assert_int_equal(pel_touch_calibrate(&map, turned, 320, 240), PEL_OK);
    for (int i = 0; i < 3; i++) {
        const struct pel_touch_point p =
            pel_touch_map_point(&map, turned[i].read);
        assert_int_equal(p.x, turned[i].shown.x);
        assert_int_equal(p.y, turned[i].shown.y);
    }
}

TEST(xpt2046)
{
    struct fixture f;
    set_up(&f, pel_touch_xpt2046_read);
    f.chip.z2 = 4095;
    assert_int_equal(pel_touch_poll(&f.touch, 1, &f.queue), PEL_OK);
    expect(&f, -1, 0, 0, 0);
    f.chip.z1 = 700, f.chip.z2 = 2500, f.chip.x = 3700, f.chip.y = 3800;
    for (int i = 0; i < 3; i++) /* one that rests is told once */
        assert_int_equal(pel_touch_poll(&f.touch, 2, &f.queue), PEL_OK);
    expect(&f, 0, PEL_INPUT_DOWN, 300, 20);
    f.chip.x = 0, f.chip.y = 0; /* beyond the border */
    assert_int_equal(pel_touch_poll(&f.touch, 3, &f.queue), PEL_OK);
    expect(&f, 0, PEL_INPUT_AGAIN, 0, 231);
    f.chip.z1 = 0, f.chip.z2 = 3800; /* not firm enough */
    assert_int_equal(pel_touch_poll(&f.touch, 4, &f.queue), PEL_OK);
    expect(&f, 0, PEL_INPUT_UP, 0, 231);
    expect(&f, -1, 0, 0, 0);
}

TEST(ft6206)
{
    static const uint8_t both[13] = {0x02, 0x80, 100,  0x10, 200, 0,
                                     0,    0x8E, 0x74, 0x0E, 0xD8},
                         one[13] = {0x01, 0x8E, 0x74, 0x0E, 0xD8},
                         nobody[13] = {0xFF}, third[13] = {0x01, 0, 0, 0x20};
    struct fixture f;
    set_up(&f, pel_touch_ft6206_read);
    f.touch.map = (struct pel_touch_map){
        .x_by_x = 65536, .y_by_y = 65536, .width = 4000, .height = 4000};
    f.chip.points = nobody;
    assert_int_equal(pel_touch_poll(&f.touch, 1, &f.queue), PEL_OK);
    f.chip.points = both;
    assert_int_equal(pel_touch_poll(&f.touch, 2, &f.queue), PEL_OK);
    expect(&f, 0, PEL_INPUT_DOWN, 0xE74, 0xED8);
    expect(&f, 1, PEL_INPUT_DOWN, 100, 200);
    f.chip.points = one;
    assert_int_equal(pel_touch_poll(&f.touch, 3, &f.queue), PEL_OK);
    expect(&f, 1, PEL_INPUT_UP, 100, 200);
    f.chip.points = third;
    assert_int_equal(pel_touch_poll(&f.touch, 4, &f.queue), PEL_OK);
    expect(&f, 0, PEL_INPUT_UP, 0xE74, 0xED8);
    expect(&f, -1, 0, 0, 0);
}

/* Whichever call times out, the finger is lifted and the next poll is like the
 * first; so it is with wires that are broken. */
TEST(chips_that_do_not_answer)
{
    struct fixture f;
    static const uint8_t one[13] = {0x01, 0, 10, 0, 10};
    for (int fault = 0; fault < 11; fault++) {
        const bool is_i2c = fault == 10;
        set_up(&f, is_i2c ? pel_touch_ft6206_read : pel_touch_xpt2046_read);
        f.chip.z1 = 700, f.chip.z2 = 2500;
        f.chip.points = is_i2c ? one : NULL;
        assert_int_equal(pel_touch_poll(&f.touch, 1, &f.queue), PEL_OK);
        const int calls = f.chip.calls, x = f.touch.last[0].x,
                  y = f.touch.last[0].y;
        expect(&f, 0, PEL_INPUT_DOWN, x, y);
        assert_int_equal(calls, is_i2c ? 1 : 8);
        if (fault < 8 || is_i2c)
            f.chip.fails_at = calls + 1 + fault % 10;
        else
            f.chip.line = fault == 8 ? 0xFF : 0;
        assert_int_equal(pel_touch_poll(&f.touch, 2, &f.queue),
                         PEL_ERROR_DEVICE);
        expect(&f, 0, PEL_INPUT_UP, x, y);
        f.chip.line = -1;
        assert_int_equal(pel_touch_poll(&f.touch, 3, &f.queue), PEL_OK);
        expect(&f, 0, PEL_INPUT_DOWN, x, y);
        expect(&f, -1, 0, 0, 0);
    }
}

/* The queue is full, then read: fingers that are held are told again, also
 * those of which no event was lost. */
TEST(what_is_held_after_a_loss)
{
    static const uint8_t one[13] = {0x01, 0, 10, 0, 10};
    const struct pel_input key = {.kind = PEL_INPUT_KEY};
    for (int before = 0; before < 2; before++) { /* held before the loss */
        struct fixture f;
        struct pel_input e = {.kind = PEL_INPUT_KEY};
        set_up(&f, pel_touch_ft6206_read);
        f.chip.points = one;
        for (int i = 0; i < before; i++) {
            pel_touch_poll(&f.touch, 1, &f.queue);
            pel_input_pop(&f.queue, &e);
        }
        while (pel_input_room(&f.queue))
            pel_input_push(&f.queue, &key);
        if (before)
            assert_false(pel_input_push(&f.queue, &key));
        for (uint32_t time = 2; time < 4; time++)
            assert_int_equal(pel_touch_poll(&f.touch, time, &f.queue), PEL_OK);
        do
            assert_true(pel_input_pop(&f.queue, &e));
        while (e.kind != PEL_INPUT_LOST);
        assert_int_equal(pel_touch_poll(&f.touch, 4, &f.queue), PEL_OK);
        expect(&f, 0, PEL_INPUT_DOWN, f.touch.last[0].x, f.touch.last[0].y);
        assert_int_equal(pel_touch_poll(&f.touch, 5, &f.queue), PEL_OK);
        expect(&f, -1, 0, 0, 0);
    }
}
