/* The panel with 16 greys: what is sent over its bus. That a chip takes it for
 * the picture, tests/device/lcd shows in QEMU. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include "drivers/panel.h"
#include "tests/support/bus_log.h"

static struct bus_log bus;
static uint8_t memory[128 * 64 / 2];

/* SSD0323: 15h and 75h are columns of two pixels and rows, first and last; 81h
 * has 7 bits. */
TEST(sixteen_greys)
{
    static const uint16_t sent[] = {0x15,  0x01,  0x05,  0x75,  0x03,  0x04,
                                    0x103, 0x104, 0x105, 0x106, 0x107, 0x143,
                                    0x144, 0x145, 0x146, 0x147, 0x81,  0x4E};
    const struct pel_panel upright = {
        .chip = &pel_panel_ssd0323, .bus = &bus.bus, .format = &pel_gray4};
    struct pel_panel turned = upright, inverted = upright, panel = upright;
    struct pel_panel wide = upright, right = upright;
    struct pel_display display;
    bus_log_init(&bus);
    turned.rotation = 2;
    inverted.inverted = true;
    wide.width = 127;
    right.width = 126;
    right.left = 1;
    assert_int_equal(pel_panel_init(&display, &turned), PEL_ERROR_FORMAT);
    assert_int_equal(pel_panel_init(&display, &inverted), PEL_ERROR_FORMAT);
    assert_int_equal(pel_panel_init(&display, &wide), PEL_ERROR_SIZE);
    assert_int_equal(pel_panel_init(&display, &right), PEL_ERROR_SIZE);
    assert_int_equal(pel_panel_init(&display, &panel), PEL_OK);
    bus.count = 0;
    struct pel_surface s =
        surface_of(&pel_gray4, memory, sizeof memory, 128, 64);
    for (int i = 0; i < 5 * 64; i++)
        memory[i] = (uint8_t)(i - 0xBE);
    s.clip = (struct pel_rect){3, 3, 11, 5};
    assert_int_equal(pel_display_flush(&display, &s), PEL_ERROR_SIZE);
    pel_display_align(&display, &s.clip);
    assert_int_equal(pel_display_flush(&display, &s), PEL_OK);
    assert_int_equal(pel_panel_brightness(&panel, 0x9C), PEL_OK);
    assert_int_equal(bus.count, sizeof sent / sizeof *sent);
    assert_memory_equal(bus.log, sent, sizeof sent);
}
