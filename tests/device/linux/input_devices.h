/* The devices of input_devices.c, and what is told of them. */
#ifndef TESTS_DEVICE_LINUX_INPUT_DEVICES_H
#define TESTS_DEVICE_LINUX_INPUT_DEVICES_H

#include <libevdev/libevdev.h>

enum { MOST = 999, SYNC = 0xFFFF }; /* SYNC: the kernel's queue ran over */

struct step {
    int type, code, value;
};

/* A device /dev/input/event0, what it is like when it opens, and what comes. */
struct device {
    const char *name;
    unsigned properties; /* bits */
    int codes[8];        /* of EV_KEY, and of EV_ABS + ABS */
    struct step held[6], comes[24];
    const char *told;
};
enum { ABS = 0x1000, SLOT = 0x2000 }; /* SLOT + i: a value of slot i */
#define TOUCHED                                                          \
    ABS + ABS_MT_SLOT, ABS + ABS_MT_POSITION_X, ABS + ABS_MT_POSITION_Y, \
        ABS + ABS_MT_TRACKING_ID
#define REPORT                \
    {                         \
        EV_SYN, SYN_REPORT, 1 \
    }
#define LISTED(x, y)                                                \
    {EV_ABS, ABS_MT_POSITION_X, x}, {EV_ABS, ABS_MT_POSITION_Y, y}, \
    {                                                               \
        EV_SYN, SYN_MT_REPORT, 1                                    \
    }
#define PLACES ABS + ABS_X, ABS + ABS_Y
#define CORNER             \
    {EV_ABS, ABS_X, 500},  \
    {                      \
        EV_ABS, ABS_Y, 100 \
    }

static const struct device devices[] = {
    {"a screen of fingers without ABS_X, one held",
     1 << INPUT_PROP_DIRECT,
     {TOUCHED},
     {{SLOT + 0, ABS_MT_TRACKING_ID, -1},
      {SLOT + 1, ABS_MT_TRACKING_ID, 4},
      {SLOT + 1, ABS_MT_POSITION_X, 300},
      {SLOT + 1, ABS_MT_POSITION_Y, 200},
      {EV_ABS, ABS_MT_SLOT, 1}},
     {{EV_ABS, ABS_MT_POSITION_X, 310}, REPORT},
     "here T1(300,200)1 T1(310,200)2 "},
    {"a screen of one finger, held, that loses reports",
     1 << INPUT_PROP_DIRECT,
     {BTN_TOUCH, PLACES},
     {CORNER, {EV_KEY, BTN_TOUCH, 1}},
     {{SYNC, 0, 0},
      {EV_ABS, ABS_X, 510},
      REPORT,
      {EV_KEY, BTN_TOUCH, 0},
      REPORT},
     "here T0(500,100)1 lost T0(500,100)1 T0(510,100)2 T0(510,100)0 "},
    {"a list of fingers in each report, that come, cross over and go",
     1 << INPUT_PROP_DIRECT,
     {BTN_TOUCH, ABS + ABS_MT_POSITION_X, ABS + ABS_MT_POSITION_Y, PLACES},
     {{0}},
     {LISTED(100, 200),
      LISTED(300, 400),
      REPORT,
      LISTED(310, 400),
      LISTED(500, 600),
      LISTED(110, 200),
      REPORT,
      LISTED(500, 610),
      REPORT,
      {EV_SYN, SYN_MT_REPORT, 1},
      REPORT},
     "here T0(100,200)1 T1(300,400)1 T0(110,200)2 T1(310,400)2 T2(500,600)1 "
     "T0(110,200)0 T1(310,400)0 T2(500,610)2 T2(500,610)0 "},
    {"a list of one finger, lifted by a button alone",
     1 << INPUT_PROP_DIRECT,
     {BTN_TOUCH, ABS + ABS_MT_POSITION_X, ABS + ABS_MT_POSITION_Y},
     {{0}},
     {{EV_KEY, BTN_TOUCH, 1},
      LISTED(1, 2),
      REPORT,
      REPORT,
      {EV_KEY, BTN_TOUCH, 0},
      REPORT},
     "here T0(1,2)1 T0(1,2)0 "},
    {"a pointer with a place",
     1 << INPUT_PROP_POINTER,
     {BTN_LEFT, PLACES},
     {{EV_KEY, BTN_LEFT, 1}},
     {CORNER, REPORT, {EV_KEY, BTN_LEFT, 0}, REPORT},
     "here B1,1 P(500,100) B1,0 "},
    {"a pen on a tablet",
     1 << INPUT_PROP_POINTER,
     {BTN_TOOL_PEN, BTN_TOUCH, BTN_STYLUS, PLACES},
     {{EV_KEY, BTN_TOOL_PEN, 1}},
     {{EV_KEY, BTN_TOUCH, 1},
      CORNER,
      REPORT,
      {EV_ABS, ABS_X, 510},
      REPORT,
      {EV_KEY, BTN_TOUCH, 0},
      REPORT},
     "here P(500,100) B1,1 P(510,100) P(510,100) B1,0 "},
    {"a touch pad",
     1 << INPUT_PROP_POINTER,
     {BTN_LEFT, BTN_TOUCH, BTN_TOOL_FINGER, TOUCHED},
     {{SLOT + 0, ABS_MT_TRACKING_ID, 4}, {EV_KEY, BTN_TOUCH, 1}},
     {{EV_ABS, ABS_MT_POSITION_X, 9}, {EV_KEY, BTN_LEFT, 1}, REPORT},
     "here B1,1 "},
    {"an accelerometer",
     1 << INPUT_PROP_ACCELEROMETER,
     {PLACES},
     {{0}},
     {{0}},
     ""},
    {"a joystick",
     0,
     {BTN_TRIGGER, PLACES},
     {{0}},
     {CORNER, REPORT, {EV_KEY, BTN_TRIGGER, 1}, REPORT},
     "here K16672,1 "},
};
enum { DEVICES = sizeof devices / sizeof *devices };

#endif
