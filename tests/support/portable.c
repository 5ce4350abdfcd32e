#include "portable.h"

void portable_pel_triangle(const struct pel_surface *, const struct pel_point *,
                           const struct pel_paint *);
void portable_pel_triangle_gouraud(const struct pel_surface *,
                                   const struct pel_point *, const pel_color *);
enum pel_status portable_pel_polygon(const struct pel_surface *,
                                     const struct pel_polygon_shape *,
                                     const struct pel_paint *, void *, size_t);
void portable_pel_circle(const struct pel_surface *, struct pel_point, int32_t,
                         const struct pel_paint *);
void portable_pel_line(const struct pel_surface *, struct pel_point,
                       struct pel_point, const struct pel_paint *);
void portable_pel_rectangle(const struct pel_surface *, struct pel_point,
                            struct pel_point, const struct pel_paint *);
void portable_pel_flat_fill(const struct pel_paint *, const struct pel_spans *);

#define PORTABLE(name) extern const struct pel_format portable_pel_##name
PORTABLE(rgb565_le);
PORTABLE(rgb565_be);
PORTABLE(bgr565_le);
PORTABLE(xrgb1555_le);
PORTABLE(rgb888);
PORTABLE(bgr888);
PORTABLE(xrgb8888);
PORTABLE(xbgr8888);
PORTABLE(rgbx8888);
PORTABLE(bgrx8888);
PORTABLE(rgb332);
PORTABLE(gray8);
PORTABLE(gray4);
PORTABLE(mono1);
PORTABLE(mono1_pages);

/* In the order of layouts[]. */
const struct pel_format *const portable_formats[LAYOUT_COUNT] = {
    &portable_pel_rgb565_le,   &portable_pel_rgb565_be,
    &portable_pel_bgr565_le,   &portable_pel_xrgb1555_le,
    &portable_pel_rgb888,      &portable_pel_bgr888,
    &portable_pel_xrgb8888,    &portable_pel_xbgr8888,
    &portable_pel_rgbx8888,    &portable_pel_bgrx8888,
    &portable_pel_rgb332,      &portable_pel_gray8,
    &portable_pel_gray4,       &portable_pel_mono1,
    &portable_pel_mono1_pages,
};

const struct core core_portable = {portable_pel_triangle,
                                   portable_pel_triangle_gouraud,
                                   portable_pel_polygon,
                                   portable_pel_circle,
                                   portable_pel_line,
                                   portable_pel_rectangle,
                                   {portable_pel_flat_fill, NULL}};
