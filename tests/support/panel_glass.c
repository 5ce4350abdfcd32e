#include "check.h"
#include "panel_glass.h"

#include <string.h>

/* "Memory Data Write/Read Direction" of the data sheets (ST7735 V1.7 page 59;
 * ST7789V, ILI9341 and GC9A01A have the same table for their sizes): with MV 0
 * CASET counts columns and RASET rows, with MV 1 the other way; MX runs back
 * through columns, MY through rows, in both. */
enum { MY = 0x80, MX = 0x40, MV = 0x20 };

static int32_t memory[480][320];

/* SSD1351 rev 1.5 pages 32 and 33, A0h: A[0] vertical increment, A[1]
 * column 127 is SEG0, A[4] COM scanned backwards. */
enum { VERTICAL = 1, REMAP = 2, SCAN = 16 };

void panel_glass_reset(struct panel_glass *g)
{
    g->inverted = g->on = g->awake = false;
    g->direction = 0;
    g->segments = g->scan = g->extended = false;
    g->command = -1;
    g->multiplex = g->family == PANEL_SH1107 ? 128 : g->rows;
    g->offset = 0;
    g->scroll[0] = g->scroll[2] = g->start = 0;
    g->scroll[1] = g->rows;
    memset(memory, 0, sizeof memory);
}

static void set_pixel(struct panel_glass *g, int column, int row, int value)
{
    assert_in_range(column, 0, g->columns - 1);
    assert_in_range(row, 0, g->rows - 1);
    memory[row][column] = value;
}

/* One step in the window: along `first`, then along the other. */
static void advance(int at[2], const int first[2], const int second[2], int i)
{
    if (at[i]++ == first[1]) {
        at[i] = first[0];
        if (at[!i]++ == second[1])
            at[!i] = second[0];
    }
}

static void write_dcs(struct panel_glass *g, int value)
{
    const bool exchanged = g->direction & MV;
    int column = g->at[exchanged], row = g->at[!exchanged];
    if (g->direction & MX)
        column = g->columns - 1 - column;
    if (g->direction & MY)
        row = g->rows - 1 - row;
    set_pixel(g, column, row, value);
    advance(g->at, g->x, g->y, 0);
}

static void write_ssd1351(struct panel_glass *g, int value)
{
    set_pixel(g, g->direction & REMAP ? 127 - g->at[0] : g->at[0],
              g->direction & SCAN ? 127 - g->at[1] : g->at[1], value);
    if (g->direction & VERTICAL)
        advance(g->at, g->y, g->x, 1);
    else
        advance(g->at, g->x, g->y, 0);
}

/* ST7735 V1.7 page 94 on, ILI9488 V090 page 121 on: two bytes at 16 bits a
 * pixel, three at 18, each of which has its channel in the upper six. */
static void take_color(struct panel_glass *g, int byte)
{
    const bool wide = g->family == PANEL_DCS && (g->depth & 7) == 6;
    if (wide)
        byte &= 0xFC;
    g->pixel = g->pixel << 8 | byte;
    if (++g->bytes < (wide ? 3 : 2))
        return;
    (g->family == PANEL_DCS ? write_dcs : write_ssd1351)(g, g->pixel);
    g->bytes = g->pixel = 0;
}

/* Commands without parameters, of the family of MIPI's DCS and of Solomon's. */
static void command(struct panel_glass *g, int byte)
{
    const bool dcs = g->family == PANEL_DCS;
    g->command = byte;
    g->parameter = 0;
    g->bytes = g->pixel = 0;
    g->at[0] = g->x[0];
    g->at[1] = g->y[0];
    if (byte == (dcs ? 0x20 : 0xA6) || byte == (dcs ? 0x21 : 0xA7))
        g->inverted = byte & 1;
    if (byte == (dcs ? 0x28 : 0xAE) || byte == (dcs ? 0x29 : 0xAF))
        g->on = byte & 1;
    if (dcs && (byte == 0x10 || byte == 0x11))
        g->awake = byte & 1;
    if (!dcs)
        g->awake = g->on;
}

static void range(struct panel_glass *g, int range_[2], int byte)
{
    if (g->family == PANEL_SSD1351)
        range_[g->parameter] = byte;
    else if (g->parameter & 1)
        range_[g->parameter / 2] |= byte;
    else
        range_[g->parameter / 2] = byte << 8;
}

