/* A palette by cuts at the mean, of the part with the largest error, and then
 * by means of the nearest (Heckbert 1982; Lloyd 1957). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/image/reduce.h"

enum { ROUNDS = 8 }; /* of means */

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

static int compare(const void *left, const void *right)
{
    const pel_color a = *(const pel_color *)left, b = *(const pel_color *)right;
    return a < b ? -1 : a > b;
}

/* The colours, each once and with its count; how many. */
static size_t count_colors(const struct picture *p, struct entry **entries)
{
    const size_t n = (size_t)p->width * (size_t)p->height;
    pel_color *sorted = malloc(n * sizeof(*sorted));
    struct entry *e = malloc(n * sizeof(*e));
    size_t count = 0;
    *entries = e;
    for (size_t i = 0; sorted && i < n; i++)
        sorted[i] = pel_alpha(p->pixels[i]) ? p->pixels[i] : 0;
    if (sorted)
        qsort(sorted, n, sizeof(*sorted), compare);
    for (size_t i = 0; sorted && e && i < n; i++) {
        if (count == 0 || e[count - 1].color != sorted[i])
            e[count++] = (struct entry){sorted[i], 0, 0};
        e[count - 1].count++;
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

static pel_color mean_of(const struct part *part)
{
    pel_color color = 0;
    for (int k = 0; k < 4 && part->count > 0; k++)
        color |= (pel_color)(part->sum[k] / part->count + 0.5) << 8 * k;
    return color;
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
    if (n == 0)
        message_error("no memory for the colours of a picture");
    measure(e, n, part, parts);
    while (n > 0 && parts < most && cut(e, n, part, parts))
        measure(e, n, part, ++parts);
    for (int round = 0; n > 0 && round < ROUNDS; round++) {
        for (int i = 0; i < parts; i++)
            if (part[i].count > 0)
                palette[i] = mean_of(&part[i]);
        for (size_t i = 0; i < n; i++)
            e[i].part = nearest(e[i].color, palette, parts);
        measure(e, n, part, parts);
    }
    free(e);
    return n > 0 ? parts : 0;
}
