#include "sim/image/runs.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

/* A row: its pixels in memory, and what is made of them. */
struct row {
    const uint8_t *from;
    uint8_t *to;
    int n, bits;  /* words of `from`; bits of a pixel */
    size_t bytes; /* of a word */
    int most;     /* words that one word counts */
    size_t size;  /* words of `to` */
};

static bool are_equal(const struct row *r, int a, int b)
{
    return memcmp(r->from + (size_t)a * r->bytes,
                  r->from + (size_t)b * r->bytes, r->bytes) == 0;
}

/* The words of the run that begins at word `at`: 1 where there is none. All
 * pixels of a byte are equal then. */
static int run_at(const struct row *r, int at)
{
    const unsigned first = r->from[at];
    int n = 1;
    if (r->bits < 8 && first % (0xFFu / ((1u << r->bits) - 1)) != 0)
        return 1;
    while (n < r->most && at + n < r->n && are_equal(r, at, at + n))
        n++;
    return n;
}

static void put(struct row *r, int at, int count, bool is_run)
{
    const size_t n = is_run ? 1 : (size_t)count;
    const unsigned word = 2 * (unsigned)count + is_run;
    uint8_t *to = r->to + r->size * r->bytes;
    memset(to, 0, r->bytes);
    to[0] = (uint8_t)word;
    if (r->bytes > 1)
        to[1] = (uint8_t)(word >> 8);
    memcpy(to + r->bytes, r->from + (size_t)at * r->bytes, n * r->bytes);
    r->size += n + 1;
}

/* From 3 words on a run takes no more than they as they are, whatever lies
 * beside it; 2 do between runs. */
static void encode(struct row *r)
{
    int begin = 0; /* of words as they are, which end at `at` */
    for (int at = 0, n; at < r->n; at += n) {
        n = run_at(r, at);
        const int next = at + n;
        const bool alone = begin == at && (next == r->n || run_at(r, next) > 1);
        const bool is_run = n >= (alone ? 2 : 3);
        for (; begin < at && (is_run || next - begin > r->most); begin = at)
            put(r, begin, at - begin, false);
        if (is_run) {
            put(r, at, n, true);
            begin = next;
        }
    }
    if (begin < r->n)
        put(r, begin, r->n - begin, false);
}

/* Gives the bits behind the last pixel of a row the value of that pixel, so
 * that its last byte may belong to a run. */
static void fill_up(uint8_t *row, int width, int bits)
{
    uint8_t *const last = row + width * bits / 8;
    for (int bit = width * bits % 8; bit > 0 && bit < 8; bit++) {
        const unsigned value = (unsigned)*last >> (7 - bit + bits) & 1u;
        *last = (uint8_t)((*last & ~(0x80u >> bit)) | value << (7 - bit));
    }
}

static uint32_t hash_of(const uint8_t *bytes, size_t n)
{
    uint32_t hash = 2166136261u;
    while (n-- > 0)
        hash = (hash ^ *bytes++) * 16777619u;
    return hash;
}

/* Encodes row y behind the words, which have room for it, unless an earlier one
 * is equal. */
static void add(struct runs *runs, struct row *r, uint32_t *hash, int y)
{
    const uint8_t *const words = runs->words;
    int i = 0;
    r->size = 0;
    r->to = runs->words + runs->size * runs->bytes;
    encode(r);
    const size_t bytes = r->size * r->bytes;
    hash[y] = hash_of(r->to, bytes);
    while (i < y &&
           (hash[i] != hash[y] ||
            memcmp(words + runs->rows[i] * r->bytes, r->to, bytes) != 0))
        i++;
    runs->rows[y] = i < y ? runs->rows[i] : runs->size;
    runs->size += i < y ? 0 : (uint32_t)r->size;
}

bool runs_make(struct runs *runs, const struct pel_surface *surface)
{
    const struct pel_format *f = surface->format;
    const int width = surface->bounds.x1, height = surface->bounds.y1;
    struct row r = {.bits = f->bits, .bytes = f->bits < 8 ? 1 : f->bits / 8u};
    r.n = (int)((size_t)surface->stride / r.bytes);
    r.most = r.bytes > 1 ? 32767 : 127;
    /* A word that counts is followed by one at least. */
    *runs = (struct runs){
        .bytes = r.bytes,
        .words = malloc(2 * (size_t)surface->stride * (size_t)height),
        .rows = calloc((size_t)height, sizeof *runs->rows)};
    uint32_t *hash = calloc((size_t)height, sizeof *hash);
    const bool done = runs->words && runs->rows && hash;
    for (int y = 0; y < height && done; y++) {
        uint8_t *row = pel_surface_line(surface, y);
        fill_up(row, width, r.bits);
        r.from = row;
        add(runs, &r, hash, y);
    }
    free(hash);
    return done || message_error("out of memory");
}

void runs_free(struct runs *runs)
{
    free(runs->words);
    free(runs->rows);
}