/* ST7789V v1.3 section 9.1, 33h and 37h: numbers of two bytes. The three of 33h
 * are all lines of memory, and 37h is one of those that scroll. */
static void take_scroll(struct panel_glass *g, int *numbers, int byte)
{
    int *const number = &numbers[g->parameter / 2];
    *number = g->parameter & 1 ? *number | byte : byte << 8;
    if (g->command == 0x33 && g->parameter == 5) {
        assert_int_equal(g->scroll[0] + g->scroll[1] + g->scroll[2], g->rows);
        g->start = g->scroll[0];
    }
    if (g->command == 0x37 && g->parameter == 1)
        assert_in_range(g->start, g->scroll[0],
                        g->scroll[0] + g->scroll[1] - 1);
}

/* The line of memory that is seen at a line of the chip. */
static int scrolled(const struct panel_glass *g, int row)
{
    const int at = row - g->scroll[0];
    if (g->family != PANEL_DCS || at < 0 || at >= g->scroll[1])
        return row;
    return g->scroll[0] + (at + g->start - g->scroll[0]) % g->scroll[1];
}

/* ST7789V v1.3 section 9.1, 2Ah, 2Bh, 2Ch, 36h, 3Ah, 51h; SSD1351 rev 1.5 pages
 * 32 to 34. */
static void take_parameter(struct panel_glass *g, int byte)
{
    const bool dcs = g->family == PANEL_DCS;
    const int c = g->command;
    if (c == (dcs ? 0x2C : 0x5C)) {
        take_color(g, byte);
        return;
    }
    if (c == (dcs ? 0x2A : 0x15))
        range(g, g->x, byte);
    else if (c == (dcs ? 0x2B : 0x75))
        range(g, g->y, byte);
    else if (c == (dcs ? 0x36 : 0xA0))
        g->direction = byte;
    else if (dcs && c == 0x3A)
        g->depth = byte;
    else if (c == (dcs ? 0x51 : 0xC7))
        g->brightness = byte;
    else if (dcs && (c == 0x33 || c == 0x37))
        take_scroll(g, c == 0x33 ? g->scroll : &g->start, byte);
    g->parameter++;
}

/* SSD1306 rev 1.1 pages 28 to 32, table 9-1; SSD1309 rev 1.1, table 9-1; SH1106
 * and SH1107, "Commands"; ST7565R V1.5, table 16. True where one parameter
 * follows, which has D/C low as well. */
static bool takes_parameter(const struct panel_glass *g, int c)
{
    return (c == 0x20 && g->family == PANEL_PAGES) || c == 0x81 || c == 0x8D ||
           c == 0xA8 || c == 0xAD || c == 0xD3 || c == 0xD5 || c == 0xD9 ||
           c == 0xDA || c == 0xDB || c == 0xDC || c == 0xF8 || c == 0xFD;
}

static void take_page_parameter(struct panel_glass *g, int byte)
{
    if (g->command == 0xA8)
        g->multiplex = byte + 1;
    if (g->command == 0x81)
        g->brightness = byte;
    if (g->command == 0xD3)
        g->offset = byte;
    assert_false(g->command == 0x20 && byte != 2);
    g->command = -1;
}

static void take_page_command(struct panel_glass *g, int byte)
{
    if (g->command >= 0) {
        take_page_parameter(g, byte);
    } else if (takes_parameter(g, byte)) {
        g->command = byte;
    } else if (byte < 0x10) {
        g->at[0] = (g->at[0] & 0xF0) | byte;
    } else if (byte < 0x20) {
        g->at[0] = (g->at[0] & 0x0F) | (byte & 15) << 4;
    } else if (byte >= 0xB0 && byte < (g->rows > 64 ? 0xC0 : 0xB9)) {
        g->at[1] = byte & 15;
    } else if ((byte & ~1) == 0xA0) {
        g->segments = byte & 1;
    } else if ((byte & ~8) == 0xC0) {
        g->scan = byte & 8;
    } else {
        command(g, byte);
        g->command = -1;
    }
}

