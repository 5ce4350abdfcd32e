/* Division of 64 by 32 and by 64 bits. */
#ifndef PEL_BASE_DIVIDE_H
#define PEL_BASE_DIVIDE_H

#include <stdint.h>

#include "inline.h"

/* floor(n / d); d > 0, n < d 2^32. */
#if PEL_64BIT
static inline uint32_t pel_divide(uint64_t n, uint32_t d)
{
    return (uint32_t)(n / d);
}
#else
uint32_t pel_divide(uint64_t n, uint32_t d);
#endif

/* floor(n / d), and what is left; d > 0. On small CPUs in less code and stack
 * than the compiler's. */
#if PEL_64BIT
static inline uint64_t pel_divide_64(uint64_t n, uint64_t d, uint64_t *rest)
{
    *rest = n % d;
    return n / d;
}
#else
uint64_t pel_divide_64(uint64_t n, uint64_t d, uint64_t *rest);
#endif

#endif
