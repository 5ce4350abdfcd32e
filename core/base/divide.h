/* Division of 64 by 32 bits. */
#ifndef PEL_BASE_DIVIDE_H
#define PEL_BASE_DIVIDE_H

#include <stdint.h>

#include "../pel_config.h"

/* floor(n / d); d > 0, n < d 2^32. */
#if PEL_FAST_64BIT
static inline uint32_t pel_divide(uint64_t n, uint32_t d)
{
    return (uint32_t)(n / d);
}
#else
uint32_t pel_divide(uint64_t n, uint32_t d);
#endif

#endif
