#include "panel_scroll.h"

#include "panel_chip.h"

enum { MADCTL = 0x36, MY = 0x80 }; /* rows of memory run back */

static const struct pel_panel *panel_of(const struct pel_panel_scroll *scroll)
{
    return scroll->display->context;
}

static bool runs_back(const struct pel_panel *panel)
{
    return panel->chip->turn[panel->rotation & 3][1] & MY;
}

/* The first line of memory that scrolls. */
static int32_t top_of(const struct pel_panel_scroll *scroll)
{
    const struct pel_panel *const panel = panel_of(scroll);
    const int32_t first = panel->from[1];
    return runs_back(panel) ? panel->chip->height - first - scroll->to
                            : first + scroll->from;
}

static void put16(uint8_t *to, int32_t value)
{
    to[0] = (uint8_t)(value >> 8);
    to[1] = (uint8_t)value;
}

/* Which line of memory the first one on the glass shows. */
static enum pel_status send_start(const struct pel_panel_scroll *scroll)
{
    const struct pel_panel *const panel = panel_of(scroll);
    const int32_t lines = scroll->to - scroll->from;
    int32_t at = scroll->at;
    uint8_t list[] = {3, 0x37, 0, 0, 0};
    if (runs_back(panel) && at)
        at = lines - at;
    put16(list + 2, top_of(scroll) + at);
    return panel->chip->command(panel, list);
}

/* The part of the clip that is in lines from..to - 1, moved by so many lines.
 */
static enum pel_status flush_part(const struct pel_panel_scroll *scroll,
                                  const struct pel_surface *surface,
                                  const int32_t lines[2], int32_t move)
{
    const bool turned = panel_of(scroll)->rotation & 1;
    struct pel_surface part = *surface;
    struct pel_rect *const c = &part.clip, *const b = &part.bounds;
    int32_t *const from = turned ? &c->x0 : &c->y0;
    int32_t *const to = turned ? &c->x1 : &c->y1;
    *from = pel_max(*from, lines[0]);
    *to = pel_min(*to, lines[1]);
    if (*from >= *to)
        return PEL_OK;
    *from += move;
    *to += move;
    *(turned ? &b->x0 : &b->y0) += move;
    *(turned ? &b->x1 : &b->y1) += move;
    return pel_display_flush(scroll->display, &part);
}

/* Line k of those that scroll is at line (k + at) mod their number of memory:
 * so in two parts, beside the ones that do not. */
static enum pel_status scroll_flush(const struct pel_display *rolling,
                                    const struct pel_surface *surface)
{
    const struct pel_panel_scroll *const s = rolling->context;
    const int32_t wraps = s->to - s->at, lines = s->to - s->from;
    const int32_t part[4][2] = {{INT32_MIN, s->from},
                                {s->from, wraps},
                                {wraps, s->to},
                                {s->to, INT32_MAX}};
    const int32_t move[4] = {0, s->at, s->at - lines, 0};
    const struct pel_rect *const c = &surface->clip;
    enum pel_status status = PEL_OK;
    if (surface->format->id == rolling->format->id &&
        ((c->x0 | c->y0) < 0 || c->x1 > rolling->width ||
         c->y1 > rolling->height))
        return pel_display_flush(s->display, surface); /* its error */
    for (int i = 0; i < 4 && status == PEL_OK; i++)
        status = flush_part(s, surface, part[i], move[i]);
    return status;
}

static enum pel_status scroll_wait(const struct pel_display *rolling)
{
    const struct pel_panel_scroll *const scroll = rolling->context;
    return pel_display_wait(scroll->display);
}

enum pel_status pel_panel_scroll_by(struct pel_panel_scroll *scroll, int32_t n)
{
    const int32_t lines = scroll->to - scroll->from;
    const int32_t before = scroll->at, at = (before + n % lines) % lines;
    scroll->at = at < 0 ? at + lines : at;
    const enum pel_status status = send_start(scroll);
    if (status != PEL_OK)
        scroll->at = before;
    return status;
}

enum pel_status pel_panel_scroll_init(struct pel_display *rolling,
                                      struct pel_panel_scroll *scroll,
                                      const struct pel_display *display,
                                      int32_t from, int32_t to)
{
    if (!rolling || !scroll || !display)
        return PEL_ERROR_NULL;
    const struct pel_panel *const panel = display->context;
    const bool turned = panel->rotation & 1;
    if (panel->chip->turn[0][0] != MADCTL)
        return PEL_ERROR_FORMAT;
    if (from < 0 || from >= to ||
        to > (turned ? display->width : display->height))
        return PEL_ERROR_SIZE;
    *scroll = (struct pel_panel_scroll){display, from, to, 0};
    *rolling = *display;
    rolling->context = scroll;
    rolling->flush = scroll_flush;
    rolling->wait = scroll_wait;
    const int32_t top = top_of(scroll), lines = to - from;
    uint8_t list[] = {7, 0x33, 0, 0, 0, 0, 0, 0, 0};
    put16(list + 2, top);
    put16(list + 4, lines);
    put16(list + 6, panel->chip->height - top - lines);
    const enum pel_status status = panel->chip->command(panel, list);
    return status == PEL_OK ? send_start(scroll) : status;
}
