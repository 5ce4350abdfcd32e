#include "sim/cli/libraries.h"

#include <stddef.h>

#ifdef HAVE_ASSIMP
#define WITH_ASSIMP true
#else
#define WITH_ASSIMP false
#endif

#ifdef HAVE_SDL2
#define WITH_SDL2 true
#else
#define WITH_SDL2 false
#endif

#ifdef HAVE_SDL2_IMAGE
#define WITH_SDL2_IMAGE true
#else
#define WITH_SDL2_IMAGE false
#endif

#ifdef HAVE_LIBPNG
#define WITH_LIBPNG true
#else
#define WITH_LIBPNG false
#endif

#if defined(PEL_WITH_DRM) && PEL_WITH_DRM
#define WITH_LIBDRM true
#else
#define WITH_LIBDRM false
#endif

#ifdef HAVE_LIBEVDEV
#define WITH_LIBEVDEV true
#else
#define WITH_LIBEVDEV false
#endif

#ifdef HAVE_LIBGPIOD
#define WITH_LIBGPIOD true
#else
#define WITH_LIBGPIOD false
#endif

#ifdef HAVE_PKG_CONFIG
#define WITH_PKG_CONFIG true
#else
#define WITH_PKG_CONFIG false
#endif

const struct library libraries[] = {
    {"pkg-config", "pkg-config", "finds the libraries below at build time",
     WITH_PKG_CONFIG},
    {"assimp", "libassimp-dev", "reads meshes of any format", WITH_ASSIMP},
    {"SDL2", "libsdl2-dev", "turns meshes in a window (pel view)", WITH_SDL2},
    {"SDL2_image", "libsdl2-image-dev", "reads PNG, JPEG, TGA textures",
     WITH_SDL2_IMAGE},
    {"libpng", "libpng-dev", "writes PNG in place of BMP", WITH_LIBPNG},
    {"libdrm", "libdrm-dev", "shows scenes on DRM devices", WITH_LIBDRM},
    {"libevdev", "libevdev-dev", "reads keyboards, mice, touch screens",
     WITH_LIBEVDEV},
    {"libgpiod", "libgpiod-dev", "reads buttons at GPIO lines", WITH_LIBGPIOD},
    {NULL, NULL, NULL, false},
};
