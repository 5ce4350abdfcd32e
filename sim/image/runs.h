/* Pictures as runs, in the words of core/asset/runs_asset.h. */
#ifndef SIM_IMAGE_RUNS_H
#define SIM_IMAGE_RUNS_H

#include "core/base/surface.h"

struct runs {
    size_t bytes;   /* of a word */
    uint32_t size;  /* words */
    uint8_t *words; /* malloc'ed */
    uint32_t *rows; /* malloc'ed: the word where each row begins */
};

/* Of a surface from (0, 0), with rows one behind the other; not of mono1_pages.
 * The bits behind the last pixel of a row change. False, with a message, when
 * memory is short. Either way runs_free ends them. */
bool runs_make(struct runs *runs, const struct pel_surface *surface);
void runs_free(struct runs *runs);

/* Do 16 bits hold where each row begins? */
static inline bool runs_are_short(const struct runs *runs)
{
    return runs->size <= 65536;
}

#endif
