/* Pel: exact triangles and circles in any framebuffer. Includes only. */
#ifndef PEL_H
#define PEL_H

#ifdef __cplusplus
extern "C" {
#endif

#include "base/color.h"
#include "base/fixed.h"
#include "base/format.h"
#include "base/rect.h"
#include "base/status.h"
#include "base/surface.h"
#include "format/formats.h"
#include "raster/circle.h"
#include "raster/gouraud.h"
#include "raster/line.h"
#include "raster/paint.h"
#include "raster/polygon.h"
#include "raster/rectangle.h"
#include "raster/triangle.h"

#ifdef __cplusplus
}
#endif

#endif
