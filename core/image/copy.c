#include "copy.h"

#include <string.h>

#include "../format/vector.h"
#include "../format/word.h"
#include "../raster/paint.h"

static bool copy_legal(const struct pel_copy_part *c)
{
    return pel_offset_legal(c->area.x0, c->area.y0) &&
           pel_offset_legal(c->area.x1, c->area.y1) &&
           pel_offset_legal(c->x, c->y);
}

/* The pixels of the destination that are copied to. False: none. */
static bool visible_part(const struct pel_surface *surface,
                         const struct pel_copy_part *copy,
                         struct pel_rect *visible)
{
    PEL_ASSERT(copy_legal(copy));
    if (!copy_legal(copy))
        return false;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    struct pel_rect r = pel_rect_intersect(&copy->area, &copy->source->bounds);
    if (pel_rect_empty(&r))
        return false;
    r = (struct pel_rect){r.x0 + dx, r.y0 + dy, r.x1 + dx, r.y1 + dy};
    *visible = pel_rect_intersect(&r, &surface->clip);
    return !pel_rect_empty(visible);
}

/* Where pixels are read before they are written, their cache lines are asked
 * for some rows ahead: stores retire in order, so each miss would wait for the
 * one before it. Short spans wait for a line or two, which takes less time than
 * asking. */
static PEL_ALWAYS_INLINE void ask_ahead(const struct pel_surface *s,
                                        const struct pel_rect *r, int32_t y)
{
    const int32_t bits = s->format->bits, bytes = (r->x1 - r->x0) * bits / 8;
    const uintptr_t row =
        (uintptr_t)(y + PEL_ROWS_AHEAD - s->bounds.y0) * (uintptr_t)s->stride;
    const uintptr_t column = (uintptr_t)((r->x0 - s->bounds.x0) * bits / 8);
    if (PEL_64BIT && bytes > 128)
        for (int32_t i = 0; i < bytes; i += 64)
            pel_prefetch((uintptr_t)s->pixels + row + column + (uintptr_t)i);
}

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
    else if (PEL_VECTORS && !r->keyed)
        pel_copy32((void *)r->to, (const void *)r->from, r->n, r->set);
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

/* Copies pixels as they lie in memory, but for those of the key unless it is
 * NULL. False: the formats do not allow it, and nothing is done. */
static bool copy_same(const struct pel_surface *surface,
                      const struct pel_copy_part *copy, const pel_color *key)
{
    const struct pel_format *f = surface->format;
    const struct pel_surface *source = copy->source;
    struct pel_rect r;
    if (!visible_part(surface, copy, &r))
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
    run.to = pel_surface_line(surface, r.y0) + to / 8;
    run.from = pel_surface_line(source, r.y0 - dy) + from / 8;
    for (int32_t y = r.y0;;) {
        if (key)
            ask_ahead(surface, &r, y);
        if (whole)
            memcpy(run.to, run.from, size);
        else
            copy_run(&run, f->bits);
        if (++y == r.y1)
            return true;
        run.to += surface->stride;
        run.from += source->stride;
    }
}

/* Gives n colors of the source the alpha with which they are put. */
typedef void weigh_colors(pel_color *colors, int32_t n, uint32_t option);

/* Copies through colors, piece by piece. weigh NULL: they have their alpha. */
static void copy_colors(const struct pel_surface *surface,
                        const struct pel_copy_part *copy, weigh_colors *weigh,
                        uint32_t option)
{
    const struct pel_surface *source = copy->source;
    pel_color colors[PEL_BUFFER_PIXELS];
    struct pel_rect r;
    if (!visible_part(surface, copy, &r))
        return;
    PEL_ASSERT(source->format->load && surface->format->put);
    if (!source->format->load || !surface->format->put)
        return;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    const bool in_place = !weigh && source->format->id == PEL_FORMAT_ARGB8888 &&
                          PEL_LE32(UINT32_C(1)) == 1;
    for (int32_t y = r.y0; y < r.y1; y++) {
        ask_ahead(surface, &r, y);
        for (int32_t x = r.x0, n; x < r.x1; x += n) {
            n = in_place ? r.x1 - x : pel_min(r.x1 - x, PEL_BUFFER_PIXELS);
            const pel_color *from = colors;
            if (in_place)
                from = pel_address32(source, x - dx, y - dy);
            else
                source->format->load(source, x - dx, y - dy, n, colors);
            if (weigh)
                weigh(colors, n, option);
            surface->format->put(surface, x, y, n, from);
        }
    }
}

static void make_opaque(pel_color *colors, int32_t n, uint32_t option)
{
    (void)option;
    for (int32_t i = 0; i < n; i++)
        colors[i] |= PEL_RGB(0, 0, 0);
}

void pel_copy(const struct pel_surface *surface,
              const struct pel_copy_part *copy)
{
    if (!copy_same(surface, copy, NULL))
        copy_colors(surface, copy, make_opaque, 0);
}

static void drop_key(pel_color *colors, int32_t n, uint32_t key)
{
    for (int32_t i = 0; i < n; i++)
        colors[i] =
            colors[i] << 8 == key << 8 ? 0 : colors[i] | PEL_RGB(0, 0, 0);
}

void pel_copy_keyed(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, pel_color key)
{
    const struct pel_format *format = copy->source->format;
    if (!format || !surface->format || !format->load || !surface->format->put)
        copy_colors(surface, copy, drop_key, key); /* copies nothing */
    else if (!copy_same(surface, copy, &key))
        copy_colors(surface, copy, drop_key, format->unpack(format->pack(key)));
}

static void weigh(pel_color *colors, int32_t n, uint32_t alpha)
{
    for (int32_t i = 0; i < n; i++) {
        uint32_t weight = pel_round_div255(pel_alpha(colors[i]) * alpha);
        colors[i] = (colors[i] & UINT32_C(0xFFFFFF)) | weight << 24;
    }
}

void pel_copy_alpha(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, uint8_t alpha)
{
    copy_colors(surface, copy, alpha < 255 ? weigh : NULL, alpha);
}
