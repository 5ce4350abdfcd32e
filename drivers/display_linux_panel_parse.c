#include "display_linux_panel.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static int refuse(struct pel_message *message, const char *what,
                  const char *expected)
{
    return pel_message_set(message, EINVAL, "panel: '%.60s': expected %s", what,
                           expected);
}

/* N (hexadecimal with 0x), or NxM into both; each 0..32,767. */
static bool numbers(const char *text, int *first, int *second)
{
    char *end;
    const int base = second ? 10 : 0; /* 0x20 is a pair */
    const long a = strtol(text, &end, base);
    long b = 0;
    if (second && *end == 'x' && end > text) {
        text = end + 1;
        b = strtol(text, &end, base);
    } else if (second) {
        return false;
    }
    if (end == text || *end || a < 0 || a > 32767 || b < 0 || b > 32767)
        return false;
    *first = (int)a;
    if (second)
        *second = (int)b;
    return true;
}

/* Hz; with M behind it MHz. */
static bool speed(const char *text, uint32_t *hz)
{
    char *end;
    const unsigned long n = strtoul(text, &end, 10);
    const unsigned long unit = *end == 'M' ? 1000000 : 1;
    end += *end == 'M';
    if (end == text || *end || n == 0 || n > 1000000000 / unit)
        return false;
    *hz = (uint32_t)(n * unit);
    return true;
}

static int take_value(struct pel_panel_request *r, const char *key,
                      const char *value, struct pel_message *message)
{
    int mode = r->bus.mode, address = r->bus.address;
    const struct {
        const char *key;
        const char **text;
        const char *expected;
        int *first;
        int *second; /* or NULL */
        int most;
        int step;
    } options[] = {{"spi", .text = &r->bus.spi},
                   {"i2c", .text = &r->bus.i2c},
                   {"dc", .text = &r->bus.dc},
                   {"reset", .text = &r->bus.reset},
                   {"light", .text = &r->bus.light},
                   {"busy", .text = &r->busy},
                   {"size", .expected = "a size, 240x240", .first = &r->width,
                    .second = &r->height, .most = 32767, .step = 1},
                   {"offset", .expected = "an offset, 52x40", .first = &r->left,
                    .second = &r->top, .most = 32767, .step = 1},
                   {"rotation", .expected = "a rotation, 0, 90, 180 or 270",
                    .first = &r->rotation, .most = 270, .step = 90},
                   {"brightness", .expected = "a brightness, 0 to 255",
                    .first = &r->brightness, .most = 255, .step = 1},
                   {"mode", .expected = "a mode of SPI, 0 to 3", .first = &mode,
                    .most = 3, .step = 1},
                   {"address", .expected = "an address, 0x3c",
                    .first = &address, .most = 127, .step = 1}};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        if (strcmp(key, options[i].key) != 0)
            continue;
        if (options[i].text) {
            *options[i].text = value;
            return 0;
        }
        const bool good = numbers(value, options[i].first, options[i].second) &&
                          *options[i].first <= options[i].most &&
                          *options[i].first % options[i].step == 0;
        r->bus.mode = (uint8_t)mode;
        r->bus.address = (uint8_t)address;
        return good ? 0 : refuse(message, value, options[i].expected);
    }
    if (strcmp(key, "speed") == 0)
        return speed(value, &r->bus.speed)
                   ? 0
                   : refuse(message, value, "a speed, 32M");
    return refuse(message, key,
                  "spi, mode, speed, i2c, address, dc, reset, light, busy, "
                  "size, offset, rotation, brightness, inverted, swapped or "
                  "partial");
}

static int take(struct pel_panel_request *r, char *option,
                struct pel_message *message)
{
    char *equals = strchr(option, '=');
    if (strcmp(option, "inverted") == 0) {
        r->inverted = true;
    } else if (strcmp(option, "swapped") == 0) {
        r->swapped = true;
    } else if (strcmp(option, "partial") == 0) {
        r->partial = true;
    } else if (!equals || !equals[1]) {
        return refuse(message, option, "OPTION=VALUE");
    } else {
        *equals = 0;
        return take_value(r, option, equals + 1, message);
    }
    return 0;
}

int pel_panel_parse(struct pel_panel_request *request, const char *name,
                    struct pel_message *message)
{
    memset(request, 0, sizeof *request);
    request->width = request->left = request->brightness = -1;
    request->bus.address = 0x3C;
    if (strlen(name) >= sizeof request->text)
        return refuse(message, name, "a shorter name");
    strcpy(request->text, name);
    char *rest = request->text, *option;
    request->chip = strsep(&rest, ",");
    while ((option = strsep(&rest, ",")) != NULL) {
        const int error = take(request, option, message);
        if (error)
            return error;
    }
    if (!request->bus.spi == !request->bus.i2c)
        return refuse(message, name, "spi=/dev/spidev0.0 or i2c=/dev/i2c-1");
    if (request->bus.spi && !request->bus.dc)
        return refuse(message, name, "dc=LINE: SPI panels have a line D/C");
    return 0;
}
