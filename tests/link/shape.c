/* Fills one shape, DRAW of draws.h, with one color: opaque, and with alpha. */
#include "draws.h"

int main(void)
{
    static const struct pel_flat flat[2] = {PEL_FLAT(PEL_RGB(255, 0, 0)),
                                            PEL_FLAT(PEL_RGBA(0, 0, 255, 128))};
    for (int i = 0; i < 2; i++)
        DRAW(&flat[i].paint);
    return 0;
}
