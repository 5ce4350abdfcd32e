/* The rest of a program whose draw function stands in a page of docs: draws its
 * picture in bands of eight lines, and writes it to standard output as PPM. */
#include "examples/ppm.h"

int main(void)
{
    static uint32_t band[WIDTH * 8];
    printf("P6\n%d %d 255\n", WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y += 8) {
        const struct pel_rect rows = {0, y, WIDTH, y + 8};
        struct pel_surface screen;
        if (pel_surface_init(&screen, &FORMAT, band, sizeof band, &rows) !=
            PEL_OK)
            return 1;
        draw(&screen);
        ppm_write(&screen);
    }
    return 0;
}
