/* Pixels whose channels are fields of bits. Constants of a format fold into
 * shifts and masks. */
#ifndef PEL_FORMAT_FIELDS_H
#define PEL_FORMAT_FIELDS_H

#include "word.h"

struct pel_field {
    int shift, bits; /* the lowest bit, and how many */
};

struct pel_fields {
    struct pel_field red, green, blue;
    uint32_t unused; /* X bits */
};

/* 8 bits to the field's. */
static PEL_ALWAYS_INLINE uint32_t pel_field_pack(struct pel_field f,
                                                 uint32_t channel)
{
    return channel >> (8 - f.bits) << f.shift;
}

/* The field's bits to 8. Two shifts: a mask would take a register. */
static PEL_ALWAYS_INLINE uint32_t pel_field_unpack(struct pel_field f,
                                                   uint32_t pixel)
{
    const uint32_t bits = pixel << (32 - f.shift - f.bits) >> (32 - f.bits);
    return pel_widen(bits, f.bits);
}

/* The channel s, premultiplied, over the field. */
static PEL_ALWAYS_INLINE uint32_t pel_field_over(struct pel_field f,
                                                 uint32_t pixel, uint32_t s,
                                                 uint32_t rest)
{
    const uint32_t d = pel_field_unpack(f, pixel);
    return pel_channel_over(d, s, rest, f.bits) << f.shift;
}

static PEL_ALWAYS_INLINE uint32_t pel_fields_pack(const struct pel_fields *f,
                                                  pel_color c)
{
    return f->unused | pel_field_pack(f->red, pel_red(c)) |
           pel_field_pack(f->green, pel_green(c)) |
           pel_field_pack(f->blue, pel_blue(c));
}

static PEL_ALWAYS_INLINE pel_color pel_fields_unpack(const struct pel_fields *f,
                                                     uint32_t pixel)
{
    return PEL_RGB(pel_field_unpack(f->red, pixel),
                   pel_field_unpack(f->green, pixel),
                   pel_field_unpack(f->blue, pixel));
}

static PEL_ALWAYS_INLINE uint32_t
pel_fields_over(const struct pel_fields *f, uint32_t pixel,
                const struct pel_premultiplied *s)
{
    return f->unused | pel_field_over(f->red, pixel, s->red, s->rest) |
           pel_field_over(f->green, pixel, s->green, s->rest) |
           pel_field_over(f->blue, pixel, s->blue, s->rest);
}

#endif
