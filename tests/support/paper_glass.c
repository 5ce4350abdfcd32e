#include "check.h"
#include "paper_glass.h"

#include <string.h>

enum { POLLS = 3, SWING = 18 }; /* frames that turn black into white */

static bool is_ssd(const struct paper_glass *g)
{
    return g->family == PAPER_SSD;
}

/* A bit of a plane; lines of a UltraChip's are as wide as the resolution. */
static int bit(const struct paper_glass *g, int plane, int x, int y)
{
    const int row = (g->width + 7) / 8;
    return g->plane[plane][y * row + x / 8] >> (7 - x % 8) & 1;
}

/* SSD1680 rev 0.14, 22h and table 6-5: mode 1 drives by the planes, mode 2
 * (bit 3 of the sequence) by what differs between them. UC8151 and UC8179, 12h:
 * waveforms that are chosen or sent drive where old and new differ. */
static void refresh_inks(struct paper_glass *g, bool compare)
{
    const int black_white = !g->color ? 0 : is_ssd(g) ? 0 : 1;
    for (int y = 0; y < g->height; y++)
        for (int x = 0; x < g->width; x++) {
            uint8_t *p = &g->shown[y * g->width + x];
            if (g->color && bit(g, !black_white, x, y))
                *p = PAPER_COLOR;
            else if (!compare || bit(g, 0, x, y) != bit(g, 1, x, y))
                *p = bit(g, black_white, x, y) ? PAPER_WHITE : PAPER_BLACK;
        }
    g->refreshes++;
    g->busy = POLLS * 5;
}

/* What a pixel is after the waveform of register `r`, that begins as `at` of
 * SWING frames of white: 01 takes a frame away, 10 adds one. UC8151, 20h: seven
 * groups of levels, four times and a count; the common electrode stays. */
static int drive(const uint8_t *r, int at, int *charge)
{
    *charge = 0;
    for (int group = 0; group < 7; group++, r += 6)
        for (int i = 0; i < 4 * r[5]; i++)
            for (int frame = 0; frame < r[1 + i % 4]; frame++) {
                const int level = r[0] >> (6 - 2 * (i % 4)) & 3;
                const int step = level == 2 ? 1 : level == 1 ? -1 : 0;
                assert_true(level != 3);
                *charge += step;
                at += at + step >= 0 && at + step <= SWING ? step : 0;
            }
    return at;
}

static int gray_by_registers(const struct paper_glass *g, int pair)
{
    static const int most[4] = {0, 10, 15, SWING};
    int charge;
    const uint8_t *r = g->registers[4 - pair];
    const int at = drive(r, 0, &charge);
    assert_int_equal(drive(r, SWING, &charge), at);
    assert_int_equal(charge, 0);
    for (int gray = 0; gray < 4; gray++)
        if (at == most[gray])
            return gray;
    fail_msg("%d frames of white are no grey", at);
    return 0;
}

/* SSD1680: with the waveform of 90 degrees both planes tell how dark a pixel
 * is, 26h coarsely. UC8151, UC8179: 13h coarsely how light, 10h finely. */
static void refresh_grays(struct paper_glass *g)
{
    int gray[4];
    assert_true(g->grays || (g->family == PAPER_UC8151 && g->waveform));
    for (int pair = 0; pair < 4; pair++)
        gray[pair] = is_ssd(g)                   ? 3 - pair
                     : g->family == PAPER_UC8151 ? gray_by_registers(g, pair)
                                                 : pair;
    for (int y = 0; y < g->height; y++)
        for (int x = 0; x < g->width; x++) {
            const int coarse = bit(g, is_ssd(g), x, y);
            const int fine = bit(g, !is_ssd(g), x, y);
            g->shown[y * g->width + x] =
                (uint8_t)(PAPER_GRAY + gray[coarse << 1 | fine]);
        }
    g->refreshes++;
    g->busy = POLLS * 5;
}

static void write_byte(struct paper_glass *g, int plane, int byte)
{
    const int row = is_ssd(g) ? g->row_bytes : (g->width + 7) / 8;
    assert_int_equal(row, (g->width + 7) / 8);
    assert_in_range(g->x, 0, row - 1);
    assert_in_range(g->y, 0, g->height - 1);
    g->plane[plane][g->y * row + g->x] = (uint8_t)byte;
    if (++g->x == row) {
        g->x = 0;
        g->y++;
    }
}

static void refresh(struct paper_glass *g, bool compare)
{
    if (g->gray)
        refresh_grays(g);
    else
        refresh_inks(g, compare);
}

/* SSD1680, IL3897: 20h begins what 22h has told. */
static void ssd_command(struct paper_glass *g, int c)
{
    if (c == 0x12) {
        g->busy = POLLS;
        g->row_bytes = 0;
        g->ready = true;
        g->grays = false;
    }
    assert_true(g->ready);
    if (c == 0x20 && (g->mode & 4) != 0)
        refresh(g, g->mode & 8 || g->waveform);
    else if (c == 0x20) {
        g->busy = POLLS;
        g->grays = g->mode == 0x91 && g->warmth == 90;
    }
}

