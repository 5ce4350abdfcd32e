# The Linux drivers and the thread pool, for the programs that use them. DRM is
# in where pkg-config finds libdrm, so are input devices with libevdev and GPIO
# lines with libgpiod, whose versions 1 and 2 have a file each.
PKG_CONFIG ?= pkg-config
linux_has = $(shell $(PKG_CONFIG) --exists '$(1)' 2>/dev/null && echo $(1))
LINUX_DRM := $(call linux_has,libdrm)
LINUX_EVDEV := $(call linux_has,libevdev)
LINUX_GPIO := $(call linux_has,libgpiod)
LINUX_PACKAGES := $(strip $(LINUX_DRM) $(LINUX_EVDEV) $(LINUX_GPIO))
LINUX_GPIO_VERSION := $(if $(LINUX_GPIO),$(if \
    $(call linux_has,libgpiod >= 2),v2,v1),none)
LINUX_SOURCES := $(DRIVERS) $(filter-out $(if \
    $(LINUX_DRM),,drivers/display_linux_drm%),$(wildcard drivers/*linux*.c)) \
    $(filter-out %/evdev.c %/evdev_none.c %/gpio.c %/gpio_v1.c \
                 %/gpio_v2.c %/gpio_none.c,$(wildcard port/linux/*.c)) \
    port/linux/evdev$(if $(LINUX_EVDEV),,_none).c \
    port/linux/gpio_$(LINUX_GPIO_VERSION).c $(if $(LINUX_GPIO),port/linux/gpio.c)
LINUX_DEFINES := -D_GNU_SOURCE -DPEL_WITH_DRM=$(if $(LINUX_DRM),1,0) \
    $(LINUX_EVDEV:%=-DHAVE_LIBEVDEV) $(LINUX_GPIO:%=-DHAVE_LIBGPIOD)
LINUX_FLAGS := $(LINUX_DEFINES) $(if $(LINUX_PACKAGES),$(patsubst \
    -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags $(LINUX_PACKAGES))))
LINUX_LIBS := -pthread \
    $(if $(LINUX_PACKAGES),$(shell $(PKG_CONFIG) --libs $(LINUX_PACKAGES)))
LINUX_OBJECTS := $(LINUX_SOURCES:%.c=$(BUILD)/%.o)

# -pthread belongs to the compiler too.
$(LINUX_OBJECTS): $(BUILD)/%.o: %.c $(BUILD)/linux-flags
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(LINUX_FLAGS) -pthread $(CFLAGS) -c $< -o $@

$(BUILD)/linux-flags: FORCE
	@mkdir -p $(@D)
	@echo '$(LINUX_FLAGS)' | cmp -s - $@ || echo '$(LINUX_FLAGS)' >$@

# For programs of others, with what they link beside it.
all: $(BUILD)/libpel_linux.a
$(BUILD)/libpel_linux.a: $(LINUX_OBJECTS)
	rm -f $@
	$(AR) rcs $@ $^
	@echo '$(LINUX_FLAGS) $(LINUX_LIBS)' >$(@:.a=.libs)
	@echo '$(LINUX_DEFINES)' >$(@:.a=.flags)
	@echo '$(LINUX_PACKAGES)' >$(@:.a=.packages)

-include $(LINUX_OBJECTS:.o=.d)

# An example whose panel is this machine's screen, without a desktop.
.PHONY: device
device: $(BUILD)/device/$(or $(EXAMPLE),kiosk) ## an example on /dev/fb0 or a DRM device: EXAMPLE=kiosk
	$<
$(BUILD)/device/%: examples/%.c examples/linux.h $(BUILD)/libpel_linux.a \
    $(BUILD)/libpel.a $(BUILD)/examples/%
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) $(LINUX_FLAGS) -I$(BUILD)/examples $(CFLAGS) \
	    '-DPANEL_HEADER="linux.h"' $(call example_sources,$*) \
	    $(BUILD)/libpel_linux.a $(BUILD)/libpel.a $(LINUX_LIBS) -o $@
