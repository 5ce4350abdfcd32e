#include "epaper_chip.h"

#include <string.h>

enum { MOST_MS = 60000, POLL_MS = 10 };

/* STALE: what the chip compares with is not what the glass shows. */
enum { READY, STALE, ASLEEP };

bool pel_epaper_busy(const struct pel_epaper *paper)
{
    return paper->busy(paper) == paper->chip->busy;
}

static enum pel_status wait(const struct pel_epaper *paper)
{
    for (int32_t ms = 0; ms < MOST_MS; ms += POLL_MS) {
        enum pel_status status = paper->bus->pause(paper->bus, false, POLL_MS);
        if (status != PEL_OK || !pel_epaper_busy(paper))
            return status;
    }
    return PEL_ERROR_DEVICE;
}

/* Nothing, if something has failed before. None of the list is in flight in the
 * end. */
static enum pel_status send(const struct pel_epaper *paper,
                            enum pel_status status, const uint8_t *list)
{
    const struct pel_bus *bus = paper->bus;
    const uint8_t *plane = paper->frame;
    for (; *list && status == PEL_OK; list++) {
        struct pel_bus_rows rows = {plane, paper->size, 1, 0};
        if (*list == PEL_EPAPER_WAIT) {
            status = wait(paper);
            continue;
        }
        if (*list == PEL_EPAPER_PLANE) {
            plane += paper->size;
        } else {
            status = bus->command(bus, list + 1, 1, NULL, 0);
            rows.bytes = list + 2;
            rows.length = *list - 1;
            list += *list;
        }
        if (status == PEL_OK && rows.length)
            status = bus->data(bus, &rows);
    }
    return status == PEL_OK && bus->wait ? bus->wait(bus) : status;
}

/* Ready for pixels. The frame is what the glass shows while nothing was flushed
 * since the last refresh; the chip compares the next picture with it. */
static enum pel_status ready(struct pel_epaper *paper)
{
    uint8_t list[PEL_EPAPER_LIST];
    enum pel_status status;
    if (paper->state == ASLEEP) {
        status = paper->bus->pause(paper->bus, true, 2 * POLL_MS);
        paper->chip->size(paper, list);
        status = send(paper, status, paper->kind->setup);
        status = send(paper, status, list);
    } else {
        status = wait(paper);
    }
    if (paper->state)
        status = send(paper, status, paper->kind->keep);
    if (status == PEL_OK)
        paper->state = READY;
    return status;
}

/* The number of the display's pixel (x, y). */
static uint32_t place(const struct pel_epaper *paper, uint32_t x, uint32_t y)
{
    const uint32_t right = paper->width - 1u, below = paper->height - 1u;
    if (paper->rotation & 1) {
        const uint32_t before = x;
        x = right - y;
        y = before;
    }
    if (paper->rotation & 2) {
        x = right - x;
        y = below - y;
    }
    return y * (right / 8 + 1) * 8 + x;
}

/* Pixel number `at` of the glass, whose rows are whole bytes. */
static PEL_NOINLINE void put(const struct pel_epaper *paper, uint32_t at,
                             pel_color color)
{
    const struct pel_format *const format = paper->format;
    uint32_t planes = paper->kind->planes >> 2 * format->pack(color);
    uint8_t *byte = paper->frame + (at >> 3);
    for (uint32_t i = format->bits; i > 0; i--) {
        const uint32_t mask = 0x80u >> (at & 7);
        *byte = (uint8_t)(*byte | mask);
        if (!(planes & 1))
            *byte = (uint8_t)(*byte - mask);
        byte += paper->size;
        planes >>= 1;
    }
}

static enum pel_status epaper_flush(const struct pel_display *display,
                                    const struct pel_surface *surface)
{
    struct pel_epaper *paper = display->context;
    const struct pel_rect *a = &surface->clip;
    if (pel_rect_empty(a))
        return PEL_OK;
    if (surface->format->id != display->format->id)
        return PEL_ERROR_FORMAT;
    if ((a->x0 | a->y0) < 0 || a->x1 > display->width ||
        a->y1 > display->height)
        return PEL_ERROR_SIZE;
    const enum pel_status status = paper->state ? ready(paper) : PEL_OK;
    for (int32_t y = a->y0; y < a->y1 && status == PEL_OK; y++)
        for (int32_t x = a->x0; x < a->x1; x++) {
            pel_color color;
            surface->format->load(surface, x, y, 1, &color);
            put(paper, place(paper, (uint32_t)x, (uint32_t)y), color);
        }
    return status;
}

static enum pel_status epaper_flip(const struct pel_display *display)
{
    struct pel_epaper *paper = display->context;
    const uint32_t how = paper->refresh, most = paper->kind->most;
    if (how > most)
        return PEL_ERROR_RANGE;
    enum pel_status status = ready(paper);
    status = send(paper, status, paper->kind->show);
    if (paper->waveform && (how || !most))
        status = send(paper, status, paper->waveform);
    status = send(paper, status, paper->chip->refresh[how]);
    if (status == PEL_OK)
        paper->state = STALE;
    return status;
}

enum pel_status pel_epaper_init(struct pel_display *display,
                                struct pel_epaper *paper)
{
    if (!display || !paper || !paper->chip || !paper->bus || !paper->busy ||
        !paper->format || !paper->frame || !paper->bus->data)
        return PEL_ERROR_NULL;
    const struct pel_epaper_chip *chip = paper->chip;
    const struct pel_epaper_kind *kind = chip->kind;
    if (kind->format != paper->format->id &&
        (++kind)->format != paper->format->id)
        return PEL_ERROR_FORMAT;
    paper->kind = kind;
    const uint16_t width = paper->width, height = paper->height;
    if (width - 1u >= chip->width || height - 1u >= chip->height)
        return PEL_ERROR_SIZE;
    paper->size = PEL_EPAPER_FRAME(width, height);
    for (uint32_t i = 8 * (uint32_t)paper->size; i-- > 0;)
        put(paper, i, PEL_RGB(255, 255, 255));
    memset(display, 0, sizeof *display);
    display->context = paper;
    display->width = width;
    display->height = height;
    display->format = paper->format;
    display->flush = epaper_flush;
    display->flip = epaper_flip;
    if (paper->rotation & 1) {
        display->width = height;
        display->height = width;
    }
    paper->state = ASLEEP;
    return ready(paper);
}

/* Whatever fails here, the next flush resets the chip. */
enum pel_status pel_epaper_sleep(struct pel_epaper *paper)
{
    enum pel_status status = PEL_OK;
    if (paper->state != ASLEEP)
        status = send(paper, wait(paper), paper->chip->sleep);
    paper->state = ASLEEP;
    return status;
}
