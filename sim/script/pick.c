#include "sim/script/commands.h"

/* A format that keeps the color that shapes bring, with its alpha, instead of
 * drawing it. Its surface has one pixel, a struct spy. */
enum { SPY_FORMAT = 200 };

struct spy {
    pel_color color; /* at first what is below */
    bool covered;
};

static uint32_t spy_word(uint32_t word)
{
    return word;
}

static void spy_put(const struct pel_surface *s, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors)
{
    (void)x;
    (void)y;
    if (n > 0)
        *(struct spy *)s->pixels = (struct spy){*colors, true};
}

static void spy_fill(const struct pel_spans *spans, uint32_t color)
{
    for (int32_t i = 0; i < spans->n; i++)
        spy_put(spans->surface, 0, 0, spans->span[i].x1 - spans->span[i].x0,
                &color);
}

static void spy_load(const struct pel_surface *s, int32_t x, int32_t y,
                     int32_t n, pel_color *colors)
{
    (void)x;
    (void)y;
    (void)n;
    *colors = ((const struct spy *)s->pixels)->color;
}

static const struct pel_format spy_format = {.id = SPY_FORMAT,
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

bool script_covers(const struct script_pen *pen, const struct script_item *item,
                   const int pixel[2], pel_color *color)
{
    const struct pel_rect area = {pixel[0], pixel[1], pixel[0] + 1,
                                  pixel[1] + 1};
    struct spy spy = {.color = *color};
    struct pel_surface surface = {&spy, 0, area, area, &spy_format};
    struct script_pen own = *pen;
    own.surface = &surface;
    script_perform(&own, item);
    *color = spy.color;
    return spy.covered;
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
    own.blend = 0;
    own.dither = false;
    pel_surface_init(&surface, &pel_gray8, &coverage, 1, &bounds);
    script_perform(&own, item);
    return coverage;
}

/* By the rule of centres, smooth shapes too. */
long script_pick(const struct script *script, int x, int y)
{
    long found = -1;
    struct script_pen pen;
    const struct pel_rect pixel = {x, y, x + 1, y + 1};
    struct pel_surface none = {NULL, 0, pixel, pixel, NULL};
    const int at[2] = {x, y};
    if (!script_pen_init(&pen, script, &none))
        return -1;
    for (size_t i = 0; i < script->item_count; i++) {
        const struct script_item *item = &script->items[i];
        const enum script_role role = item->command->role;
        pel_color color = 0;
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
