#include <pel/pel.h>
#include "drivers/dirty.h"
#include "drivers/panel.h"

/* What a package brings of drivers compiles and links; there is no panel. */
int main(void)
{
    static const struct pel_rect area = {0, 0, 8, 8};
    struct pel_panel panel = {0};
    struct pel_dirty_areas dirty = {0};
    panel.chip = &pel_panel_st7789;
    pel_dirty_areas_add(&dirty, &area);
    return dirty.count != 1 || !panel.chip;
}
