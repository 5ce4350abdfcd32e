/* Numbers of the 3-D pipeline. Space is right-handed, y up; vectors are
 * columns. What has no name here is a plain integer with its unit beside it. */
#ifndef PEL_SCENE_VECTOR_H
#define PEL_SCENE_VECTOR_H

#include "../base/point.h"
#include "../pel_config.h"

/* Places in the world: 1/65,536 unit, from -16,384 to 16,384 units. A
 * difference of two fits 32 bits unsigned, and their sum weighted by a unit
 * vector 62. */
typedef int32_t pel_length;

#define PEL_LENGTH_MAX (INT32_C(1) << 30)

/* n units, for constant expressions too; a constant may have a fraction. */
#define PEL_UNITS(n) PEL_CAST(pel_length, (n)*INT64_C(65536))

/* Parts of unit vectors: 2^-30, from -1 to 1. */
typedef int32_t pel_cosine;

#define PEL_COSINE_ONE (INT32_C(1) << 30)

/* Factors of light and material: 1/65,536, from 0 to less than 16. */
typedef int32_t pel_factor;

#define PEL_FACTOR(percent) PEL_CAST(pel_factor, (percent)*INT64_C(65536) / 100)
#define PEL_FACTOR_END (UINT32_C(16) * 65536)

/* The sums that follow are in the header where they are short, and there once
 * where 64 bits are long code. */
#if PEL_FAST_64BIT
#include "vector_sums.h"
#endif

PEL_BEGIN_DECLS

#if !PEL_FAST_64BIT
int64_t pel_scale_down(int64_t v, int n);
int32_t pel_scaled(int32_t a, int32_t b, int n);
int64_t pel_dot(const int32_t a[3], const int32_t b[3]);
#endif

/* Bits of v: 0 for 0, otherwise 2^(bits - 1) <= v < 2^bits. */
int pel_bits_of(uint64_t v);

static inline int64_t pel_size_of(int64_t v)
{
    return v < 0 ? -v : v;
}

/* At least the largest size of a part, and with as many bits. */
uint64_t pel_vector_bound(const int64_t v[3]);

/* a b - c d; must fit. */
int64_t pel_minor(int32_t a, int32_t b, int32_t c, int32_t d);

/* A direction for light: unit gets v scaled to length 1, each part off by less
 * than 2^-21. No division. |v[k]| <= 2^30; false, and all 0, when v is 0. unit
 * may be v. */
bool pel_normalize_fast(const int32_t v[3], pel_cosine unit[3]);

/* A direction for places: the same, off by less than 2^-28, by divisions.
 * |v[k]| < 2^62. */
bool pel_normalize(const int64_t v[3], pel_cosine unit[3]);

/* v times a power of two, so that the largest part is in [2^29, 2^30]; rounded
 * where v has more bits. False, and all 0, when v is 0. |v[k]| < 2^62. */
bool pel_vector_fit(const int64_t v[3], int32_t fit[3]);
PEL_END_DECLS
#endif
