/* Products of 64 bits. */
#ifndef PEL_BASE_MULTIPLY_H
#define PEL_BASE_MULTIPLY_H

#include "inline.h"

PEL_BEGIN_DECLS

/* pel_product: a b for |a|, |b| < 2^30. pel_multiply: a b without a sign.
 * pel_times: a n modulo 2^64, of any a in two's complement. pel_dot: the dot
 * product, which must fit. pel_bits_of: 0 for 0, otherwise 2^(bits - 1) <= v <
 * 2^bits. Small CPUs have functions that are shorter than the compiler's for 64
 * by 64 bits. */
#if PEL_LONG_MULTIPLY
static inline int64_t pel_product(int32_t a, int32_t b)
{
    return PEL_CAST(int64_t, a) * b;
}

static inline uint64_t pel_multiply(uint32_t a, uint32_t b)
{
    return PEL_CAST(uint64_t, a) * b;
}

static inline uint64_t pel_times(uint64_t a, int32_t n)
{
    return a * PEL_CAST(uint64_t, n);
}

static inline int64_t pel_dot(const int32_t a[3], const int32_t b[3])
{
    return PEL_CAST(int64_t, a[0]) * b[0] + PEL_CAST(int64_t, a[1]) * b[1] +
           PEL_CAST(int64_t, a[2]) * b[2];
}

static inline int pel_bits_of(uint64_t v)
{
    return v ? 64 - pel_leading_zeros(v) : 0;
}
#else
int64_t pel_product(int32_t a, int32_t b);
uint64_t pel_multiply(uint32_t a, uint32_t b);
uint64_t pel_times(uint64_t a, int32_t n);
int64_t pel_dot(const int32_t a[3], const int32_t b[3]);
int pel_bits_of(uint64_t v);
#endif

/* a b with a sign, of any two. */
static inline int64_t pel_long_product(int32_t a, int32_t b)
{
    return PEL_LONG_MULTIPLY
               ? PEL_CAST(int64_t, a) * b
               : PEL_CAST(int64_t, pel_times(PEL_CAST(uint64_t, a), b));
}

static inline int64_t pel_square(int32_t u)
{
    return pel_product(u, u);
}

/* |v|; that of -2^63 is -2^63: cast it to unsigned where v may be that. */
static inline int64_t pel_size_of(int64_t v)
{
    return v < 0 ? PEL_CAST(int64_t, 0 - PEL_CAST(uint64_t, v)) : v;
}
PEL_END_DECLS
#endif
