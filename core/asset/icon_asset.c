#include "icon_asset.h"

/* Do parts and gradients take no more than there is? */
static bool fits(const struct pel_icon_asset *icon)
{
    uint32_t verbs = 0, points = 0, i;
    for (i = 0; i < icon->parts; i++) {
        const struct pel_icon_part *const part = &icon->part[i];
        verbs += part->verbs;
        points += part->points;
        if (part->kind > PEL_ICON_STROKE ||
            (part->kind == PEL_ICON_STROKE && !icon->strokes) ||
            (part->gradient < PEL_ICON_PROGRAM &&
             part->gradient >= icon->gradients))
            return false;
    }
    for (i = 0; i < icon->gradients; i++)
        if (icon->gradient[i].stops == 0 ||
            icon->gradient[i].stop + icon->gradient[i].stops > icon->stops)
            return false;
    return verbs <= icon->verbs && points <= icon->points;
}

enum pel_status pel_icon_asset_check(const struct pel_icon_asset *icon)
{
    if (!icon || !icon->part || !icon->verb || !icon->point ||
        (icon->gradients > 0 &&
         (!icon->gradient || !icon->stop || !icon->painter)))
        return PEL_ERROR_NULL;
    if (icon->magic != PEL_ICON_MAGIC || icon->version != PEL_ICON_VERSION)
        return PEL_ERROR_RANGE;
    return icon->width == 0 || icon->width > 32767 || icon->height == 0 ||
                   icon->height > 32767 || (icon->width | icon->height) < 256 ||
                   !fits(icon)
               ? PEL_ERROR_SIZE
               : PEL_OK;
}
