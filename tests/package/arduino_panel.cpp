// The Arduino IDE, as far as the example panel.ino uses it: what is sent behind
// the command for pixels has to be the picture.
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { LOW, HIGH, OUTPUT, MSBFIRST, SPI_MODE0 };

static int level[32], is_output[32], command;
static uint8_t sent[240 * 240 * 2];
static size_t count;

static void pinMode(int pin, int mode)
{
    is_output[pin] = mode == OUTPUT;
}
static void digitalWrite(int pin, int value)
{
    level[pin] = value;
}
static void delay(uint32_t)
{
}

struct SPISettings {
    SPISettings(uint32_t, int, int)
    {
    }
};

struct port {
    void begin()
    {
    }
    void beginTransaction(SPISettings)
    {
    }
    void endTransaction()
    {
    }
    void transfer(void *bytes, size_t n)
    {
        uint8_t *const at = static_cast<uint8_t *>(bytes);
        if (level[17] == LOW && level[20] == LOW)
            command = at[n - 1];
        else if (level[17] == LOW && command == 0x2C &&
                 count + n <= sizeof sent) {
            memcpy(sent + count, at, n);
            count += n;
        }
        memset(bytes, 0xA5, n);
    }
};
static port SPI;

#include "panel.ino"

static uint16_t picture[240 * 240];

int main()
{
    const pel_rect all = {0, 0, side, side};
    pel_surface whole;
    setup();
    place = 100;
    pel_surface_init(&whole, &pel_rgb565_be, picture, sizeof picture, &all);
    draw(&whole);
    loop();
    return !(is_output[17] && is_output[20] && is_output[21] &&
             level[21] == HIGH && count == sizeof sent &&
             memcmp(sent, picture, sizeof sent) == 0);
}
