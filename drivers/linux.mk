# The Linux drivers and the thread pool, for the programs that use them. DRM is
# in where pkg-config finds libdrm, so are input devices with libevdev and GPIO
# lines with libgpiod, whose versions 1 and 2 have a file each.
PKG_CONFIG ?= pkg-config
linux_has = $(shell $(PKG_CONFIG) --exists '$(1)' 2>/dev/null && echo yes)
LINUX_EVDEV := $(if $(call linux_has,libevdev),libevdev)
LINUX_GPIO := $(if $(call linux_has,libgpiod),libgpiod)
LINUX_GPIO_VERSION := $(if $(LINUX_GPIO),$(if \
    $(call linux_has,libgpiod >= 2),v2,v1),none)
LINUX_SOURCES := $(filter-out %/evdev.c %/evdev_none.c %/gpio.c %/gpio_v1.c \
                   %/gpio_v2.c %/gpio_none.c,$(wildcard port/linux/*.c)) \
    port/linux/evdev$(if $(LINUX_EVDEV),,_none).c \
    port/linux/gpio_$(LINUX_GPIO_VERSION).c \
    $(if $(LINUX_GPIO),port/linux/gpio.c) \
    $(wildcard drivers/panel*.c) \
    drivers/input.c drivers/input_button.c drivers/input_encoder.c \
    $(filter-out drivers/display_linux_drm%, \
                 $(wildcard drivers/display_linux*.c)) \
    $(wildcard drivers/console_linux*.c) drivers/linux_message.c drivers/dirty.c
LINUX_FLAGS := -D_GNU_SOURCE
LINUX_LIBS := -pthread
ifeq ($(shell $(PKG_CONFIG) --exists libdrm 2>/dev/null && echo yes),yes)
LINUX_SOURCES += $(wildcard drivers/display_linux_drm*.c)
LINUX_FLAGS += -DPEL_WITH_DRM=1 \
    $(patsubst -I%,-isystem %,$(shell $(PKG_CONFIG) --cflags libdrm))
LINUX_LIBS += $(shell $(PKG_CONFIG) --libs libdrm)
else
LINUX_FLAGS += -DPEL_WITH_DRM=0
endif
ifneq ($(LINUX_EVDEV)$(LINUX_GPIO),)
LINUX_FLAGS += $(LINUX_EVDEV:%=-DHAVE_LIBEVDEV) $(LINUX_GPIO:%=-DHAVE_LIBGPIOD) \
    $(patsubst -I%,-isystem %,\
    $(shell $(PKG_CONFIG) --cflags $(LINUX_EVDEV) $(LINUX_GPIO)))
LINUX_LIBS += $(shell $(PKG_CONFIG) --libs $(LINUX_EVDEV) $(LINUX_GPIO))
endif
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

-include $(LINUX_OBJECTS:.o=.d)
