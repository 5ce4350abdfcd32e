/* PANEL names a chip, FORMAT what it takes. */
#include "panel.h"
#include "screen.h"

/* A part of the screen that every glass has. */
static const struct pel_surface screen = {
    .pixels = pixels,
    .stride = SCREEN_SIDE * 2,
    .bounds = {0, 0, SCREEN_SIDE, SCREEN_SIDE},
    .clip = {0, 0, SCREEN_SIDE, 48},
    .format = &FORMAT,
};

int main(void)
{
    return show(&PANEL, &screen);
}
