/* Copies of pictures whose equal pixels are counted, straight from flash: runs
 * are filled, other pixels are copied from where they lie. */
#ifndef PEL_IMAGE_COPY_RUNS_H
#define PEL_IMAGE_COPY_RUNS_H

#include "../asset/runs_asset.h"
#include "../base/surface.h"

PEL_BEGIN_DECLS

struct pel_runs_part {
    const struct pel_runs_asset *source; /* pel_runs_asset_check gave PEL_OK */
    const struct pel_format *format;     /* with this format: its pixels' */
    int32_t x, y; /* px, -65,536..65,536: where its top left pixel goes */
};

/* Puts each pixel over what is there, inside the clip, weighted by its own
 * alpha times `alpha`, as pel_copy_alpha does: 255 copies a picture without
 * alpha. x or y out of range is a broken contract: PEL_ASSERT, and nothing is
 * drawn. Rows above a band take no time; pixels on the left of the clip take
 * that of their counts, some 20 instructions for each. A part of a picture is
 * drawn by the clip of a copy of the surface (pel_surface_clip). */
void pel_copy_runs(const struct pel_surface *surface,
                   const struct pel_runs_part *copy, uint8_t alpha);
PEL_END_DECLS
#endif
