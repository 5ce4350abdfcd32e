#include "scene.h"

/* Keys rise with falling depth, and with the index where depths are equal. */
static uint64_t key_of(const struct pel_depth_entry *e)
{
    return (uint64_t)(~(uint32_t)e->depth ^ UINT32_C(0x80000000)) << 32 |
           e->index;
}

/* Moves the entry at `at` down to its rank in the heap of n, whose largest key
 * is on top. */
static void sift(struct pel_depth_entry *entry, uint32_t at, uint32_t n)
{
    const struct pel_depth_entry moved = entry[at];
    const uint64_t key = key_of(&moved);
    for (uint32_t child; (child = 2 * at + 1) < n; at = child) {
        if (child + 1 < n && key_of(&entry[child]) < key_of(&entry[child + 1]))
            child++;
        if (key_of(&entry[child]) <= key)
            break;
        entry[at] = entry[child];
    }
    entry[at] = moved;
}

static void heap_sort(struct pel_depth_entry *entry, uint32_t n,
                      struct pel_depth_entry *spare)
{
    (void)spare;
    for (uint32_t i = n / 2; i-- > 0;)
        sift(entry, i, n);
    while (n > 1) {
        const struct pel_depth_entry last = entry[--n];
        entry[n] = entry[0];
        entry[0] = last;
        sift(entry, 0, n);
    }
}

const struct pel_depth_sort pel_depth_sort = {heap_sort, false};
