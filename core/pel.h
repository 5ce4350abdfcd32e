/* Pel: exact triangles and circles in any framebuffer. Includes only. */
#ifndef PEL_H
#define PEL_H

#ifdef __cplusplus
extern "C" {
#endif

#include "base/color.h"
#include "base/point.h"
#include "base/trig.h"
#include "base/format.h"
#include "base/hsv.h"
#include "base/rect.h"
#include "base/status.h"
#include "base/surface.h"

#include "format/argb8888.h"
#include "format/formats.h"

#include "raster/gouraud.h"
#include "raster/line.h"
#include "raster/paint.h"
#include "raster/polygon.h"
#include "raster/rectangle.h"
#include "raster/thick_line.h"
#include "raster/triangle.h"

#include "round/arc.h"
#include "round/circle.h"
#include "round/ellipse.h"
#include "round/ring.h"
#include "round/rounded_rectangle.h"
#include "round/sector.h"

#include "outline/outline.h"

#include "hit/hit.h"

#include "paint/color_ramp.h"
#include "paint/paint_conic.h"
#include "paint/paint_dither.h"
#include "paint/paint_fan.h"
#include "paint/paint_hue.h"
#include "paint/paint_linear.h"
#include "paint/paint_radial.h"
#include "paint/paint_texture.h"

#include "image/copy.h"
#include "image/glyph.h"
#include "image/glyph_text.h"
#include "image/scroll.h"

#include "asset/font_asset.h"
#include "asset/image_asset.h"
#include "asset/mesh_asset.h"

#include "scene/normals.h"
#include "scene/pipeline.h"

#ifdef __cplusplus
}
#endif

#endif
