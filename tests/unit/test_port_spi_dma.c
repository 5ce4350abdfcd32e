/* The bus of port/spi_dma, on a chip whose DMA takes a few bytes at a time, and
 * fails or falls silent when the test wants it. */
#include "tests/support/check.h"

#include <string.h>

#include "drivers/bus.h"

enum { MOST = 5, NEVER = 1000 };

static struct {
    uint8_t wire[64];
    int bytes, pieces, stops;
    bool selected, data, reset;
    uint32_t slept;
    const uint8_t *from; /* of a piece that is not yet sent, or NULL */
    int32_t n;
    int fails_at; /* the piece that fails, from 1; 0: none */
    int silent_at;
} chip;

static void send_byte(uint8_t byte)
{
    assert_true(chip.selected && !chip.from);
    chip.wire[chip.bytes++] = byte;
}

static void select_chip(bool data)
{
    assert_false(chip.selected);
    chip.selected = true;
    chip.data = data;
}

static void release_chip(void)
{
    chip.selected = false;
}

static void reset_line(bool high)
{
    chip.reset = chip.reset || !high;
}

static void dma_send(const uint8_t *bytes, int32_t n)
{
    assert_true(chip.selected && chip.data && !chip.from);
    assert_in_range(n, 1, MOST);
    chip.from = bytes;
    chip.n = n;
}

static void dma_stop(void)
{
    chip.stops++;
    chip.from = NULL;
}

static void drain(void)
{
    assert_true(chip.selected && !chip.from);
}

static void sleep_ms(uint32_t ms)
{
    chip.slept += ms;
}

#include "port/spi_dma/spi_dma.inc"

/* The interrupts of so many pieces. */
static void interrupts(int n)
{
    for (; n > 0 && chip.from && ++chip.pieces != chip.silent_at; n--) {
        const bool failed = chip.pieces == chip.fails_at;
        memcpy(chip.wire + chip.bytes, chip.from, (size_t)chip.n);
        chip.bytes += chip.n;
        chip.from = NULL;
        piece_sent(failed);
    }
}

static void begin(void)
{
    memset(&chip, 0, sizeof chip);
}

static const uint8_t picture[] = "abcdefghijklmnopqrstuvwxyz0123456789";
static const struct pel_bus_rows window = {picture, 7, 3, 10};

TEST(rows_leave_in_pieces_in_order)
{
    begin();
    assert_int_equal(board_bus.data(&board_bus, &window), PEL_OK);
    interrupts(NEVER);
    assert_int_equal(board_bus.wait(&board_bus), PEL_OK);
    assert_int_equal(chip.bytes, 21);
    assert_memory_equal(chip.wire, "abcdefgklmnopquvwxyz0", 21);
    assert_int_equal(chip.pieces, 6);
    assert_false(chip.selected);
}

TEST(a_command_has_its_line_low_and_a_pulse_resets)
{
    begin();
    const uint8_t bytes[] = {0x2A, 1, 2};
    uint8_t answer;
    assert_int_equal(board_bus.command(&board_bus, bytes, 3, NULL, 0), PEL_OK);
    assert_memory_equal(chip.wire, bytes, 3);
    assert_false(chip.data || chip.selected);
    assert_int_equal(board_bus.command(&board_bus, bytes, 1, &answer, 1),
                     PEL_ERROR_DEVICE);
    assert_int_equal(chip.bytes, 3);
    assert_int_equal(board_bus.pause(&board_bus, true, 120), PEL_OK);
    assert_true(chip.reset && chip.slept >= 120);
}

TEST(an_error_of_any_piece_is_told_once_and_ends_the_rows)
{
    for (int i = 1; i <= 6; i++) {
        begin();
        chip.fails_at = i;
        board_bus.data(&board_bus, &window);
        interrupts(NEVER);
        assert_int_equal(chip.pieces, i);
        assert_false(chip.selected);
        assert_int_equal(board_bus.data(&board_bus, &window), PEL_ERROR_DEVICE);
        assert_null(chip.from);
        assert_int_equal(board_bus.data(&board_bus, &window), PEL_OK);
        interrupts(NEVER);
        assert_int_equal(board_bus.wait(&board_bus), PEL_OK);
    }
}

TEST(an_interrupt_that_never_comes_is_given_up)
{
    for (int i = 1; i <= 6; i++) {
        begin();
        chip.silent_at = i;
        board_bus.data(&board_bus, &window);
        interrupts(NEVER);
        assert_true(chip.selected);
        assert_int_equal(board_bus.pause(&board_bus, false, 1),
                         PEL_ERROR_DEVICE);
        assert_int_equal(chip.stops, 1);
        assert_false(chip.selected);
        piece_sent(false);
        assert_null(chip.from);
        assert_int_equal(board_bus.wait(&board_bus), PEL_OK);
    }
}
