#include "check.h"
#include "panel_glass.h"

#include <string.h>

/* "Memory Data Write/Read Direction" of the data sheets (ST7735 V1.7 page 59;
 * ST7789V, ILI9341 and GC9A01A have the same table for their sizes): with MV 0
 * CASET counts columns and RASET rows, with MV 1 the other way; MX runs back
 * through columns, MY through rows, in both. */
enum { MY = 0x80, MX = 0x40, MV = 0x20 };

/* SSD1351 rev 1.5 pages 32 and 33, A0h: A[0] vertical increment, A[1]
 * column 127 is SEG0, A[4] COM scanned backwards. */
enum { VERTICAL = 1, REMAP = 2, SCAN = 16 };

void panel_glass_reset(struct panel_glass *g)
{
    g->inverted = g->on = g->awake = false;
    g->direction = 0;
    g->segments = g->scan = false;
    g->command = -1;
    g->multiplex = g->rows;
    memset(g->memory, 0, sizeof g->memory);
}

static void set_pixel(struct panel_glass *g, int column, int row, int value)
{
    assert_in_range(column, 0, g->columns - 1);
    assert_in_range(row, 0, g->rows - 1);
    g->memory[row][column] = (uint16_t)value;
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

static void take_color(struct panel_glass *g, int byte)
{
    if (g->high < 0) {
        g->high = byte;
        return;
    }
    (g->family == PANEL_DCS ? write_dcs : write_ssd1351)(g,
                                                         g->high << 8 | byte);
    g->high = -1;
}

/* Commands without parameters, of the family of MIPI's DCS and of Solomon's. */
static void command(struct panel_glass *g, int byte)
{
    const bool dcs = g->family == PANEL_DCS;
    g->command = byte;
    g->parameter = 0;
    g->high = -1;
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
    g->parameter++;
}

/* SSD1306 rev 1.1 pages 28 to 32, table 9-1, and SH1106, "Commands". True
 * where one parameter follows, which has D/C low as well. */
static bool takes_parameter(int c)
{
    return c == 0x20 || c == 0x81 || c == 0x8D || c == 0xA8 || c == 0xAD ||
           c == 0xD3 || c == 0xD5 || c == 0xD9 || c == 0xDA || c == 0xDB;
}

static void take_page_command(struct panel_glass *g, int byte)
{
    if (g->command >= 0) {
        if (g->command == 0xA8)
            g->multiplex = byte + 1;
        if (g->command == 0x81)
            g->brightness = byte;
        assert_false(g->command == 0x20 && byte != 2);
        g->command = -1;
    } else if (takes_parameter(byte)) {
        g->command = byte;
    } else if (byte < 0x10) {
        g->at[0] = (g->at[0] & 0xF0) | byte;
    } else if (byte < 0x20) {
        g->at[0] = (g->at[0] & 0x0F) | (byte & 15) << 4;
    } else if (byte >= 0xB0 && byte < 0xB8) {
        g->at[1] = byte & 7;
    } else if ((byte & ~1) == 0xA0) {
        g->segments = byte & 1;
    } else if ((byte & ~8) == 0xC0) {
        g->scan = byte & 8;
    } else {
        command(g, byte);
        g->command = -1;
    }
}

/* SSD1306 rev 1.5 page 26: a byte is 8 rows of a column, D0 the top one. The
 * column steps on, the page does not. */
static void take_page_data(struct panel_glass *g, int byte)
{
    const int column = g->at[0]++;
    for (int i = 0; i < 8; i++)
        set_pixel(g, g->segments ? g->columns - 1 - column : column,
                  g->at[1] * 8 + i, byte >> i & 1);
}

int panel_glass_take(struct panel_glass *g, const struct bus_log *log, int from)
{
    for (; from < log->count; from++) {
        const int entry = log->log[from], byte = entry & 0xFF;
        if (entry == BUS_LOG_RESET)
            panel_glass_reset(g);
        else if (g->family == PANEL_PAGES)
            (entry & BUS_LOG_DATA ? take_page_data : take_page_command)(g,
                                                                        byte);
        else
            (entry & BUS_LOG_DATA ? take_parameter : command)(g, byte);
    }
    return from;
}

int panel_glass_pixel(const struct panel_glass *g, int x, int y)
{
    int column = g->left + x, row = g->top + y;
    const int rows = g->family == PANEL_PAGES ? g->multiplex : g->rows;
    if (g->columns_backward)
        column = g->columns - 1 - column;
    if (g->rows_backward != g->scan)
        row = rows - 1 - row;
    return g->memory[row][column];
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
