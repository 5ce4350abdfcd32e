/* A Linux board whose system calls are played: what goes over spidev and
 * i2c-dev, lines of GPIO, and calls that fail. Linked with --wrap for each. */
#ifndef TESTS_DEVICE_LINUX_PANEL_CALLS_H
#define TESTS_DEVICE_LINUX_PANEL_CALLS_H

#include "drivers/display_linux_panel.h"
#include "tests/support/panel_glass.h"
#include "tests/support/paper_glass.h"

extern struct bus_log wire; /* what went over it */
extern struct pel_display_panel panel;
extern struct pel_display display;
extern struct pel_message message;
extern struct paper_glass paper; /* takes what is sent, if `is_paper` */
extern bool is_paper;
extern int mode_set, lines_open, levels[4]; /* D/C, reset, light, BUSY */
extern int calls, fail_at, error_given;
extern size_t messages, lines_set, bytes_sent, bytes_copied;

/* Another one where a file was left open. */
int next_descriptor(void);

#endif
