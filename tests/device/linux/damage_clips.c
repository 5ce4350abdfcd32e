/* A kernel module for tests: gives the planes of the display card the property
 * FB_DAMAGE_CLIPS. The driver of cirrus gives it itself from Linux 6.4 on, and
 * has copied no more than the damage before. */
#include <drm/drm_damage_helper.h>
#include <drm/drm_device.h>
#include <drm/drm_plane.h>
#include <linux/module.h>
#include <linux/pci.h>

static int __init damage_clips_init(void)
{
    struct pci_dev *card = pci_get_class(PCI_CLASS_DISPLAY_VGA << 8, NULL);
    struct drm_device *drm = card ? pci_get_drvdata(card) : NULL;
    struct drm_plane *plane;
    pci_dev_put(card);
    if (!drm)
        return -ENODEV;
    drm->registered = false; /* or the kernel warns of a late property */
    drm_for_each_plane(plane, drm) drm_plane_enable_fb_damage_clips(plane);
    drm->registered = true;
    return 0;
}
module_init(damage_clips_init);

MODULE_LICENSE("Dual MIT/GPL");
