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
static PEL_ALWAYS_INLINE void ask_ahead(uintptr_t row, ptrdiff_t stride,
                                        size_t bytes)
{
    row += PEL_ROWS_AHEAD * (uintptr_t)stride;
    if (PEL_64BIT && bytes > 128)
        for (size_t i = 0; i < bytes; i += 64)
            pel_prefetch(row + i);
}

/* Lines of n pixels, which get the unused bits `set`. One that is `skip` then
 * is not copied. Without a key that is 0, and no pixel is: copy8 to copy32 are
 * taken only where `set` is not 0. */
struct run {
    ptrdiff_t to_stride, from_stride;
    int32_t rows, n;
    int32_t bits, to_bit, from_bit; /* of a pixel; the first one, of its byte */
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
static void copy_bits(const struct run *r, uint8_t *to_line,
                      const uint8_t *from_line)
{
    int32_t to = r->to_bit, from = r->from_bit, n;
    for (const int32_t end = to + r->n * r->bits; to < end;
         to += n, from += n) {
        uint8_t *const p = to_line + to / 8;
        const uint8_t *const q = from_line + from / 8;
        n = pel_min(8 - (to & 7), end - to);
        uint32_t bits = (uint32_t)q[0] << 8;
        if ((from & 7) + n > 8)
            bits |= q[1];
        bits = bits << (from & 7) >> 8 & 0xFF;
        uint32_t mask = 0xFF00u >> n & 0xFF;
        if (r->keyed)
            mask &= bits ^ (r->skip ? 0xFF : 0);
        *p = (uint8_t)((*p & ~(mask >> (to & 7))) | (bits & mask) >> (to & 7));
    }
}

static void copy_run(const struct run *r, uint8_t *to, const uint8_t *from)
{
    if (r->bits < 8)
        copy_bits(r, to, from);
    else if (r->bits == 8)
        copy8(r, to, from);
    else if (r->bits == 16)
        copy16(r, (void *)to, (const void *)from);
    else
        copy32(r, (void *)to, (const void *)from);
}

/* By memcpy; by pel_copy32, without a key; by copy_run. */
enum method { AS_THEY_ARE, SET_32, BY_RUNS };

/* The method is a constant, and addresses are no members of the run: then they
 * are in registers, and no line waits for the address of the one before it. */
static PEL_ALWAYS_INLINE void copy_lines(const struct run *r, uint8_t *to,
                                         const uint8_t *from,
                                         enum method method)
{
    const ptrdiff_t down = r->to_stride, from_down = r->from_stride;
    const size_t size = (size_t)(r->n * r->bits) / 8;
    for (int32_t rows = r->rows;; to += down, from += from_down) {
        if (method == BY_RUNS && r->keyed)
            ask_ahead((uintptr_t)to, down, size);
        if (method == AS_THEY_ARE)
            memcpy(to, from, size);
        else if (PEL_VECTORS && method == SET_32)
            pel_copy32((void *)to, (const void *)from, r->n, r->set);
        else
            copy_run(r, to, from);
        if (--rows == 0)
            return;
    }
}

/* May this file read and write the pixels itself? It knows where those of Pel's
 * formats lie. Of a program's own format it copies whole bytes, if all their
 * bits are color and there is no key; else the format's functions do it. */
static bool can_copy(const struct pel_format *f, bool keyed)
{
    if (f->id > PEL_FORMAT_PALETTE8)
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
    const int32_t to_bit = (r.x0 - surface->bounds.x0) * f->bits;
    const int32_t from_bit = (r.x0 - dx - source->bounds.x0) * f->bits;
    const uint32_t set = f->pack(0), skip = key ? f->pack(*key) : 0;
    const struct run run = {
        surface->stride, source->stride, r.y1 - r.y0, r.x1 - r.x0, f->bits,
        to_bit & 7,      from_bit & 7,   set,         skip,        key};
    uint8_t *to = pel_surface_line(surface, r.y0) + to_bit / 8;
    const uint8_t *from = pel_surface_line(source, r.y0 - dy) + from_bit / 8;
    if (!key && f->bits >= 8 && set == 0)
        copy_lines(&run, to, from, AS_THEY_ARE);
    else if (PEL_VECTORS && !key && f->bits == 32)
        copy_lines(&run, to, from, SET_32);
    else
        copy_lines(&run, to, from, BY_RUNS);
    return true;
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
    const int32_t bits = surface->format->bits;
    const size_t bytes = (size_t)((r.x1 - r.x0) * bits) / 8;
    const int32_t column = (r.x0 - surface->bounds.x0) * bits / 8;
    uintptr_t row =
        (uintptr_t)pel_surface_line(surface, r.y0) + (uintptr_t)column;
    for (int32_t y = r.y0; y < r.y1; y++, row += (uintptr_t)surface->stride) {
        ask_ahead(row, surface->stride, bytes);
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

/* Copies colors as they lie in memory to 5-6-5 bits. False: it is another copy.
 */
static bool copy_packed(const struct pel_surface *surface,
                        const struct pel_copy_part *copy)
{
    const struct pel_surface *source = copy->source;
    const struct pel_format *to = surface->format, *from = source->format;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    struct pel_rect r;
    if (to->id > PEL_FORMAT_BGR565_LE ||
        (from->id != PEL_FORMAT_XRGB8888 && from->id != PEL_FORMAT_ARGB8888) ||
        !visible_part(surface, copy, &r))
        return false;
    for (int32_t y = r.y0; PEL_VECTORS && y < r.y1; y++)
        pel_pack565(to, pel_address16(surface, r.x0, y), r.x1 - r.x0,
                    pel_address32(source, r.x0 - dx, y - dy));
    return true;
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
    if (copy_same(surface, copy, NULL) ||
        (PEL_VECTORS && copy_packed(surface, copy)))
        return;
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
    for (int32_t i = 0; i < n; i++)
        colors[i] = pel_weighed(colors[i], alpha);
}

void pel_copy_alpha(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, uint8_t alpha)
{
    copy_colors(surface, copy, alpha < 255 ? weigh : NULL, alpha);
}
