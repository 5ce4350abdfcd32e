/* Every shape with every paint. */
#include "draws.h"
#include "makes.h"

#define DRAW(name) draw_##name
#define MAKE(name) make_##name

static draw_function *const draws[] = {EVERY_DRAW(DRAW)};
static make_function *const makes[] = {EVERY_MAKE(MAKE)};

int main(void)
{
    for (unsigned i = 0; i < sizeof makes / sizeof *makes; i++) {
        const struct pel_paint *paint = makes[i]();
        for (unsigned k = 0; k < sizeof draws / sizeof *draws; k++)
            draws[k](paint);
    }
    return 0;
}
