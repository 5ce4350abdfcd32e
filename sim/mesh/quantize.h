/* Coordinates as the 16-bit numbers of core/asset/mesh_asset.h. */
#ifndef SIM_MESH_QUANTIZE_H
#define SIM_MESH_QUANTIZE_H

#include "core/asset/mesh_asset.h"
#include "sim/mesh/mesh.h"

/* For the positions of a mesh: signed numbers, around the middle of its box.
 * The shift is at most `shift_max`. */
struct pel_quantization quantize_positions(const struct mesh *mesh,
                                           int shift_max);

/* For its uv: unsigned numbers, from the least coordinates on. */
struct pel_quantization quantize_uv(const struct mesh *mesh);

/* The nearest number of a coordinate. */
long quantize(const struct pel_quantization *quantum, int axis, double value);

#endif
