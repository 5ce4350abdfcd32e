/* Finds what a DRM display is shown on. */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_DRM_OUTPUT_H
#define PEL_DRIVERS_DISPLAY_LINUX_DRM_OUTPUT_H

#include "display_linux_drm.h"

PEL_BEGIN_DECLS

/* Sets connector, crtc and mode: the first connected output, its preferred mode
 * (the first one where none is), the CRTC that feeds it, or one that can. 0 or
 * an errno, with the message, which names `path`. */
int pel_drm_find_output(struct pel_display_drm *drm, const char *path);
PEL_END_DECLS
#endif
