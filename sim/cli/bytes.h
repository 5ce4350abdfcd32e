/* Numbers as files hold them: bytes from the lowest, or from the highest. */
#ifndef SIM_CLI_BYTES_H
#define SIM_CLI_BYTES_H

#include <stdint.h>

static inline uint32_t bytes_little(const uint8_t *p, int n)
{
    uint32_t v = 0;
    while (n-- > 0)
        v = v << 8 | p[n];
    return v;
}

static inline uint32_t bytes_big(const uint8_t *p, int n)
{
    uint32_t v = 0;
    for (; n > 0; n--)
        v = v << 8 | *p++;
    return v;
}

#endif
