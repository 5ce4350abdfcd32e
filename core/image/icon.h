/* Icons: parts of paths with colours, gradients and strokes, at any size and
 * angle from one table, as `pel import ICON.svg` writes it. Icons of one size
 * that stand upright take less time as pictures (`--icon-size`).
 *
 *     static uint64_t scratch[ICON_HOME_SCRATCH(48) / 8 + 1];
 *     struct pel_icon_shape home = {.icon = &icon_home,
 *                                   .kind = &pel_icon_smooth};
 *     pel_icon_place(&home, PEL_PX(48), 0, pel_at(32, 32));
 *     pel_icon(&screen, &home, scratch, sizeof scratch);
 */
#ifndef PEL_IMAGE_ICON_H
#define PEL_IMAGE_ICON_H

#include "../asset/icon_asset.h"
#include "../path/smooth_path.h"

PEL_BEGIN_DECLS

/* What draws parts, aliased or smooth; the first of each for icons without
 * strokes, the second for all. A program links the code of those that it names.
 */
struct pel_icon_kind;
extern const struct pel_icon_kind pel_icon_aliased, pel_icon_aliased_strokes,
    pel_icon_smooth, pel_icon_smooth_strokes;

/* What draws gradients: an asset that has some names it, and so links it. */
extern const struct pel_icon_gradients pel_icon_gradients;

struct pel_icon_shape {
    const struct pel_icon_asset *icon; /* checked */
    const struct pel_icon_kind *kind;
    struct pel_transform transform; /* of the icon's units */
    int32_t scale;   /* of the width of strokes: 65,536 makes a unit 1/256 px */
    pel_color color; /* of parts that take the program's */
    int32_t tolerance; /* as in struct pel_path_shape */
};

/* Sets transform and scale: the longer side of the icon's box becomes `size`
 * (1/256 px, 0..32,767 px), its middle lies at `at`, and it is turned clockwise
 * by `turn`. PEL_ERROR_RANGE: the corner of the box is no legal point, and the
 * icon is not to be drawn. */
enum pel_status pel_icon_place(struct pel_icon_shape *shape, int32_t size,
                               int32_t turn, struct pel_point at);

/* The pixels that it may draw in. */
struct pel_rect pel_icon_box(const struct pel_icon_shape *shape);

/* Bytes of scratch memory, aligned to 8, of a smooth icon: for so many sides in
 * a row, and a clip or a box of so many pixels. An aliased one takes that of
 * pel_path_fill and pel_path_stroke and PEL_ICON_SIZE more. */
#define PEL_ICON_SIZE (62 * sizeof(void *))
#define PEL_ICON_SCRATCH_SIZE(sides, width) \
    (PEL_SMOOTH_PATH_SCRATCH_SIZE(sides, width) + PEL_ICON_SIZE)

/* Draws the parts one over the other, each as pel_path_fill, pel_path_stroke or
 * the smooth functions of the same names do; no row of pixels is wider than
 * pel_icon_box. A gradient shows at the centre of each pixel the color of its
 * place, within 2 steps of 255. The place is less than 3 + d 4,096ths of the
 * way off, d being how many axes it is from the origin of the frame, whose
 * points are rounded to 1/256 px; beyond 8 axes a radial one stays as it is
 * there. Errors are those of the first part that has one, and the icon ends
 * there; and PEL_ERROR_NULL, PEL_ERROR_SCRATCH (not aligned to 8, or too
 * small), PEL_ERROR_FORMAT: the icon has strokes, and its kind draws none. */
enum pel_status pel_icon(const struct pel_surface *surface,
                         const struct pel_icon_shape *shape, void *scratch,
                         size_t size);
PEL_END_DECLS
#endif
