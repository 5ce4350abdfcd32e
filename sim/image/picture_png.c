#include "sim/image/picture_file.h"

#ifdef HAVE_LIBPNG

#include <png.h>
#include <stdlib.h>

static void write_rows(const struct picture *picture, png_structp png,
                       png_bytep line)
{
    for (int y = 0; y < picture->height; y++) {
        picture_bytes(picture, y, line);
        png_write_row(png, line);
    }
}

/* libpng reports errors by jumping back to the setjmp. Nothing that changes
 * after it is read then. */
static bool write_all(const struct picture *picture, FILE *file,
                      png_structp png, png_infop info, png_bytep line)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)picture->width,
                 (png_uint_32)picture->height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    write_rows(picture, png, line);
    png_write_end(png, info);
    return true;
}

bool picture_write_png(const struct picture *picture, FILE *file)
{
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    png_bytep line = malloc(3 * (size_t)picture->width);
    const bool done = info && line && write_all(picture, file, png, info, line);
    png_destroy_write_struct(&png, &info);
    free(line);
    return done;
}

#endif
