#include "panel.h"
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_be_fill);

int main(void)
{
    return show(&pel_panel_st7789, &screen);
}
