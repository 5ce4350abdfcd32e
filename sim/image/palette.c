/* A palette by cuts at the mean, of the part with the largest error, and then
 * by means of the nearest (Heckbert 1982; Lloyd 1957). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/image/reduce.h"

enum {
    ROUNDS = 8,       /* of means */
    ENTRIES = 1 << 15 /* colours that they are found for */
};

struct entry {
    pel_color color;
    double count;
    int part;
};

struct part {
    double sum[4], square[4], count;
};

static double channel(pel_color c, int k)
{
    return c >> 8 * k & 255;
}

static pel_color mean_of(const struct part *part)
{
    pel_color color = 0;
    for (int k = 0; k < 4 && part->count > 0; k++)
        color |= (pel_color)(part->sum[k] / part->count + 0.5) << 8 * k;
    return color;
}

static int compare(const void *left, const void *right)
{
    const uint64_t a = *(const uint64_t *)left, b = *(const uint64_t *)right;
    return a < b ? -1 : a > b;
}

/* Of numbers in order, a group in the upper 32 bits and a colour in the lower
 * ones: the mean of each group. How many. */
static size_t group(const uint64_t *sorted, size_t n, struct entry *e)
{
    size_t count = 0;
    for (size_t i = 0; i < n; count++) {
        const uint64_t key = sorted[i] >> 32;
        struct part all = {.count = 0};
        for (; i < n && sorted[i] >> 32 == key; i++, all.count++)
            for (int k = 0; k < 4; k++)
                all.sum[k] += channel((pel_color)sorted[i], k);
        e[count] = (struct entry){mean_of(&all), all.count, 0};
    }
    return count;
}

/* The colours, each once and with its count; how many. Where they are more than
 * ENTRIES, those are one that differ in the lowest bits of red, green and blue
 * alone, in as many as it takes. */
static size_t count_colors(const struct picture *p, struct entry **entries)
{
    const size_t n = (size_t)p->width * (size_t)p->height;
    uint64_t *sorted = malloc(n * sizeof(*sorted));
    struct entry *e = malloc(n * sizeof(*e));
    size_t count = 0;
    *entries = e;
    for (int bits = 0;
         sorted && e && bits < 8 && (bits == 0 || count > ENTRIES); bits++) {
        const pel_color low = 0x010101u * ((1u << bits) - 1);
        for (size_t i = 0; i < n; i++) {
            const pel_color c = pel_alpha(p->pixels[i]) ? p->pixels[i] : 0;
            sorted[i] = (uint64_t)(c & ~low) << 32 | c;
        }
        qsort(sorted, n, sizeof(*sorted), compare);
        count = group(sorted, n, e);
    }
    free(sorted);
    return count;
}

static void measure(const struct entry *e, size_t n, struct part *part,
                    int parts)
{
    memset(part, 0, (size_t)parts * sizeof(*part));
    for (size_t i = 0; i < n; i++) {
        struct part *to = &part[e[i].part];
        to->count += e[i].count;
        for (int k = 0; k < 4; k++) {
            const double v = channel(e[i].color, k);
            to->sum[k] += v * e[i].count;
            to->square[k] += v * v * e[i].count;
        }
    }
}

/* The sum of squares around the mean of a channel. */
static double error_of(const struct part *part, int k)
{
    return part->count > 0
               ? part->square[k] - part->sum[k] * part->sum[k] / part->count
               : 0;
}

/* Cuts the part with the largest error of a channel; false: all have none. */
static bool cut(struct entry *e, size_t n, const struct part *part, int parts)
{
    int worst = 0, axis = 0;
    for (int i = 0; i < parts; i++)
        for (int k = 0; k < 4; k++)
            if (error_of(&part[i], k) > error_of(&part[worst], axis)) {
                worst = i;
                axis = k;
            }
    if (error_of(&part[worst], axis) < 0.5)
        return false;
    const double mean = part[worst].sum[axis] / part[worst].count;
    for (size_t i = 0; i < n; i++)
        if (e[i].part == worst && channel(e[i].color, axis) > mean)
            e[i].part = parts;
    return true;
}

static int distance(pel_color a, pel_color b)
{
    int sum = 0;
    for (int k = 0; k < 4; k++) {
        const int d = (int)(a >> 8 * k & 255) - (int)(b >> 8 * k & 255);
        sum += d * d;
    }
    return sum;
}

static int nearest(pel_color color, const pel_color *palette, int n)
{
    int best = 0, least = distance(color, palette[0]);
    for (int i = 1; i < n; i++) {
        const int d = distance(color, palette[i]);
        best = d < least ? i : best;
        least = d < least ? d : least;
    }
    return best;
}

int picture_palette(const struct picture *picture, int most,
                    pel_color palette[256])
{
    struct entry *e;
    struct part part[256];
    const size_t n = count_colors(picture, &e);
    int parts = 1;
    if (n == 0) {
        message_error("no memory for the colours of a picture");
        free(e);
        return 0;
    }
    measure(e, n, part, parts);
    while (parts < most && cut(e, n, part, parts))
        measure(e, n, part, ++parts);
    for (int round = 0; round < ROUNDS; round++) {
        for (int i = 0; i < parts; i++)
            if (part[i].count > 0)
                palette[i] = mean_of(&part[i]);
        for (size_t i = 0; i < n; i++)
            e[i].part = nearest(e[i].color, palette, parts);
        measure(e, n, part, parts);
    }
    free(e);
    return parts;
}
