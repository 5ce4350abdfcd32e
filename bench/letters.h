/* A font of one letter of 8 x 8 px, as Allegro 4 has it, and a line of it. */
#ifndef BENCH_LETTERS_H
#define BENCH_LETTERS_H

#include "core/asset/font_asset.h"

static const struct pel_font_range letters_range = {'A', 1, 0};
static const struct pel_font_glyph letters_glyph = {0, 8, 8, 0, 7, 8};
static const uint8_t letters_bits[8] = {0x30, 0x78, 0xcc, 0xcc,
                                        0xfc, 0xcc, 0xcc};
static const struct pel_font_asset letters = {PEL_FONT_MAGIC,
                                              PEL_FONT_VERSION,
                                              7,
                                              1,
                                              1,
                                              1,
                                              PEL_FONT_NONE,
                                              8,
                                              &letters_range,
                                              &letters_glyph,
                                              letters_bits,
                                              NULL,
                                              NULL,
                                              0,
                                              NULL};
static const char letters_line[] = "AAAAAAAAAAAAAAAAAAAAAAAA";

#endif
