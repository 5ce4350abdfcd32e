/* CRC-32 of ISO 3309 (Ethernet, zip), bit by bit: no table. */
#ifndef PEL_DRIVERS_CRC_H
#define PEL_DRIVERS_CRC_H

#include <stddef.h>
#include <stdint.h>

/* That of what gave `crc`, 0 at first, and n bytes behind it. */
static inline uint32_t pel_crc(uint32_t crc, const uint8_t *bytes, size_t n)
{
    for (crc = ~crc; n > 0; n--) {
        crc ^= *bytes++;
        for (int bit = 0; bit < 8; bit++)
            crc = crc >> 1 ^ (crc & 1 ? UINT32_C(0xEDB88320) : 0);
    }
    return ~crc;
}

#endif
