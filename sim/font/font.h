/* Fonts of glyphs of one bit, or of coverage, as files hold them. */
#ifndef SIM_FONT_FONT_H
#define SIM_FONT_FONT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    FONT_SIZE_MAX = 255, /* px, of a glyph, a line and an advance */
    FONT_CODE_MAX = 0x10FFFF,
    FONT_SIZE = 16 /* of a scalable font, where nobody names another */
};

/* A code point and its glyph; empty ones have width and height 0. */
struct font_char {
    uint32_t code;
    int width, height;
    int left, top; /* px from the pen to the left column, and from the baseline
                      up to above the top row */
    int advance;
    size_t offset; /* of its rows in font.bits, as in core/asset/font_asset.h;
                      of coverage a byte a pixel; of its points */
    size_t bytes;  /* of points */
};

/* Beside the advance, between two code points; x in px. */
struct font_pair {
    uint32_t left, right;
    int x;
};

struct font {
    int ascent, descent;
    long missing;            /* the code point shown for others, or -1 */
    struct font_char *chars; /* by code point */
    size_t count;
    uint8_t *bits;
    size_t size;
    int steps; /* bits of a step of coverage in the asset; here a byte a pixel.
                  0: rows of one bit */
    struct font_pair *pairs; /* by left, then right */
    size_t pair_count;

    /* Of a font of outlines, whose lengths are all in its units; its bits are
     * those of core/asset/outline_font_asset.h. */
    int em;     /* 0: glyphs are pictures */
    int box[4]; /* left, bottom, right, top of all glyphs */
};

struct font_options {
    const char *encoding; /* of its codes, by charset_open; NULL: as it says */
    int size;             /* px from line to line of a scalable font */
    int bits;             /* of a pixel: 1; of outlines 2, 4, 8; 0: 4 of them */
    enum font_hinting {
        FONT_HINTING, /* light, of one bit full */
        FONT_UNHINTED,
        FONT_HINTED_LIGHT, /* what is level moves to whole pixels */
        FONT_HINTED_FULL   /* stems too */
    } hinting;
    bool outline; /* no pictures: the outlines as they are, of scalable fonts */
    bool (*is_wanted)(long code); /* what is not is left out without a word;
                                     NULL: all are */
};

/* Reads a BDF or a PSF file (versions 1 and 2), told apart by their first
 * bytes, or what else FreeType reads, in a child process; "-" is standard
 * input. Of two glyphs of a character the first one counts. What is read in
 * spite of a mistake is told. False, with a message on standard error, when it
 * cannot; the font is then empty. */
bool font_load(struct font *font, const char *path,
               const struct font_options *options);
void font_free(struct font *font);

/* A file in memory, with a 0 behind its last byte. */
struct font_file {
    const char *path;
    char *data;
    size_t size;
    struct font_options options;
};

/* The parsers; the last is FreeType's. */
bool font_parse_bdf(struct font *font, const struct font_file *file);
bool font_parse_psf(struct font *font, const struct font_file *file);
bool font_parse_other(struct font *font, const struct font_file *file);

/* Puts what is packed by gzip in its place, malloc'ed. False, with a message.
 */
bool font_unpack(struct font_file *file);

/* For the parsers: adds a glyph whose rows are `stride` bytes apart, of bits,
 * or of bytes in a smooth font, without the empty rows and columns around it.
 * False when memory is short or the glyph is out of range (message). */
bool font_add(struct font *font, const struct font_char *glyph,
              const uint8_t *bits, size_t stride);

/* The last glyph once more, for another code point. False when memory is short.
 */
bool font_add_alias(struct font *font, uint32_t code);

#endif
