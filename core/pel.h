/* Pel: exact triangles and circles in any framebuffer. Includes only. */
#ifndef PEL_H
#define PEL_H

#ifdef __cplusplus
extern "C" {
#endif

#include "base/color.h"
#include "base/fixed.h"
#include "base/fixed_trig.h"
#include "base/format.h"
#include "base/hsv.h"
#include "base/rect.h"
#include "base/status.h"
#include "base/surface.h"
#include "asset/font_asset.h"
#include "asset/image_asset.h"
#include "asset/mesh_asset.h"
#include "format/formats.h"
#include "raster/arc.h"
#include "raster/circle.h"
#include "raster/color_ramp.h"
#include "raster/ellipse.h"
#include "raster/gouraud.h"
#include "raster/hit.h"
#include "raster/line.h"
#include "raster/outline.h"
#include "raster/paint.h"
#include "raster/paint_conic.h"
#include "raster/paint_dither.h"
#include "raster/paint_fan.h"
#include "raster/paint_hue.h"
#include "raster/paint_linear.h"
#include "raster/paint_radial.h"
#include "raster/paint_texture.h"
#include "raster/polygon.h"
#include "raster/rectangle.h"
#include "raster/ring.h"
#include "raster/rounded_rectangle.h"
#include "raster/sector.h"
#include "raster/thick_line.h"
#include "raster/triangle.h"
#include "image/argb8888.h"
#include "image/copy.h"
#include "image/glyph.h"
#include "image/glyph_text.h"
#include "image/scroll.h"

#ifdef __cplusplus
}
#endif

#endif
