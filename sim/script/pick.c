#include "sim/script/commands.h"

#include <string.h>

#include "core/format/word.h"

/* A format that keeps the colors that shapes bring, with their alpha, instead
 * of drawing them: a word each. */
enum { SPY_FORMAT = 200 };

static uint32_t spy_word(uint32_t word)
{
    return word;
}

static void spy_fill(const struct pel_spans *spans, uint32_t color)
{
    for (int32_t i = 0; i < spans->n; i++)
        for (int32_t x = spans->span[i].x0; x < spans->span[i].x1; x++)
            *pel_address32(spans->surface, x, spans->y + i * spans->step) =
                color;
}

static void spy_put(const struct pel_surface *s, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors)
{
    memcpy(pel_address32(s, x, y), colors, (size_t)n * sizeof(*colors));
}

static void spy_load(const struct pel_surface *s, int32_t x, int32_t y,
                     int32_t n, pel_color *colors)
{
    memcpy(colors, pel_address32(s, x, y), (size_t)n * sizeof(*colors));
}

static const struct pel_format spy = {.id = SPY_FORMAT,
                                      .bits = 32,
                                      .word = 4,
                                      .pack = spy_word,
                                      .unpack = spy_word,
                                      .fill = spy_fill,
                                      .blend = spy_fill,
                                      .put = spy_put,
                                      .load = spy_load};

bool script_clip_holds(const struct script_pen *pen, const int pixel[2])
{
    const struct pel_rect *r = &pen->clip;
    return pixel[0] >= r->x0 && pixel[0] < r->x1 && pixel[1] >= r->y0 &&
           pixel[1] < r->y1;
}

/* Drawn twice, onto different words: what it leaves, it leaves different. */
bool script_covers(const struct script_pen *pen, const struct script_item *item,
                   const int pixel[2], pel_color *color)
{
    const struct pel_rect bounds = {pixel[0], pixel[1], pixel[0] + 1,
                                    pixel[1] + 1};
    uint32_t word[2] = {0x00123456, 0x00654321};
    for (int i = 0; i < 2; i++) {
        struct pel_surface surface;
        struct script_pen own = *pen;
        own.surface = &surface;
        pel_surface_init(&surface, &spy, &word[i], sizeof word[i], &bounds);
        script_perform(&own, item);
    }
    *color = word[0];
    return word[0] == word[1];
}

/* In white on black. */
uint32_t script_coverage(const struct script_pen *pen,
                         const struct script_item *item, const int pixel[2])
{
    const struct pel_rect bounds = {pixel[0], pixel[1], pixel[0] + 1,
                                    pixel[1] + 1};
    struct pel_surface surface;
    struct script_pen own = *pen;
    uint8_t coverage = 0;
    own.surface = &surface;
    own.paint = NULL;
    own.dither = false;
    pel_surface_init(&surface, &pel_gray8, &coverage, 1, &bounds);
    script_perform(&own, item);
    return coverage;
}

/* By the rule of centres, smooth shapes too. */
long script_pick(const struct script *script, int x, int y)
{
    long found = -1;
    pel_color color;
    struct script_pen pen;
    uint32_t word;
    struct pel_surface surface;
    const int at[2] = {x, y};
    const struct pel_rect pixel = {x, y, x + 1, y + 1};
    pel_surface_init(&surface, &spy, &word, sizeof word, &pixel);
    if (!script_pen_init(&pen, script, &surface))
        return -1;
    for (size_t i = 0; i < script->item_count; i++) {
        const struct script_item *item = &script->items[i];
        const enum script_role role = item->command->role;
        if (role < SCRIPT_CLEAR)
            script_perform(&pen, item);
        pen.smooth = false;
        if (role > SCRIPT_WHOLE && script_clip_holds(&pen, at) &&
            script_covers(&pen, item, at, &color) && pel_alpha(color) > 0)
            found = (long)i;
    }
    script_pen_free(&pen);
    return found;
}
