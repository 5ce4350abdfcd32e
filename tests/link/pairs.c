/* The stack of every shape with every paint: prints `SHAPE PAINT BYTES`, the
 * frames of draw_SHAPE and below. */
#include "draws.h"
#include "makes.h"
#include "port/cortex_m/semihost.h"
#include "port/cortex_m/stack_probe.h"

#define NAMED_DRAW(name)   \
    {                      \
#name, draw_##name \
    }
#define NAMED_MAKE(name)   \
    {                      \
#name, make_##name \
    }

static const struct {
    const char *name;
    draw_function *draw;
} shapes[] = {EVERY_DRAW(NAMED_DRAW), EVERY_SMOOTH(NAMED_DRAW),
              EVERY_PATH(NAMED_DRAW)};

static const struct {
    const char *name;
    make_function *make;
} paints[] = {EVERY_MAKE(NAMED_MAKE), EVERY_WAY(NAMED_MAKE)};

struct pair {
    draw_function *draw;
    const struct pel_paint *paint;
};

static void draw(const void *argument)
{
    const struct pair *pair = argument;
    pair->draw(pair->paint);
}

/* What `draw` and its callee's frame take. */
static void draw_nothing(const struct pel_paint *paint)
{
    (void)paint;
}

static void print_pair(const char *shape, const char *paint, uint32_t bytes)
{
    semihost_write(shape);
    semihost_write(" ");
    semihost_write(paint);
    semihost_write(" ");
    semihost_write_number(bytes);
    semihost_write("\n");
}

int main(void)
{
    const struct pair nothing = {draw_nothing, NULL};
    const uint32_t own = stack_used(draw, &nothing);
    for (unsigned i = 0; i < sizeof paints / sizeof *paints; i++) {
        const struct pel_paint *paint = paints[i].make();
        for (unsigned k = 0; k < sizeof shapes / sizeof *shapes; k++) {
            const struct pair pair = {shapes[k].draw, paint};
            print_pair(shapes[k].name, paints[i].name,
                       stack_used(draw, &pair) - own);
        }
    }
    return 0;
}
