#include <string.h>

#include "scene.h"

/* Six digits of six bits: their counts take 256 bytes of stack. */
enum { BITS = 6, DIGITS = 1 << BITS, KEY_DIGITS = 6 };

/* Digit 0..5 of a key that rises with falling depth. */
static uint32_t digit_of(const struct pel_depth_entry *e, int digit)
{
    const uint32_t key = ~(uint32_t)e->depth ^ UINT32_C(0x80000000);
    return key >> BITS * digit & (DIGITS - 1);
}

/* Sets at[d] to the place of the first entry with digit d. False: all have the
 * same one. */
static bool find_places(const struct pel_depth_entry *entry, uint32_t n,
                        int digit, uint32_t at[DIGITS])
{
    uint32_t place = 0;
    memset(at, 0, DIGITS * sizeof *at);
    for (uint32_t i = 0; i < n; i++)
        at[digit_of(&entry[i], digit)]++;
    if (at[digit_of(&entry[0], digit)] == n)
        return false;
    for (uint32_t *to = at; to < at + DIGITS; to++) {
        const uint32_t count = *to;
        *to = place;
        place += count;
    }
    return true;
}

/* From the lowest digit on, each pass keeping the order of equal ones. */
static void radix_sort(struct pel_depth_entry *entry, uint32_t n,
                       struct pel_depth_entry *spare)
{
    struct pel_depth_entry *from = entry, *to = spare;
    uint32_t at[DIGITS];
    for (int digit = 0; digit < KEY_DIGITS && n > 0; digit++) {
        if (!find_places(from, n, digit, at))
            continue;
        for (uint32_t i = 0; i < n; i++)
            to[at[digit_of(&from[i], digit)]++] = from[i];
        struct pel_depth_entry *const sorted = to;
        to = from;
        from = sorted;
    }
    if (from != entry)
        memcpy(entry, from, n * sizeof *entry);
}

const struct pel_depth_sort pel_depth_sort_radix = {radix_sort, true};
