/* Division of 64 by 32 bits. */
#ifndef PEL_BASE_FIXED_DIVIDE_H
#define PEL_BASE_FIXED_DIVIDE_H

#include <stdint.h>

/* floor(n / d); n < d 2^32. */
uint32_t pel_divide(uint64_t n, uint32_t d);

#endif
