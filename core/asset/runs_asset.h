/* Pictures in flash whose equal pixels are counted, as `pel import --compress`
 * writes them; drawn by pel_copy_runs.
 *
 * A row is a sequence of words: pixels of 8 bits and more, or bytes of smaller
 * ones. A word that counts is followed by those it counts: 2 n by n words as
 * they are; 2 n + 1 by one word, whose first pixel stands for all those of n
 * words. n is at least 1; it has 15 bits, or 7 where words are bytes, low byte
 * first, and what is left of its word is 0. A row ends with the pixels of the
 * width, in the midst of a byte or not. */
#ifndef PEL_ASSET_RUNS_ASSET_H
#define PEL_ASSET_RUNS_ASSET_H

#include <stddef.h>

#include "../base/format.h"
#include "../base/inline.h"
#include "../base/status.h"

/* "PELR", and the version of the struct. */
#define PEL_RUNS_MAGIC UINT32_C(0x524C4550)
enum { PEL_RUNS_VERSION = 1 };

struct pel_runs_asset {
    uint32_t magic;         /* PEL_RUNS_MAGIC */
    uint8_t version;        /* PEL_RUNS_VERSION */
    uint8_t format;         /* enum pel_format_id of the pixels */
    uint16_t width, height; /* px, 1..32,767 */
    uint32_t size;          /* words of all rows */
    const void *words;      /* aligned to 4 bytes */

    /* Where each row begins, in words; equal rows begin at the same one. One of
     * the two is NULL. */
    const uint16_t *rows16;
    const uint32_t *rows32;
};

/* Checks that the program can read this asset as `format`. PEL_ERROR_NULL;
 * PEL_ERROR_RANGE: no asset of runs, or one of another version;
 * PEL_ERROR_FORMAT: its pixels are of another format, or of one that cannot be
 * read or has no runs (mono1_pages); PEL_ERROR_SIZE. Rows and words are not
 * checked: wrong ones show other pixels, or none, and nothing beyond `size` is
 * read. */
static inline enum pel_status pel_runs_asset_check(
    const struct pel_runs_asset *runs, const struct pel_format *format)
{
    if (!runs || !format || !runs->words || !runs->rows16 == !runs->rows32)
        return PEL_ERROR_NULL;
    if (runs->magic != PEL_RUNS_MAGIC || runs->version != PEL_RUNS_VERSION)
        return PEL_ERROR_RANGE;
    if (runs->format != format->id || format->id == PEL_FORMAT_MONO1_PAGES ||
        !format->load)
        return PEL_ERROR_FORMAT;
    if (runs->width < 1 || runs->width > 32767 || runs->height < 1 ||
        runs->height > 32767)
        return PEL_ERROR_SIZE;
    return PEL_OK;
}

#endif