/* PCD8544, 1999 Apr 12, table 1 and section 8: with H 0 and 1. */
static void take_pcd8544_command(struct panel_glass *g, int byte)
{
    if ((byte & 0xF8) == 0x20) {
        g->awake = !(byte & 4);
        assert_false(byte & 2); /* column by column */
        g->extended = byte & 1;
    } else if (g->extended && byte & 0x80) {
        g->brightness = byte & 0x7F;
    } else if (g->extended) {
        assert_true((byte & 0xFC) == 4 || (byte & 0xF8) == 0x10);
    } else if (byte & 0x80) {
        g->at[0] = byte & 0x7F;
    } else if (byte & 0x40) {
        g->at[1] = byte & 7;
    } else {
        assert_int_equal(byte & ~5, 8);
        g->inverted = byte & 1;
        g->on = byte & 4;
    }
}

/* SSD1306 rev 1.5 page 26: a byte is 8 rows of a column, D0 the top one. The
 * column steps on, the page does not. Of an SH1107 the rows are what its
 * segments show. */
static void take_page_data(struct panel_glass *g, int byte)
{
    int column = g->at[0]++;
    const bool across = g->family == PANEL_SH1107;
    if (g->segments && !across)
        column = g->columns - 1 - column;
    for (int i = 0; i < 8; i++) {
        const int row = g->at[1] * 8 + i;
        set_pixel(g, column, g->segments && across ? g->rows - 1 - row : row,
                  byte >> i & 1);
    }
}

static void take_command(struct panel_glass *g, int byte)
{
    if (g->family == PANEL_PCD8544)
        take_pcd8544_command(g, byte);
    else if (g->family >= PANEL_PAGES)
        take_page_command(g, byte);
    else
        command(g, byte);
}

int panel_glass_take(struct panel_glass *g, const struct bus_log *log, int from)
{
    for (; from < log->count; from++) {
        const int entry = log->log[from], byte = entry & 0xFF;
        if (entry == BUS_LOG_RESET)
            panel_glass_reset(g);
        else if (!(entry & BUS_LOG_DATA))
            take_command(g, byte);
        else
            (g->family >= PANEL_PAGES ? take_page_data : take_parameter)(g,
                                                                         byte);
    }
    return from;
}

int panel_glass_pixel(const struct panel_glass *g, int x, int y)
{
    int column = g->left + x, row = g->top + y;
    const int rows = g->family == PANEL_PAGES ? g->multiplex : g->rows;
    const bool across = g->family == PANEL_SH1107;
    if (g->columns_backward != (g->scan && across))
        column = g->columns - 1 - column;
    if (g->rows_backward != (g->scan && !across))
        row = rows - 1 - row;
    return memory[scrolled(g, row)][column];
}

void panel_glass_turn(int rotation, int width, int height, int at[2])
{
    const int x = at[0], y = at[1], right = width - 1 - x,
              below = height - 1 - y;
    const int turned[4][2] = {{x, y}, {y, right}, {right, below}, {below, x}};
    at[0] = turned[rotation][0];
    at[1] = turned[rotation][1];
}

static int frame_pixel(const struct pel_surface *s, int x, int y)
{
    const uint8_t *bytes = s->pixels;
    if (s->format->id == PEL_FORMAT_MONO1_PAGES)
        return bytes[y / 8 * s->stride + x] >> (y & 7) & 1;
    bytes += y * s->stride;
    if (s->format->id == PEL_FORMAT_MONO1)
        return bytes[x / 8] >> (7 - (x & 7)) & 1;
    if (s->format->id == PEL_FORMAT_BGR888)
        return (bytes[3 * x] << 16 | bytes[3 * x + 1] << 8 | bytes[3 * x + 2]) &
               0xFCFCFC;
    return bytes[2 * x] << 8 | bytes[2 * x + 1];
}

bool panel_glass_shows(const struct panel_glass *glass,
                       const struct pel_surface *frame, int rotation, int at[2])
{
    const struct pel_rect *b = &frame->bounds;
    const int width = rotation & 1 ? b->y1 : b->x1;
    const int height = rotation & 1 ? b->x1 : b->y1;
    for (at[1] = 0; at[1] < height; at[1]++)
        for (at[0] = 0; at[0] < width; at[0]++) {
            int p[2] = {at[0], at[1]};
            panel_glass_turn(rotation, width, height, p);
            if (panel_glass_pixel(glass, at[0], at[1]) !=
                frame_pixel(frame, p[0], p[1]))
                return false;
        }
    return true;
}
