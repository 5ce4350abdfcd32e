/* Copies between surfaces of one format: pixels as they lie in memory. */
#include <string.h>

#include "../format/vector.h"
#include "copy_lines.h"

/* A line. Pixels get the unused bits `set`; those that then are `skip` stay as
 * they are, where `keyed`. */
struct run {
    uint8_t *to;
    const uint8_t *from;
    int32_t n;                /* pixels */
    int32_t to_bit, from_bit; /* of the first pixel, of its byte */
    uint32_t set, skip;
    bool keyed;
};

#define RUN copy8
#define WORD pel_word8
#define LANES pel_u8x16
#include "copy_word.inc"

#define RUN copy16
#define WORD pel_word16
#define LANES pel_u16x8
#include "copy_word.inc"

#define RUN copy32
#define WORD pel_word32
#define LANES pel_u32x4
#include "copy_word.inc"

/* Pixels of less than a byte, as many as lie in one byte of the destination at
 * a time. The high bit of a byte is the first; a key has one bit. */
static void copy_bits(const struct run *r, int32_t bits_each)
{
    int32_t to = r->to_bit, from = r->from_bit, n;
    for (const int32_t end = to + r->n * bits_each; to < end;
         to += n, from += n) {
        uint8_t *const p = r->to + to / 8;
        const uint8_t *const q = r->from + from / 8;
        n = pel_min(8 - (to & 7), end - to);
        uint32_t bits = (uint32_t)q[0] << 8;
        if ((from & 7) + n > 8)
            bits |= q[1];
        bits = bits << (from & 7) >> 8 & 0xFF;
        uint32_t mask = 0xFF00u >> n & 0xFF;
        if (r->keyed)
            mask &= r->skip ? ~bits : bits;
        *p = (uint8_t)((*p & ~(mask >> (to & 7))) | (bits & mask) >> (to & 7));
    }
}

static void copy_run(const struct run *r, int32_t bits)
{
    if (bits < 8)
        copy_bits(r, bits);
    else if (bits == 8)
        copy8(r);
    else if (bits == 16)
        copy16(r);
    else
        copy32(r);
}

/* How a format of a program's own keeps pixels is its own affair: with a key,
 * unused bits or shared bytes its functions are asked. */
static bool can_copy(const struct pel_format *f, bool keyed)
{
    if (f->id >= 128)
        return !keyed && f->bits % 8 == 0 && f->pack(0) == 0 &&
               f->pack(PEL_RGB(255, 255, 255)) == UINT32_MAX >> (32 - f->bits);
    if (f->id == PEL_FORMAT_MONO1_PAGES)
        return false;
    return !keyed || (f->bits != 4 && f->bits != 24);
}

bool pel_copy_same(const struct pel_surface *surface,
                   const struct pel_copy_part *copy, const pel_color *key)
{
    const struct pel_format *f = surface->format;
    const struct pel_surface *source = copy->source;
    struct pel_rect r;
    if (!pel_copy_visible(surface, copy, &r))
        return true;
    if (f->id != source->format->id || !can_copy(f, key != NULL))
        return false;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    const int32_t to = (r.x0 - surface->bounds.x0) * f->bits;
    const int32_t from = (r.x0 - dx - source->bounds.x0) * f->bits;
    struct run run = {NULL,     NULL,       r.x1 - r.x0, to & 7,
                      from & 7, f->pack(0), 0,           key};
    const bool whole = !key && f->bits >= 8 && run.set == 0;
    const size_t size = (size_t)(run.n * f->bits / 8);
    if (key)
        run.skip = f->pack(*key);
    for (int32_t y = r.y0; y < r.y1; y++) {
        run.to = (uint8_t *)pel_surface_line(surface, y) + to / 8;
        run.from = (uint8_t *)pel_surface_line(source, y - dy) + from / 8;
        if (whole)
            memcpy(run.to, run.from, size);
        else
            copy_run(&run, f->bits);
    }
    return true;
}
