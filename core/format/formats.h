/* Every pixel format of displays, each in the file of its name; layouts in
 * base/format.h. The _fill variant takes opaque flat fills and gradients
 * alone, for the smallest programs. */
#ifndef PEL_FORMAT_FORMATS_H
#define PEL_FORMAT_FORMATS_H

#include "../base/format.h"

PEL_BEGIN_DECLS

extern const struct pel_format pel_rgb565_le;
extern const struct pel_format pel_rgb565_le_fill;
extern const struct pel_format pel_rgb565_be;
extern const struct pel_format pel_rgb565_be_fill;
extern const struct pel_format pel_bgr565_le;
extern const struct pel_format pel_xrgb1555_le;
extern const struct pel_format pel_rgb888;
extern const struct pel_format pel_bgr888;
extern const struct pel_format pel_xrgb8888;
extern const struct pel_format pel_xbgr8888;
extern const struct pel_format pel_rgbx8888;
extern const struct pel_format pel_bgrx8888;
extern const struct pel_format pel_rgb332;
extern const struct pel_format pel_gray8;
extern const struct pel_format pel_gray4;
extern const struct pel_format pel_gray2;
extern const struct pel_format pel_mono1;
extern const struct pel_format pel_mono1_pages;
extern const struct pel_format pel_inks2;
PEL_END_DECLS
#endif
