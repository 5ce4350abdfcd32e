#include "check.h"
#include "bus_log.h"

#include <string.h>

enum { POISON = 0xA5 };

static void note(struct bus_log *log, uint16_t kind, const uint8_t *bytes,
                 size_t n)
{
    assert_true((size_t)log->count + n <= BUS_LOG_SIZE);
    for (size_t i = 0; i < n; i++)
        log->log[log->count++] = kind | bytes[i];
}

/* Rows of the program's memory that may be poisoned, or NULL. */
static uint8_t *own_row(const struct bus_log *log, int32_t i)
{
    const uint8_t *row = log->flight.bytes + i * log->flight.stride;
    return row >= log->pixels && row < log->pixels + log->size
               ? log->pixels + (row - log->pixels)
               : NULL;
}

static void arrive(struct bus_log *log)
{
    const struct pel_bus_rows *r = &log->flight;
    const size_t n = (size_t)r->length;
    for (int32_t i = 0; n && i < r->count; i++) {
        uint8_t *own = own_row(log, i);
        for (size_t k = 0; own && k < n; k++)
            assert_int_equal(own[k], POISON);
        note(log, BUS_LOG_DATA,
             own ? log->held + (size_t)i * n : r->bytes + i * r->stride, n);
        if (own)
            memcpy(own, log->held + (size_t)i * n, n);
    }
    log->flight.length = 0;
}

static void depart(struct bus_log *log, const struct pel_bus_rows *rows)
{
    const size_t n = (size_t)rows->length;
    log->flight = *rows;
    for (int32_t i = 0; i < rows->count; i++) {
        uint8_t *own = own_row(log, i);
        if (own) {
            memcpy(log->held + (size_t)i * n, own, n);
            memset(own, POISON, n);
        }
    }
}

/* A call begins: what was in flight has arrived before it. */
static bool fails(const struct pel_bus *bus)
{
    struct bus_log *log = bus->context;
    arrive(log);
    return ++log->calls == log->fail_at;
}

static enum pel_status log_command(const struct pel_bus *bus,
                                   const uint8_t *bytes, size_t n,
                                   uint8_t *answer, size_t answers)
{
    (void)answer;
    assert_true(n > 0 && answers == 0);
    if (fails(bus))
        return PEL_ERROR_DEVICE;
    note(bus->context, 0, bytes, n);
    return PEL_OK;
}

static enum pel_status log_data(const struct pel_bus *bus,
                                const struct pel_bus_rows *rows)
{
    struct bus_log *log = bus->context;
    assert_true(rows->length > 0 && rows->count > 0);
    if (fails(bus))
        return PEL_ERROR_DEVICE;
    depart(log, rows);
    if (!log->dma)
        arrive(log);
    return PEL_OK;
}

static enum pel_status log_pause(const struct pel_bus *bus, bool reset,
                                 uint32_t ms)
{
    struct bus_log *log = bus->context;
    if (fails(bus))
        return PEL_ERROR_DEVICE;
    log->ms += ms;
    if (reset)
        log->log[log->count++] = BUS_LOG_RESET;
    return PEL_OK;
}

static enum pel_status log_wait(const struct pel_bus *bus)
{
    return fails(bus) ? PEL_ERROR_DEVICE : PEL_OK;
}

void bus_log_init(struct bus_log *log)
{
    log->bus = (struct pel_bus){log, log_command, log_data, log_pause,
                                log->dma ? log_wait : NULL};
    log->calls = log->count = 0;
    log->ms = 0;
    log->flight.length = 0;
}
