/* Lists of fingers, which have no numbers: who was where? */
#include <linux/input.h>

#include "evdev.h"

void pel_evdev_list_take(struct pel_evdev_list *list, int code, int value)
{
    if (code == ABS_MT_POSITION_X)
        list->x = value;
    else if (code == ABS_MT_POSITION_Y)
        list->y = value;
    else
        return;
    list->placed = true;
}

static int64_t distance(const struct pel_evdev_finger *a,
                        const struct pel_evdev_finger *b)
{
    const int64_t x = a->x - b->x, y = a->y - b->y;
    return x * x + y * y;
}

/* The nearest pair of a finger that was down and one of the list, neither of
 * which has another yet; false: there is none. */
static bool nearest(const struct pel_evdev_finger *told,
                    const struct pel_evdev_list *l, const int *at, int pair[2])
{
    int64_t least = INT64_MAX;
    for (int i = 0; i < PEL_EVDEV_FINGERS; i++)
        for (int k = 0; k < l->n; k++) {
            bool taken = !told[i].down || at[i] >= 0;
            for (int other = 0; other < PEL_EVDEV_FINGERS; other++)
                taken = taken || at[other] == k;
            const int64_t d = distance(&told[i], &l->finger[k]);
            if (taken || d >= least)
                continue;
            least = d;
            pair[0] = i;
            pair[1] = k;
        }
    return least < INT64_MAX;
}

void pel_evdev_match(const struct pel_evdev_finger told[PEL_EVDEV_FINGERS],
                     const struct pel_evdev_list *list,
                     int at[PEL_EVDEV_FINGERS])
{
    int pair[2];
    bool used[PEL_EVDEV_FINGERS] = {false};
    for (int i = 0; i < PEL_EVDEV_FINGERS; i++)
        at[i] = -1;
    while (nearest(told, list, at, pair)) {
        at[pair[0]] = pair[1];
        used[pair[1]] = true;
    }
    for (int k = 0, i = 0; k < list->n; k++) {
        while (!used[k] && (at[i] >= 0 || told[i].down))
            i = (i + 1) % PEL_EVDEV_FINGERS;
        if (!used[k])
            at[i] = k;
    }
}
