#include "touch.h"

static bool in_range(struct pel_touch_point p)
{
    return p.x >= 0 && p.x <= PEL_TOUCH_MOST && p.y >= 0 &&
           p.y <= PEL_TOUCH_MOST;
}

/* The point as seen from an origin: within +-4095. */
static struct pel_touch_point from(struct pel_touch_point origin,
                                   struct pel_touch_point p)
{
    return (struct pel_touch_point){(int16_t)(p.x - origin.x),
                                    (int16_t)(p.y - origin.y)};
}

/* a d - b c of four numbers within +-4095: below 2^25. */
static int32_t determinant(int a, int b, int c, int d)
{
    return (int32_t)a * d - (int32_t)b * c;
}

/* n / d in 1/65536, rounded down in size; |n|, |d| < 2^25. False when that is 2
 * or more. */
static bool ratio(int32_t n, int32_t d, int32_t *result)
{
    const bool negative = (n < 0) != (d < 0);
    uint32_t rest = n < 0 ? 0 - (uint32_t)n : (uint32_t)n;
    const uint32_t divisor = d < 0 ? 0 - (uint32_t)d : (uint32_t)d;
    int32_t quotient = 0;
    if (rest >> 1 >= divisor)
        return false;
    for (int32_t bit = 65536; bit > 0; bit >>= 1, rest <<= 1)
        if (rest >= divisor) {
            rest -= divisor;
            quotient |= bit;
        }
    *result = negative ? -quotient : quotient;
    return true;
}

/* With the third point as the origin of both sides, the map is linear: two
 * equations each for x and y, by Cramer's rule. */
enum pel_status pel_touch_calibrate(struct pel_touch_map *map,
                                    const struct pel_touch_pair pairs[3],
                                    int width, int height)
{
    struct pel_touch_map m = {.from = pairs[2].read,
                              .to = pairs[2].shown,
                              .width = (int16_t)width,
                              .height = (int16_t)height};
    struct pel_touch_point r[2], s[2];
    if (width < 1 || width > PEL_TOUCH_MOST + 1 || height < 1 ||
        height > PEL_TOUCH_MOST + 1)
        return PEL_ERROR_SIZE;
    for (int i = 0; i < 3; i++)
        if (!in_range(pairs[i].read) || !in_range(pairs[i].shown))
            return PEL_ERROR_RANGE;
    for (int i = 0; i < 2; i++) {
        r[i] = from(m.from, pairs[i].read);
        s[i] = from(m.to, pairs[i].shown);
    }
    const int32_t d = determinant(r[0].x, r[0].y, r[1].x, r[1].y);
    if (!ratio(determinant(s[0].x, r[0].y, s[1].x, r[1].y), d, &m.x_by_x) ||
        !ratio(determinant(r[0].x, s[0].x, r[1].x, s[1].x), d, &m.x_by_y) ||
        !ratio(determinant(s[0].y, r[0].y, s[1].y, r[1].y), d, &m.y_by_x) ||
        !ratio(determinant(r[0].x, s[0].y, r[1].x, s[1].y), d, &m.y_by_y))
        return PEL_ERROR_RANGE;
    *map = m;
    return PEL_OK;
}

/* |by| < 2^17 and |at| < 2^12, so each product is below 2^29. */
static int16_t place(int32_t by_x, int32_t by_y, struct pel_touch_point at,
                     int16_t to, int16_t size)
{
    const int32_t sum = by_x * at.x + by_y * at.y + 0x8000;
    /* Rounded down whatever the sign: 2^14 px are added, and taken off. */
    const int32_t px =
        (int32_t)((uint32_t)(sum + 0x40000000) >> 16) - 0x4000 + to;
    return (int16_t)(px < 0 ? 0 : px < size ? px : size - 1);
}

struct pel_touch_point pel_touch_map_point(const struct pel_touch_map *map,
                                           struct pel_touch_point point)
{
    const struct pel_touch_point at = from(map->from, point);
    return (struct pel_touch_point){
        place(map->x_by_x, map->x_by_y, at, map->to.x, map->width),
        place(map->y_by_x, map->y_by_y, at, map->to.y, map->height)};
}

enum pel_status pel_touch_poll(struct pel_touch *touch, uint32_t time,
                               struct pel_input_queue *queue)
{
    struct pel_touch_point points[PEL_TOUCH_FINGERS];
    unsigned down = 0;
    const enum pel_status status = touch->read(touch->bus, points, &down);
    if (status != PEL_OK)
        down = 0;
    if (pel_input_lost(queue, &touch->losses))
        touch->down = 0;
    for (int i = 0; i < PEL_TOUCH_FINGERS; i++) {
        const bool is = down >> i & 1, was = touch->down >> i & 1;
        struct pel_touch_point *last = &touch->last[i], at = *last;
        if (is)
            at = pel_touch_map_point(&touch->map, points[i]);
        if (is == was && (!is || (at.x == last->x && at.y == last->y)))
            continue;
        *last = at;
        pel_input_push(queue,
                       &(struct pel_input){.time = time,
                                           .kind = PEL_INPUT_TOUCH,
                                           .state = !is   ? PEL_INPUT_UP
                                                    : was ? PEL_INPUT_AGAIN
                                                          : PEL_INPUT_DOWN,
                                           .code = (uint16_t)i,
                                           .x = at.x,
                                           .y = at.y});
    }
    touch->down = down;
    return status;
}
