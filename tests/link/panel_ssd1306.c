#include "panel.h"
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_mono1_pages);

int main(void)
{
    return show(&pel_panel_ssd1306, &screen);
}
