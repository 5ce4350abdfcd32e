/* A panel, for the Arduino IDE: a disc that moves over an ST7789 of 240x240
 * behind SPI, ten lines at a time. The pins are those of a Raspberry Pi Pico,
 * where SCK is GPIO 18 and MOSI 19; other chips are in drivers/panel.h. */
#include <SPI.h>
#include <pel.h>
#include <drivers/panel.h>

static const int pin_cs = 17, pin_dc = 20, pin_rst = 21;
static const int side = 240, lines = 10;

static uint16_t band[side * lines];
static pel_panel panel;
static pel_display display;
static int place;

static void begin_sending(bool data)
{
    SPI.beginTransaction(SPISettings(40000000, MSBFIRST, SPI_MODE0));
    digitalWrite(pin_dc, data ? HIGH : LOW);
    digitalWrite(pin_cs, LOW);
}

static void end_sending()
{
    digitalWrite(pin_cs, HIGH);
    SPI.endTransaction();
}

/* From a copy: transfer writes what it receives over what it sends. */
static void send(const uint8_t *bytes, size_t n)
{
    uint8_t part[64];
    while (n > 0) {
        const size_t size = n < sizeof part ? n : sizeof part;
        memcpy(part, bytes, size);
        SPI.transfer(part, size);
        bytes += size;
        n -= size;
    }
}

static pel_status bus_command(const pel_bus *, const uint8_t *bytes, size_t n,
                              uint8_t *, size_t answers)
{
    if (answers > 0)
        return PEL_ERROR_DEVICE;
    begin_sending(false);
    send(bytes, n);
    end_sending();
    return PEL_OK;
}

static pel_status bus_data(const pel_bus *, const pel_bus_rows *rows)
{
    begin_sending(true);
    for (int32_t i = 0; i < rows->count; i++)
        send(rows->bytes + i * rows->stride, (size_t)rows->length);
    end_sending();
    return PEL_OK;
}

static pel_status bus_pause(const pel_bus *, bool reset, uint32_t ms)
{
    if (reset) {
        digitalWrite(pin_rst, LOW);
        delay(1);
        digitalWrite(pin_rst, HIGH);
    }
    delay(ms);
    return PEL_OK;
}

static const pel_bus bus = {NULL, bus_command, bus_data, bus_pause, NULL};

static void draw(const pel_surface *screen)
{
    static const pel_flat red = PEL_FLAT(PEL_RGB(230, 40, 30));
    const pel_point center = pel_at(place, side / 2);

    pel_clear(screen, PEL_RGB(0, 0, 64));
    pel_smooth_circle(screen, center, PEL_PX(30), &red.paint);
}

void setup()
{
    const int pins[] = {pin_cs, pin_dc, pin_rst};
    for (int pin : pins) {
        digitalWrite(pin, HIGH);
        pinMode(pin, OUTPUT);
    }
    SPI.begin();
    panel.chip = &pel_panel_st7789;
    panel.bus = &bus;
    panel.format = &pel_rgb565_be;
    panel.width = panel.height = side;
    while (pel_panel_init(&display, &panel) != PEL_OK) {
    }
}

void loop()
{
    for (int y = 0; y < side; y += lines) {
        const pel_rect rows = {0, y, side, y + lines};
        pel_surface screen;
        pel_surface_init(&screen, display.format, band, sizeof band, &rows);
        draw(&screen);
        pel_display_flush(&display, &screen);
    }
    place = (place + 2) % side;
}
