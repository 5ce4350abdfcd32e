#include "sim/font/points.h"

#include <stdlib.h>

#include "sim/cli/list.h"

static void put(struct font_points *p, int byte)
{
    const uint8_t value = (uint8_t)byte;
    p->failed = p->failed || !list_add(&p->bytes, &p->size, &value, 1);
}

static int size_of(int move)
{
    return move == 0                 ? 0
           : move > 0 && move < 256  ? 1
           : move < 0 && move > -256 ? 2
                                     : 3;
}

static void put_move(struct font_points *p, int move)
{
    const int size = size_of(move);
    if (size > 0)
        put(p, size == 2 ? -move : move);
    if (size == 3)
        put(p, move >> 8);
}

static bool is_legal(int x)
{
    return x >= INT16_MIN && x <= INT16_MAX;
}

void font_points_add(struct font_points *p, int kind, int x, int y)
{
    const int dx = x - p->x, dy = y - p->y;
    put(p, kind | size_of(dx) << 2 | size_of(dy) << 4);
    put_move(p, dx);
    put_move(p, dy);
    p->beyond = p->beyond || !is_legal(x) || !is_legal(y);
    p->x = x;
    p->y = y;
    p->box[0] = x < p->box[0] ? x : p->box[0];
    p->box[1] = y < p->box[1] ? y : p->box[1];
    p->box[2] = x > p->box[2] ? x : p->box[2];
    p->box[3] = y > p->box[3] ? y : p->box[3];
}

bool font_points_keep(struct font *font, const struct font_char *glyph,
                      const struct font_points *p)
{
    struct font_char c = *glyph;
    c.offset = font->size;
    c.bytes = p->size;
    for (int i = 0; i < 2; i++) {
        font->box[i] = p->box[i] < font->box[i] ? p->box[i] : font->box[i];
        font->box[i + 2] =
            p->box[i + 2] > font->box[i + 2] ? p->box[i + 2] : font->box[i + 2];
    }
    uint8_t *bits =
        p->failed ? NULL : realloc(font->bits, c.offset + c.bytes + 1);
    if (!bits)
        return message_error("out of memory");
    font->bits = bits;
    font->size += c.bytes;
    if (c.bytes > 0)
        memcpy(bits + c.offset, p->bytes, c.bytes);
    return list_add(&font->chars, &font->count, &c, sizeof c);
}
