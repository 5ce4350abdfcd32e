#include "scene.h"

/* Six digits of six bits: their counts take 256 bytes of stack. */
enum { BITS = 6, DIGITS = 1 << BITS, KEY_DIGITS = 6 };

/* Digit 0..5 of a key that rises with falling depth. */
static uint32_t digit_of(const struct pel_depth_entry *e, int digit)
{
    const uint32_t key = ~(uint32_t)e->depth ^ UINT32_C(0x80000000);
    return key >> BITS * digit & (DIGITS - 1);
}

/* One pass, which keeps the order of entries with the same digit. */
static void sort_by(int digit, const struct pel_depth_entry *from, uint32_t n,
                    struct pel_depth_entry *to)
{
    uint32_t at[DIGITS] = {0}, place = 0;
    for (uint32_t i = 0; i < n; i++)
        at[digit_of(&from[i], digit)]++;
    for (int d = 0; d < DIGITS; d++) {
        const uint32_t count = at[d];
        at[d] = place;
        place += count;
    }
    for (uint32_t i = 0; i < n; i++)
        to[at[digit_of(&from[i], digit)]++] = from[i];
}

/* From the lowest digit on. */
static void radix_sort(struct pel_depth_entry *entry, uint32_t n,
                       struct pel_depth_entry *spare)
{
    for (int digit = 0; digit < KEY_DIGITS; digit += 2) {
        sort_by(digit, entry, n, spare);
        sort_by(digit + 1, spare, n, entry);
    }
}

const struct pel_depth_sort pel_depth_sort_radix = {radix_sort, true};
