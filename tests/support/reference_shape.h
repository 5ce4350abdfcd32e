/* As reference.h: curved shapes, every pixel centre judged by itself. */
#ifndef TESTS_SUPPORT_REFERENCE_SHAPE_H
#define TESTS_SUPPORT_REFERENCE_SHAPE_H

#include "core/pel.h"
#include "core/round/arc.h"
#include "core/round/ellipse.h"
#include "core/round/ring.h"
#include "core/round/rounded_rectangle.h"
#include "core/round/sector.h"

/* 32,768 cos and sin of an angle, each the nearest integer. */
struct pel_point reference_direction(uint16_t turn);

bool reference_ring_at(const struct pel_ring_shape *ring, int32_t x, int32_t y);
bool reference_sector_at(const struct pel_sector_shape *sector, int32_t x,
                         int32_t y);
bool reference_arc_at(const struct pel_arc_shape *arc, int32_t x, int32_t y);
bool reference_ellipse_at(const struct pel_ellipse_shape *e, int32_t x,
                          int32_t y);
bool reference_rounded_at(const struct pel_rounded_shape *r, int32_t x,
                          int32_t y);

#endif
