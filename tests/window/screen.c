/* screen FILE X Y WIDTH HEIGHT ZOOM : writes as PPM what Xvfb shows at (X, Y),
 * WIDTH x HEIGHT pixels that are squares of ZOOM px. FILE is its screen, in the
 * format of xwd. Fails where a square has two colors. */
#include <stdio.h>
#include <stdlib.h>

static long be32(const unsigned char *p)
{
    return (long)p[0] << 24 | p[1] << 16 | p[2] << 8 | p[3];
}

static const unsigned char *pixel_at(const unsigned char *file, long x, long y)
{
    const unsigned char *pixels = file + be32(file) + be32(file + 4 * 19) * 12;
    return pixels + y * be32(file + 4 * 12) + x * 4;
}

int main(int argc, char **argv)
{
    static unsigned char data[8000000];
    long at[5];
    int status = 0;
    FILE *file = argc == 7 ? fopen(argv[1], "rb") : NULL;
    if (!file || fread(data, 1, sizeof data, file) < 100)
        return 2;
    for (int i = 0; i < 5; i++)
        at[i] = strtol(argv[2 + i], NULL, 10);
    printf("P6\n%ld %ld 255\n", at[2], at[3]);
    for (long i = 0; i < at[2] * at[3]; i++) {
        const long x = at[0] + i % at[2] * at[4], y = at[1] + i / at[2] * at[4];
        const unsigned char *p = pixel_at(data, x, y);
        for (long k = 0; k < at[4] * at[4]; k++) {
            const unsigned char *q =
                pixel_at(data, x + k % at[4], y + k / at[4]);
            if (q[0] != p[0] || q[1] != p[1] || q[2] != p[2])
                status = 1;
        }
        printf("%c%c%c", p[2], p[1], p[0]);
    }
    fclose(file);
    return status;
}
