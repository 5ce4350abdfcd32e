/* Sets and tells the mode of a framebuffer, for tests; knows nothing of Pel.
 *
 *     fb_mode [BITS [WIDTH HEIGHT [VIRTUAL_WIDTH VIRTUAL_HEIGHT [ALPHA]]]]
 *         0 leaves a value as it is. Prints the mode that then is. Status 1:
 *         the kernel refused it.
 *     fb_mode -read FILE.ppm
 *         writes what is visible, bits widened by repeating them. */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

static struct fb_var_screeninfo v;
static struct fb_fix_screeninfo f;

static int fail(const char *what)
{
    fprintf(stderr, "fb_mode: %s: %s\n", what, strerror(errno));
    return 1;
}

static int get(int fd)
{
    return ioctl(fd, FBIOGET_VSCREENINFO, &v) ||
           ioctl(fd, FBIOGET_FSCREENINFO, &f);
}

static void print(void)
{
    printf("mode %.16s %ux%u virtual %ux%u offset %u,%u bits %u line %u "
           "red %u/%u green %u/%u blue %u/%u visual %u pan %u\n",
           f.id, v.xres, v.yres, v.xres_virtual, v.yres_virtual, v.xoffset,
           v.yoffset, v.bits_per_pixel, f.line_length, v.red.offset,
           v.red.length, v.green.offset, v.green.length, v.blue.offset,
           v.blue.length, f.visual, f.ypanstep);
}

static unsigned wide(unsigned pixel, const struct fb_bitfield *field)
{
    unsigned n = field->length, c = pixel >> field->offset & ((1u << n) - 1);
    unsigned high = c << (8 - n);
    return high | high >> n | (n < 4 ? high >> 2 * n : 0);
}

static unsigned pixel_at(const uint8_t *line, unsigned x)
{
    const unsigned bytes = v.bits_per_pixel / 8;
    unsigned pixel = 0;
    if (bytes == 0) /* as the kernel draws on this CPU; all channels are one */
        return (line[x / 8] >> x % 8 & 1) == (f.visual != FB_VISUAL_MONO01)
                   ? 255
                   : 0;
    for (unsigned i = 0; i < bytes; i++)
        pixel |= (unsigned)line[x * bytes + i] << 8 * i;
    return pixel;
}

static int read_picture(int fd, const char *path)
{
    const struct fb_bitfield byte = {0, 8, 0};
    const bool mono = v.bits_per_pixel == 1;
    uint8_t *line = malloc(f.line_length);
    uint8_t *map = mmap(NULL, f.smem_len, PROT_READ, MAP_SHARED, fd, 0);
    FILE *file = fopen(path, "wb");
    if (!line || map == MAP_FAILED || !file)
        return fail(path);
    fprintf(file, "P6\n%u %u\n255\n", v.xres, v.yres);
    for (unsigned y = 0; y < v.yres; y++) {
        memcpy(line, map + (size_t)(v.yoffset + y) * f.line_length,
               f.line_length);
        for (unsigned x = v.xoffset; x < v.xoffset + v.xres; x++) {
            const unsigned pixel = pixel_at(line, x);
            fputc((int)wide(pixel, mono ? &byte : &v.red), file);
            fputc((int)wide(pixel, mono ? &byte : &v.green), file);
            fputc((int)wide(pixel, mono ? &byte : &v.blue), file);
        }
    }
    free(line);
    return fclose(file) ? fail(path) : 0;
}

static void set(uint32_t *value, int argc, char **argv, int i)
{
    if (i < argc && atoi(argv[i]) > 0)
        *value = (uint32_t)atoi(argv[i]);
}

int main(int argc, char **argv)
{
    int fd = open("/dev/fb0", O_RDWR);
    if (fd < 0 || get(fd))
        return fail("/dev/fb0");
    if (argc > 2 && strcmp(argv[1], "-read") == 0)
        return read_picture(fd, argv[2]);
    if (argc > 1) {
        set(&v.bits_per_pixel, argc, argv, 1);
        set(&v.xres, argc, argv, 2);
        set(&v.yres, argc, argv, 3);
        v.xres_virtual = v.xres;
        v.yres_virtual = v.yres;
        set(&v.xres_virtual, argc, argv, 4);
        set(&v.yres_virtual, argc, argv, 5);
        v.transp.length = 0;
        set(&v.transp.length, argc, argv, 6);
        v.xoffset = v.yoffset = 0;
        v.activate = FB_ACTIVATE_NOW;
        if (ioctl(fd, FBIOPUT_VSCREENINFO, &v) || get(fd))
            return fail("refused");
    }
    print();
    return 0;
}
