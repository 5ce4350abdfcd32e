#include "bus_8080.h"

enum { WORDS = 32 };

/* n bytes, `each` of them a word: two are the upper one first. */
static void send(const struct pel_bus_8080 *self, bool data,
                 const uint8_t *bytes, size_t n, size_t each)
{
    uint16_t word[WORDS];
    size_t filled = 0;
    for (; n >= each; n -= each, bytes += each) {
        const int upper = each == 2 ? bytes[0] << 8 : 0;
        word[filled++] = (uint16_t)(upper | bytes[each - 1]);
        if (filled == WORDS) {
            self->words(self, data, word, filled);
            filled = 0;
        }
    }
    if (filled)
        self->words(self, data, word, filled);
}

enum pel_status pel_bus_8080_command(const struct pel_bus *bus,
                                     const uint8_t *bytes, size_t n,
                                     uint8_t *answer, size_t answers)
{
    struct pel_bus_8080 *const self = bus->context;
    (void)answer;
    if (answers)
        return PEL_ERROR_DEVICE;
    self->pixels = bytes[n - 1] == self->write;
    send(self, false, bytes, n, 1);
    return PEL_OK;
}

enum pel_status pel_bus_8080_data(const struct pel_bus *bus,
                                  const struct pel_bus_rows *rows)
{
    struct pel_bus_8080 *const self = bus->context;
    const size_t each = self->lines == 16 && self->pixels ? 2 : 1;
    const uint8_t *row = rows->bytes;
    for (int32_t i = 0; i < rows->count; i++, row += rows->stride)
        send(self, true, row, (size_t)rows->length, each);
    return PEL_OK;
}

enum pel_status pel_bus_8080_pause(const struct pel_bus *bus, bool reset,
                                   uint32_t ms)
{
    struct pel_bus_8080 *const self = bus->context;
    return self->pause ? self->pause(self, reset, ms) : PEL_ERROR_DEVICE;
}
