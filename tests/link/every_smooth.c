/* Every smooth shape in flat colors. */
#include "draws.h"

#define DRAW(name) draw_##name

static draw_function *const draws[] = {EVERY_SMOOTH(DRAW)};

int main(void)
{
    static const struct pel_flat flat[2] = {PEL_FLAT(PEL_RGB(255, 0, 0)),
                                            PEL_FLAT(PEL_RGBA(0, 0, 255, 128))};
    for (unsigned i = 0; i < sizeof draws / sizeof *draws; i++) {
        draws[i](&flat[0].paint);
        draws[i](&flat[1].paint);
    }
    return 0;
}