static void ssd_parameter(struct paper_glass *g, int byte)
{
    const int c = g->command, n = g->n;
    if (c == 0x24 || c == 0x26) {
        write_byte(g, c == 0x26, byte);
        return;
    }
    if (c == 0x01 && n == 1)
        assert_int_equal(g->parameter[0] | byte << 8, g->height - 1);
    if (c == 0x11)
        assert_int_equal(byte, 3);
    if (c == 0x44 && n == 1)
        g->row_bytes = byte - g->parameter[0] + 1;
    if (c == 0x4E)
        g->x = byte;
    if (c == 0x4F && n == 1)
        g->y = g->parameter[0] | byte << 8;
    if (c == 0x1A && n == 0)
        g->warmth = byte;
    if (c == 0x22)
        g->mode = byte;
    if (c == 0x32)
        g->waveform = true;
    if (c == 0x10)
        g->asleep = byte & 1;
}

static void uc_command(struct paper_glass *g, int c)
{
    if (c == 0x04 || c == 0x02) {
        g->powered = c == 0x04;
        g->busy = POLLS;
    }
    if (c == 0x10 || c == 0x13)
        g->x = g->y = 0;
    if (c != 0x12)
        return;
    assert_true(g->powered && g->ready);
    refresh(g, !g->color && (g->waveform || g->mode == 0x6E));
    g->mode = 0;
}

/* UC8151, UC8179: 00h bit 4 is black and white, bit 5 registers of waveforms;
 * DDX of 50h is 01 where ones are white, and color. */
static void uc_parameter(struct paper_glass *g, int byte)
{
    const int c = g->command, n = g->n;
    const bool wide = g->family == PAPER_UC8179;
    if (c == 0x10 || c == 0x13)
        write_byte(g, c == 0x10, byte);
    if (c == 0x00) {
        assert_int_equal(!(byte & 0x10), g->color);
        g->waveform = byte & 0x20;
    }
    if (c == 0x50 && n == 0)
        assert_int_equal(wide ? byte & 3 : byte >> 4 & 3, 1);
    if (c == 0x61 && n == (wide ? 3 : 2)) {
        const uint8_t *p = g->parameter + (wide ? 2 : 1);
        const int width =
            wide ? g->parameter[0] << 8 | g->parameter[1] : g->parameter[0];
        assert_int_equal(width, (g->width + 7) / 8 * 8);
        assert_int_equal((wide ? p[0] : p[0]) << 8 | byte, g->height);
        g->ready = true;
    }
    if (c >= 0x20 && c <= 0x24 && n < 44)
        g->registers[c - 0x20][n] = (uint8_t)byte;
    if (c == 0xE5) {
        g->mode = byte;
        g->grays = byte == 0x5F;
    }
    if (c == 0x07) {
        assert_int_equal(byte, 0xA5);
        assert_false(g->powered);
        g->asleep = true;
    }
}

static void take_data(struct paper_glass *g, const uint8_t *bytes, int32_t n)
{
    for (; n > 0; n--, bytes++) {
        (is_ssd(g) ? ssd_parameter : uc_parameter)(g, *bytes);
        if (g->n < PAPER_LIST)
            g->parameter[g->n] = *bytes;
        g->n++;
    }
}

/* A call begins: what was in flight has arrived before it. */
static bool fails(const struct pel_bus *bus)
{
    struct paper_glass *g = bus->context;
    const struct pel_bus_rows *r = &g->flight;
    for (int32_t i = 0; r->length && i < r->count; i++)
        take_data(g, r->bytes + i * r->stride, r->length);
    g->flight.length = 0;
    return ++g->calls == g->fail_at;
}

static enum pel_status take_command(const struct pel_bus *bus,
                                    const uint8_t *bytes, size_t n,
                                    uint8_t *answer, size_t answers)
{
    struct paper_glass *g = bus->context;
    (void)answer;
    assert_true(n == 1 && answers == 0);
    if (fails(bus))
        return PEL_ERROR_DEVICE;
    assert_false(g->busy || g->asleep);
    g->command = bytes[0];
    g->n = 0;
    (is_ssd(g) ? ssd_command : uc_command)(g, bytes[0]);
    return PEL_OK;
}

static enum pel_status take_rows(const struct pel_bus *bus,
                                 const struct pel_bus_rows *rows)
{
    struct paper_glass *g = bus->context;
    assert_true(rows->length > 0 && rows->count > 0);
    if (fails(bus))
        return PEL_ERROR_DEVICE;
    g->flight = *rows;
    if (!g->dma) {
        fails(bus);
        g->calls--;
    }
    return PEL_OK;
}

static enum pel_status take_pause(const struct pel_bus *bus, bool reset,
                                  uint32_t ms)
{
    struct paper_glass *g = bus->context;
    if (fails(bus))
        return PEL_ERROR_DEVICE;
    g->ms += ms;
    if (reset) {
        memset(g->plane, 0x5A, sizeof g->plane);
        memset(g->registers, 0xA5, sizeof g->registers);
        g->asleep = g->powered = g->waveform = g->ready = g->grays = false;
        g->busy = 0;
    }
    return PEL_OK;
}

static enum pel_status take_wait(const struct pel_bus *bus)
{
    return fails(bus) ? PEL_ERROR_DEVICE : PEL_OK;
}

void paper_glass_init(struct paper_glass *g)
{
    g->bus = (struct pel_bus){g, take_command, take_rows, take_pause,
                              g->dma ? take_wait : NULL};
    g->calls = g->refreshes = 0;
    g->ms = 0;
    g->flight.length = 0;
    g->busy = 0;
    g->white = g->gray ? PAPER_GRAY + 3 : PAPER_WHITE;
    memset(g->shown, g->white, sizeof g->shown);
}

bool paper_glass_busy(struct paper_glass *g)
{
    const bool busy = g->stuck || g->busy > 0;
    g->busy -= g->busy > 0;
    return busy == is_ssd(g);
}
