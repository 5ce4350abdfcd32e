/* Byte order: the CPU's value of a word against its bytes in memory. */
#include <string.h>

#include "core/format/word.h"
#include "tests/support/check.h"

TEST(swaps)
{
    for (uint32_t v = 0; v <= 0xFFFF; v++)
        assert_int_equal(pel_swap16(v), (v & 255) * 256 + v / 256);
    assert_int_equal(pel_swap32(0x01020304), 0x04030201);
    assert_int_equal(pel_swap32(0xFF00EE80), 0x80EE00FF);
    for (int i = 0; i < 32; i++)
        assert_int_equal(pel_swap32(UINT32_C(1) << i),
                         UINT32_C(1) << ((3 - i / 8) * 8 + i % 8));
}

TEST(words_in_memory)
{
    static const uint8_t byte[4] = {0x11, 0x22, 0x33, 0x44};
    uint16_t half;
    uint32_t word;
    memcpy(&half, byte, 2);
    memcpy(&word, byte, 4);
    assert_int_equal(PEL_LE16(half), 0x2211);
    assert_int_equal(PEL_BE16(half), 0x1122);
    assert_int_equal(PEL_LE32(word), 0x44332211);
}

/* To 8 bits by repeating them from the top. */
TEST(widening)
{
    for (uint32_t v = 0; v < 32; v++)
        assert_int_equal(pel_widen(v, 5), v * 8 + v / 4);
    for (uint32_t v = 0; v < 64; v++)
        assert_int_equal(pel_widen(v, 6), v * 4 + v / 16);
    assert_int_equal(pel_widen(31, 5), 255);
    assert_int_equal(pel_widen(63, 6), 255);
}
