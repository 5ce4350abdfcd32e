/* The light of docs/use.md is that of the command above it. */
#include <pel/pel.h>

int main(void)
{
#include "light.inc"
    const struct pel_light *const light = lighting.light;
    return !light->directional || light->at[0] != 2 || light->at[1] != 5 ||
           light->at[2] != 3 || light->color[0] != 65536 ||
           light->color[2] != 58982;
}
