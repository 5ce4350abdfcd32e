/* Pel: exact shapes, text, pictures and small 3-D scenes in any framebuffer.
 *
 * Shapes are painted onto surfaces, views of your own memory. A pixel belongs
 * to a shape or it does not; the shapes of smooth/smooth.h weigh it by the part
 * that they cover.
 *
 * Threads: core has no state and takes no lock. Any number of threads may draw
 * at once when no two of them write the same bytes: as bands of one picture.
 * They may share paints, formats, fonts, pictures and meshes, which are only
 * read. What drawing changes is for one thread at a time: a struct pel_frame
 * with its scratch memory, pel_outline_filter and pel_dirty.
 * Functions may be called from interrupts too.
 *
 * Stability: until 1.0.0 a minor version may change the interface, and the
 * changelog says how; a patch changes neither the interface nor, but for a
 * defect that it names, a pixel. */
#ifndef PEL_H
#define PEL_H

#define PEL_VERSION_MAJOR 0
#define PEL_VERSION_MINOR 1
#define PEL_VERSION_PATCH 0

#include "base/color.h"
#include "base/point.h"
#include "base/trig.h"
#include "base/format.h"
#include "base/rect.h"
#include "base/status.h"
#include "base/surface.h"

#include "format/argb8888.h"
#include "format/formats.h"
#include "format/palette.h"

#include "raster/dirty.h"
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

#include "smooth/smooth.h"
#include "smooth/smooth_arc.h"
#include "smooth/smooth_circle.h"
#include "smooth/smooth_convex.h"
#include "smooth/smooth_ellipse.h"
#include "smooth/smooth_gouraud.h"
#include "smooth/smooth_polygon.h"
#include "smooth/smooth_rectangle.h"
#include "smooth/smooth_ring.h"
#include "smooth/smooth_rounded_rectangle.h"
#include "smooth/smooth_thick_line.h"

#include "path/path.h"
#include "path/smooth_path.h"

#include "outline/outline.h"

#include "hit/hit.h"

#include "paint/gradient.h"
#include "paint/paint_blend.h"
#include "paint/paint_conic.h"
#include "paint/paint_dither.h"
#include "paint/paint_fan.h"
#include "paint/paint_linear.h"
#include "paint/paint_mask.h"
#include "paint/paint_nine_slice.h"
#include "paint/paint_pattern.h"
#include "paint/paint_radial.h"
#include "paint/paint_texture.h"
#include "paint/turned_picture.h"

#include "image/copy.h"
#include "image/copy_runs.h"
#include "image/glyph_text.h"
#include "image/icon.h"
#include "image/outline_text.h"
#include "image/scroll.h"
#include "image/smooth_glyph.h"
#include "image/smooth_outline_text.h"
#include "image/text_column.h"

#include "asset/font_asset.h"
#include "asset/icon_asset.h"
#include "asset/image_asset.h"
#include "asset/mesh_asset.h"
#include "asset/outline_font_asset.h"
#include "asset/runs_asset.h"

#include "scene/certificate.h"
#include "scene/mapping.h"
#include "scene/perspective.h"
#include "scene/pipeline.h"
#include "scene/select.h"
#include "scene/work.h"

#endif
